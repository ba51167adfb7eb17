// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/SphereArea.h>

namespace osgPMObjects::core
{

double sphereAreaPx(const SelectionView& view, const BoundingSphere& sphere)
{
    const glm::dvec3 centre = sphere.centre - view.eyeWorld;
    const double depth = glm::dot(view.forward, centre);
    if (depth - sphere.radius < view.nearM) return kFullArea;
    const double r2 = sphere.radius * sphere.radius;
    const double depth2 = depth * depth - r2;
    return std::numbers::pi * view.pixelsPerTangentArea * r2 *
           std::sqrt((glm::dot(centre, centre) - r2) / depth2) / depth2;
}

} // namespace osgPMObjects::core
