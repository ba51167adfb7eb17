// SPDX-License-Identifier: Apache-2.0
// Finds the leaf by descending the bintree to the position in the sample grid. On the curved Earth a sample's
// horizontal position depends on its height, so the vertical line may miss this leaf by a little: a walk over
// neighbours corrects it.
#include <algorithm>
#include <array>
#include <cmath>

#include <osgTerrainROAM/core/heightfield/VerticalHit.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/Outline.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kMostNeighbourSteps =
    256; ///< over neighbours; relief that hangs over could turn the walk in a circle

VerticalHit meet(const DiamondTree& tree, TriangleId t, const glm::dvec2& place)
{
    std::array<glm::dvec3, 3> positions;
    std::array<glm::dvec2, 3> grid;
    const LeafTriangle corners = tree.vertices(t);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const GridPoint p = tree.place(corners.vertices[i]).point();
        positions[i] = tree.position(corners.vertices[i]);
        grid[i] = glm::dvec2(p.column, p.row);
    }
    return verticalHit(positions, grid, place);
}

/// Whether a grid position lies on the right corner's side of the line from the apex to the middle of the
/// base.
bool isOnTheRight(GridPoint apex, GridPoint mid, const glm::dvec2& grid)
{
    return (mid.column - apex.column) * (grid.y - apex.row) - (mid.row - apex.row) * (grid.x - apex.column) >
           0.0;
}

/// A descent of the tree to the leaf at a grid position.
struct Descent
{
    glm::dvec2 grid{0.0};
    TriangleId triangle;

    Descent() = default;
    explicit Descent(const glm::dvec2& gridPlace) : grid(gridPlace)
    {
        // The roots share the diagonal along which column and row are equal; the first lies south-east of it.
        if (std::isfinite(grid.x) && std::isfinite(grid.y))
            triangle = DiamondTree::kRoots[grid.x >= grid.y ? 0 : 1];
    }
    Descent(const DiamondTree& tree, const glm::dvec2& local)
        : Descent(tree.tile().tile.frame().gridNear(local))
    {
    }

    bool isDone(const DiamondTree& tree) const { return !triangle.exists() || tree.isLeaf(triangle); }

    void step(const DiamondTree& tree)
    {
        const GridPoint mid = tree.place(tree.splitVertex(triangle)).point();
        const GridPoint apex = tree.place(triangle.apex()).point();
        triangle = tree.children(triangle)[isOnTheRight(apex, mid, grid) ? 1 : 0];
    }
};

/// Returns the neighbour across the edge that a position lies farthest beyond.
TriangleId towards(const DiamondTree& tree, TriangleId t, const glm::dvec3& weights)
{
    if (weights.x <= weights.y && weights.x <= weights.z) return tree.acrossBase(t);
    return tree.acrossLeg(t, weights.y <= weights.z);
}

bool isBeyondData(const PlacedTile& tile, const glm::dvec2& grid)
{
    return grid.x > tile.grid().dataColumns() - 1 + kEdgeSlack ||
           grid.y > tile.grid().dataRows() - 1 + kEdgeSlack;
}

/// Computes how far the true surface may be from a leaf, or from its patch, when none of its vertices is
/// displaced.
double boundM(const DiamondTree& tree, TriangleId leaf)
{
    return tree.canSplit(leaf) ? tree.bounds().errorM(tree.middle(leaf)) : 0.0;
}

