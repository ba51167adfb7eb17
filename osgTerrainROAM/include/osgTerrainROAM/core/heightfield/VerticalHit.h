// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// Tolerance of barycentric coordinates on shared edges, for rounding.
inline constexpr double kEdgeSlack = 1e-9;

/// The intersection of a vertical line with the plane of a triangle. Frame: the tile's.
struct VerticalHit
{
    glm::dvec3 barycentric;
    glm::dvec3 position;
    glm::dvec3 normal; ///< unit length, pointing up
    glm::dvec2 grid;   ///< grid coordinates, by this triangle's linear map

    bool isInside() const { return std::min({barycentric.x, barycentric.y, barycentric.z}) >= -kEdgeSlack; }
};

/// Intersects. `p`: positions of the corners; `g`: their grid coordinates; `target`: the line's east and
/// north.
inline VerticalHit verticalHit(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& g,
                               const glm::dvec2& target)
{
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const glm::dvec2 d = target - glm::dvec2(p[0]);
    const double area = e1.x * e2.y - e1.y * e2.x;
    const double b1 = (d.x * e2.y - d.y * e2.x) / area;
    const double b2 = (e1.x * d.y - e1.y * d.x) / area;
    const glm::dvec3 normal = glm::normalize(glm::cross(e1, e2));
    return {{1.0 - b1 - b2, b1, b2},
            {target, p[0].z + b1 * e1.z + b2 * e2.z},
            normal.z < 0.0 ? -normal : normal,
            g[0] + b1 * (g[1] - g[0]) + b2 * (g[2] - g[0])};
}

} // namespace osgTerrainROAM::core
