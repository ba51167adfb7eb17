// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/EllipsoidArea.h>

namespace osgPMObjects::core
{

double ellipsoidAreaPx(const SelectionView& view, const Ellipsoid& ellipsoid)
{
    const glm::dmat3& a = ellipsoid.halfAxes;
    const glm::dvec3 centre = ellipsoid.centre - view.eyeWorld;
    const double depth = glm::dot(view.forward, centre);
    const glm::dvec3 along = view.forward * a; // depths of the half axes
    const double reach2 = glm::dot(along, along);
    if (depth - std::sqrt(reach2) < view.nearM) return kFullArea;

    const glm::dvec3 yz = glm::cross(a[1], a[2]);
    const glm::dvec3 adjugate{glm::dot(yz, centre), glm::dot(glm::cross(a[2], a[0]), centre),
                              glm::dot(glm::cross(a[0], a[1]), centre)};
    const double volume = glm::dot(yz, a[0]);
    const double across2 = std::max(0.0, glm::dot(adjugate, adjugate) - volume * volume);
    const double depth2 = depth * depth - reach2;
    return std::numbers::pi * view.pixelsPerTangentArea * std::sqrt(across2 / depth2) / depth2;
}

} // namespace osgPMObjects::core
