// SPDX-License-Identifier: Apache-2.0
// The light does not change across an edge of the mesh, whatever the levels on either side: the shader reads
// the normal from a map of all samples, at the grid position that it interpolates over a triangle.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "material/NormalMap.h"

namespace
{

using namespace osgTerrainROAM;

/// As a graphics card filters the map.
glm::dvec3 normalAt(const osg::Image& map, const glm::dvec2& grid)
{
    const int x = std::clamp(static_cast<int>(grid.x), 0, map.s() - 2);
    const int y = std::clamp(static_cast<int>(grid.y), 0, map.t() - 2);
    const double u = grid.x - x, v = grid.y - y;
    const glm::dvec2 tilt = (1 - v) * ((1 - u) * tiltAt(map, x, y) + u * tiltAt(map, x + 1, y)) +
                            v * ((1 - u) * tiltAt(map, x, y + 1) + u * tiltAt(map, x + 1, y + 1));
    return glm::normalize(glm::dvec3(tilt, std::sqrt(std::max(1.0 - glm::dot(tilt, tilt), 0.0))));
}

/// What both sides of an edge show just beside it: by the map, and by the triangles themselves.
struct Side
{
    glm::dvec3 mapped, flat;
    double area;
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::multimap<Edge, Side> sidesOf(const core::DrawnMesh& mesh, const osg::Image& map)
{
    constexpr double kBeside = 1e-6;
    std::multimap<Edge, Side> sides;
    for (const core::LeafTriangle& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
        {
            const std::uint32_t a = t.vertices[i], b = t.vertices[(i + 1) % 3], c = t.vertices[(i + 2) % 3];
            const auto grid = [&](std::uint32_t v)
            { return glm::dvec2(mesh.grid[v].column, mesh.grid[v].row); };
            const auto place = [&](std::uint32_t v) { return mesh.position(v); };
            const glm::dvec2 beside = (0.5 - kBeside) * (grid(a) + grid(b)) + 2.0 * kBeside * grid(c);
            const glm::dvec3 across = glm::cross(place(b) - place(a), place(c) - place(a));
            sides.insert(
                {std::minmax(a, b), {normalAt(map, beside), glm::normalize(across), glm::length(across)}});
        }
    return sides;
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::acos(std::min(glm::dot(a, b), 1.0)));
}

TEST(NormalContinuity, HoldsAcrossTheBordersOfLevels)
{
    const auto tile = testsupport::planarTile(testsupport::hills(129, 129));
    core::RoamMesh mesh(tile);
    mesh.refine(15.0);
    const auto map = normalMap(tile->tile, MapGrid(tile->tile));
    const auto sides = sidesOf(mesh.drawn(), *map);
    double largest = 0.0, largestOfFlat = 0.0;
    int levelBorders = 0;
    for (auto side = sides.begin(); side != sides.end(); side = sides.upper_bound(side->first))
    {
        if (sides.count(side->first) < 2) continue; // the tile's border
        const Side &one = side->second, &other = std::next(side)->second;
        largest = std::max(largest, degreesBetween(one.mapped, other.mapped));
        largestOfFlat = std::max(largestOfFlat, degreesBetween(one.flat, other.flat));
        levelBorders += std::max(one.area, other.area) > 1.4 * std::min(one.area, other.area) ? 1 : 0;
    }
    EXPECT_LT(largest, 0.01);
    EXPECT_GT(levelBorders, 100) << "no two levels met";
    EXPECT_GT(largestOfFlat, 10.0) << "the triangles' own normals would do: nothing was tested";
}

} // namespace
