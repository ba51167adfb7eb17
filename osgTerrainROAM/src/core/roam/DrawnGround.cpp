// SPDX-License-Identifier: Apache-2.0
// The leaf is found from the place in the sample grid, going down the bintree. On the curved Earth a sample's horizontal
// place depends on its height, so that the line may miss this leaf by a little: from there it is walked over neighbours.
#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

namespace
{

/// How far outside (as a barycentric coordinate) a point may lie and still belong: rounding on shared edges.
constexpr double kEdgeSlack = 1e-9;
constexpr int kMostSteps = 256; ///< over neighbours; relief that hangs over could turn the walk in a circle

struct Corners
{
    glm::dvec3 position[3]; ///< apex, left, right
    glm::dvec2 grid[3];
};

Corners cornersOf(const BinTriangleTree& tree, NodeIndex t)
{
    Corners corners;
    for (int i = 0; i < 3; ++i)
    {
        const MeshVertex& v = tree.vertices()[tree.node(t).vertices[i]];
        corners.position[i] = glm::dvec3(v.positionHigh) + glm::dvec3(v.positionLow);
        corners.grid[i] = v.grid;
    }
    return corners;
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// One cache line a level: where the triangles lie follows from their place in the tree.
NodeIndex leafAt(const BinTriangleTree& tree, int side, const glm::dvec2& grid)
{
    // The roots share the diagonal along which column and row are equal; the first lies south-east of it.
    const std::size_t which = grid.x >= grid.y ? 0 : 1;
    GridTriangle triangle = rootTriangles(side)[which];
    NodeIndex t = BinTriangleTree::kRoots[which];
    while (!tree.node(t).isLeaf())
    {
        const GridPoint mid = middle(triangle.left, triangle.right), apex = triangle.apex;
        const double across =
            (mid.column - apex.column) * (grid.y - apex.row) - (mid.row - apex.row) * (grid.x - apex.column);
        const bool isRight = across > 0.0; // on the right corner's side of the line from apex to middle
        triangle = isRight ? GridTriangle{mid, triangle.right, apex} : GridTriangle{mid, apex, triangle.left};
        t = tree.node(t).firstChild + (isRight ? 1 : 0);
    }
    return t;
}

/// Of a horizontal place in the triangle's own projection.
glm::dvec3 barycentric(const Corners& c, const glm::dvec2& place)
{
    const glm::dvec2 a(c.position[0]), toLeft = glm::dvec2(c.position[1]) - a,
                                       toRight = glm::dvec2(c.position[2]) - a;
    const double area = cross(toLeft, toRight);
    const double left = cross(place - a, toRight) / area, right = cross(toLeft, place - a) / area;
    return {1.0 - left - right, left, right};
}

/// Across the edge that a place lies beyond the farthest.
NodeIndex towards(const BinTriangle& node, const glm::dvec3& weights)
{
    if (weights.x <= weights.y && weights.x <= weights.z) return node.base;
    return weights.y <= weights.z ? node.right : node.left;
}

} // namespace

std::optional<DrawnGround> drawnGroundAt(const PlacedTile& tile, const BinTriangleTree& tree, double eastM,
                                         double northM)
{
    const glm::dvec2 place(eastM, northM);
    const glm::dvec2 grid(tile.gridAt({eastM, northM, 0.0}));
    if (!std::isfinite(grid.x) || !std::isfinite(grid.y)) return std::nullopt;
    NodeIndex t = leafAt(tree, tile.side(), grid);
    for (int step = 0; step < kMostSteps && t != kNone; ++step)
    {
        const Corners c = cornersOf(tree, t);
        const glm::dvec3 w = barycentric(c, place);
        if (!(std::min({w.x, w.y, w.z}) >= -kEdgeSlack))
        {
            t = towards(tree.node(t), w);
            continue;
        }
        const glm::dvec2 at = w.x * c.grid[0] + w.y * c.grid[1] + w.z * c.grid[2];
        if (at.x > tile.dataColumns() - 1 + kEdgeSlack || at.y > tile.dataRows() - 1 + kEdgeSlack)
            return std::nullopt;
        const double z = w.x * c.position[0].z + w.y * c.position[1].z + w.z * c.position[2].z;
        const glm::dvec3 normal =
            glm::normalize(glm::cross(c.position[1] - c.position[0], c.position[2] - c.position[0]));
        const BinTriangle& leaf = tree.node(t);
        return DrawnGround{{place, z}, normal, leaf.splitSample == kNone ? 0.0 : leaf.bound.errorM, t};
    }
    return std::nullopt;
}

} // namespace osgTerrainROAM::core