/// Walks from the leaf at the grid position to the leaf that the vertical line meets.
std::optional<DrawnGround> onLeaves(const DiamondTree& tree, TriangleId t, const glm::dvec2& place)
{
    for (int step = 0; step < kMostNeighbourSteps && t.exists(); ++step)
    {
        const VerticalHit hit = meet(tree, t, place);
        if (!hit.isInside())
        {
            t = towards(tree, t, hit.barycentric);
            continue;
        }
        const PlacedTile& tile = tree.tile().tile;
        if (isBeyondData(tile, hit.grid)) return std::nullopt;
        if (tile.samples().hasHoles() && !isDrawn(tile, tree.gridTriangle(t))) return std::nullopt;
        double movedM = 0.0;
        for (const VertexSlot v : tree.vertices(t).vertices)
            if (const glm::vec3 moved = tree.displacement(v); moved != glm::vec3(0.0f))
                movedM = std::max<double>(movedM, glm::length(moved));
        return DrawnGround{hit.position, hit.normal, movedM + boundM(tree, t), t};
    }
    return std::nullopt;
}

/// Finds the triangle of a leaf's patch at a grid position.
GridTriangle inPatch(const DiamondTree& tree, const Descent& leaf)
{
    GridTriangle t = tree.gridTriangle(leaf.triangle);
    for (int level = 0; level < tree.bounds().patchExponent(); ++level)
        t = t.children()[isOnTheRight(t.apex, t.middleOfBase(), leaf.grid) ? 1 : 0];
    return t;
}

/// Repeats the descent at the grid position that the plane of a patch triangle gives.
std::optional<DrawnGround> onPatches(const DiamondTree& tree, Descent descent, const glm::dvec2& place)
{
    const PlacedTile& tile = tree.tile().tile;
    const double last = tile.grid().side() - 1;
    for (int step = 0; step < kMostNeighbourSteps && descent.triangle.exists(); ++step)
    {
        const GridTriangle t = inPatch(tree, descent);
        std::array<glm::dvec3, 3> positions;
        std::array<glm::dvec2, 3> grid;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const GridPoint p = i == 0 ? t.apex : i == 1 ? t.left : t.right;
            positions[i] = tile.position(p.column, p.row);
            grid[i] = glm::dvec2(p.column, p.row);
        }
        const VerticalHit hit = verticalHit(positions, grid, place);
        if (hit.isInside())
        {
            if (isBeyondData(tile, hit.grid)) return std::nullopt;
            return DrawnGround{hit.position, hit.normal, boundM(tree, descent.triangle), descent.triangle};
        }
        if (std::min(hit.grid.x, hit.grid.y) < -1.0 || std::max(hit.grid.x, hit.grid.y) > last + 1.0)
            return std::nullopt;
        descent = Descent(hit.grid);
        while (!descent.isDone(tree))
            descent.step(tree);
    }
    return std::nullopt;
}

std::optional<DrawnGround> groundFrom(const DiamondTree& tree, const Descent& descent,
                                      const glm::dvec2& place)
{
    if (tree.bounds().patchExponent() > 0) return onPatches(tree, descent, place);
    return onLeaves(tree, descent.triangle, place);
}

} // namespace

std::optional<DrawnGround> drawnGroundAt(const DiamondTree& tree, double eastM, double northM)
{
    Descent descent(tree, {eastM, northM});
    while (!descent.isDone(tree))
        descent.step(tree);
    return groundFrom(tree, descent, {eastM, northM});
}

void drawnGroundAt(const DiamondTree& tree, std::span<const glm::dvec2> places,
                   std::span<std::optional<DrawnGround>> grounds)
{
    constexpr std::size_t kTogether = 8;
    std::array<Descent, kTogether> descents;
    for (std::size_t first = 0; first < places.size(); first += kTogether)
    {
        const std::size_t count = std::min(kTogether, places.size() - first);
        for (std::size_t i = 0; i < count; ++i)
            descents[i] = Descent(tree, places[first + i]);
        for (bool anyLeft = true; anyLeft;)
        {
            anyLeft = false;
            for (std::size_t i = 0; i < count; ++i)
            {
                if (descents[i].isDone(tree)) continue;
                descents[i].step(tree);
                anyLeft = true;
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            grounds[first + i] = groundFrom(tree, descents[i], places[first + i]);
    }
}

} // namespace osgTerrainROAM::core
