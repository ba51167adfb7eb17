// SPDX-License-Identifier: Apache-2.0
// The leaf is found from the place in the sample grid, going down the bintree. On the curved Earth a sample's horizontal
// place depends on its height, so that the line may miss this leaf by a little: from there it is walked over neighbours.
#include <array>
#include <cmath>

#include <osgTerrainROAM/core/heightfield/VerticalHit.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kMostSteps = 256; ///< over neighbours; relief that hangs over could turn the walk in a circle

VerticalHit meet(const DiamondTree& tree, TriangleId t, const glm::dvec2& place)
{
    std::array<glm::dvec3, 3> positions;
    std::array<glm::dvec2, 3> grid;
    const LeafTriangle corners = tree.vertices(t);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const GridPoint p = tree.place(corners.vertices[i]).point();
        positions[i] = tree.tile().tile.position(p.column, p.row);
        grid[i] = glm::dvec2(p.column, p.row);
    }
    return verticalHit(positions, grid, place);
}

TriangleId leafAt(const DiamondTree& tree, int side, const glm::dvec2& grid)
{
    // The roots share the diagonal along which column and row are equal; the first lies south-east of it.
    const std::size_t which = grid.x >= grid.y ? 0 : 1;
    GridTriangle triangle = rootTriangles(side)[which];
    TriangleId t = DiamondTree::kRoots[which];
    while (!tree.isLeaf(t))
    {
        const auto children = triangle.children();
        const GridPoint mid = children[0].apex, apex = triangle.apex;
        const double across =
            (mid.column - apex.column) * (grid.y - apex.row) - (mid.row - apex.row) * (grid.x - apex.column);
        const bool isRight = across > 0.0; // on the right corner's side of the line from apex to middle
        triangle = children[isRight ? 1 : 0];
        t = tree.children(t)[isRight ? 1 : 0];
    }
    return t;
}

/// Across the edge that a place lies beyond the farthest.
TriangleId towards(const DiamondTree& tree, TriangleId t, const glm::dvec3& weights)
{
    if (weights.x <= weights.y && weights.x <= weights.z) return tree.acrossBase(t);
    return tree.acrossLeg(t, weights.y <= weights.z);
}

} // namespace

std::optional<DrawnGround> drawnGroundAt(const DiamondTree& tree, double eastM, double northM)
{
    const PlacedTile& tile = tree.tile().tile;
    const glm::dvec2 place(eastM, northM);
    const glm::dvec2 grid(tile.gridAt({eastM, northM, 0.0}));
    if (!std::isfinite(grid.x) || !std::isfinite(grid.y)) return std::nullopt;
    TriangleId t = leafAt(tree, tile.side(), grid);
    for (int step = 0; step < kMostSteps && t.exists(); ++step)
    {
        const VerticalHit hit = meet(tree, t, place);
        if (!hit.isInside())
        {
            t = towards(tree, t, hit.barycentric);
            continue;
        }
        if (hit.grid.x > tile.dataColumns() - 1 + kEdgeSlack || hit.grid.y > tile.dataRows() - 1 + kEdgeSlack)
            return std::nullopt;
        const double boundM = tree.canSplit(t) ? tree.bound(t).errorM : 0.0;
        return DrawnGround{hit.position, hit.normal, boundM, t};
    }
    return std::nullopt;
}

} // namespace osgTerrainROAM::core
