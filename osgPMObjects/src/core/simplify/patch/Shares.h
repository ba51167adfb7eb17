// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

/// Returns the barycentric coordinates of a point's projection into a triangle's plane; (1, 0, 0) for one
/// without area.
inline glm::dvec3 sharesOf(const glm::dvec3& p, const std::array<glm::dvec3, 3>& corners)
{
    const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0], ap = p - corners[0];
    const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
    const double determinant = bb * cc - bc * bc;
    if (!(determinant > 0.0)) return {1.0, 0.0, 0.0};
    const double pb = glm::dot(ap, ab), pc = glm::dot(ap, ac);
    const double v = (cc * pb - bc * pc) / determinant, w = (bb * pc - bc * pb) / determinant;
    return {1.0 - v - w, v, w};
}

/// Interpolates wedges by barycentric coordinates; the normal is not normalised.
inline Wedge mixtureOf(const std::array<Wedge, 3>& wedges, const glm::dvec3& shares)
{
    const glm::vec3 s(shares);
    Wedge mixed{wedges[0].position,
                s.x * wedges[0].normal + s.y * wedges[1].normal + s.z * wedges[2].normal,
                {},
                s.x * wedges[0].colour + s.y * wedges[1].colour + s.z * wedges[2].colour};
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        mixed.texCoords[set] =
            s.x * wedges[0].texCoords[set] + s.y * wedges[1].texCoords[set] + s.z * wedges[2].texCoords[set];
    return mixed;
}

} // namespace osgPMObjects::core
