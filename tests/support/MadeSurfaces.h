// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include <osgTerrainROAM/core/bisection/BisectionSurface.h>

namespace testsupport
{

/// Bumps that depend on the place alone.
inline double bumpsAt(const glm::dvec3& p)
{
    return std::sin(5.0 * p.x + 1.0) * std::cos(4.0 * p.y) + 0.5 * std::sin(11.0 * p.z + 7.0 * p.x) +
           0.25 * std::cos(23.0 * p.y - 17.0 * p.z);
}

/// A cube blown up to a sphere of radius 1 with mountains.
inline osgTerrainROAM::core::BisectionSurface madeSphere(int levels)
{
    return {osgTerrainROAM::core::cubeMesh(), levels, [](const glm::dvec3& p) {
                return glm::normalize(p) * (1.0 + 0.05 * bumpsAt(glm::normalize(p)));
            }};
}

/// A TIN of a few triangles of all shapes, with a hole in it and hills on it.
inline osgTerrainROAM::core::BisectionSurface madeTin(int levels)
{
    std::vector<glm::dvec3> points{{0, 0, 0},       {1.3, -0.1, 0.1}, {2, 0.2, 0},
                                   {0.1, 0.9, 0.2}, {0.9, 0.8, 0},    {2.1, 1.1, 0},
                                   {-0.2, 2, 0},    {1.1, 2.2, 0},    {1.9, 2, 0.3}};
    auto mesh = osgTerrainROAM::core::CoarseMesh::make(
        std::move(points), {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}},
        "the TIN");
    return {std::move(*mesh), levels,
            [](const glm::dvec3& p) { return p + glm::dvec3(0.0, 0.0, 0.04 * bumpsAt(p)); }};
}

/// Ground, a cliff that leans over it, and the plateau above: at some places three heights. Rough in all
/// directions.
inline osgTerrainROAM::core::BisectionSurface madeOverhang(int levels)
{
    const double profile[][2] = {{-2, 0}, {0, 0.05}, {0.4, 0.3}, {-0.3, 1.0}, {0.1, 1.3}, {2, 1.4}};
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t row = 0; row < 6; ++row)
        for (std::uint32_t column = 0; column < 4; ++column)
        {
            points.emplace_back(profile[row][0], 1.2 * column, profile[row][1]);
            const std::uint32_t at = 4 * row + column;
            if (row < 5 && column < 3) faces.push_back({at, at + 4, at + 5, at + 1});
        }
    auto mesh = osgTerrainROAM::core::CoarseMesh::make(std::move(points), faces, "the cliff");
    return {std::move(*mesh), levels, [](const glm::dvec3& p) {
                return p + 0.03 * glm::dvec3(bumpsAt(p), 0.5 * bumpsAt({p.z, p.x, p.y}),
                                             bumpsAt({p.y, p.z, p.x}));
            }};
}

} // namespace testsupport
