// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/FacingArea.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the unit directions from the centre of a cube to its faces, edges and corners.
std::array<glm::dvec3, FacingBins::kBins> directions()
{
    std::array<glm::dvec3, FacingBins::kBins> all;
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) all[count++] = glm::normalize(glm::dvec3(x, y, z));
    return all;
}

} // namespace

FacingBins facingBinsOf(const Mesh& mesh, const glm::dmat3& axes)
{
    const auto toBins = directions();
    std::array<glm::dvec3, FacingBins::kBins> areas{};
    for (const Face& face : mesh.faces)
    {
        const glm::dvec3& corner = mesh.at(face, 0);
        const glm::dvec3 area = 0.5 * glm::cross(mesh.at(face, 1) - corner, mesh.at(face, 2) - corner) * axes;
        const auto nearest = std::max_element(toBins.begin(), toBins.end(),
                                              [&](const glm::dvec3& a, const glm::dvec3& b)
                                              { return glm::dot(a, area) < glm::dot(b, area); });
        areas[static_cast<std::size_t>(nearest - toBins.begin())] += area;
    }
    FacingBins bins;
    std::copy(areas.begin(), areas.end(), bins.areas.begin());
    return bins;
}

double facingAreaPx(const SelectionView& view, const BoundingSphere& sphere, const FacingBins& bins,
                    const glm::dmat3& axes, double metresPerUnit)
{
    const glm::dvec3 toEye = view.eyeWorld - sphere.centre;
    const double distance2 = glm::dot(toEye, toEye);
    const double least = sphere.radius + view.nearM;
    if (distance2 < least * least) return kFullArea;
    const glm::vec3 toEyeLocal(toEye * axes / std::sqrt(distance2));
    float seen = 0.0f;
    for (const glm::vec3& area : bins.areas)
        seen += std::max(0.0f, glm::dot(area, toEyeLocal));
    return view.pixelsPerTangentArea * metresPerUnit * metresPerUnit * seen / distance2;
}

} // namespace osgPMObjects::core
