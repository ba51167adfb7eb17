// SPDX-License-Identifier: Apache-2.0
// Searches of the mesh by position in the grid, for following an edit of the tile.
#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

DiamondTree::AtPlace DiamondTree::atPlace(GridPoint p) const
{
    AtPlace found;
    // The search follows both sides of an edge that the point lies on: one child of each level waits.
    std::array<TriangleId, TileGrid::kMostLevels + 3> open = {kRoots[0], kRoots[1]};
    for (std::size_t count = 2; count > 0;)
    {
        const TriangleId t = open[--count];
        if (!gridTriangle(t).holds(p)) continue;
        if (isLeaf(t))
        {
            if (canSplit(t) && middle(t) == p) found.leaves[found.leafCount++] = t;
            continue;
        }
        const VertexSlot v = splitVertex(t);
        if (_places[v].point() == p) return {v, {}, 0};
        for (const TriangleId child : children(t))
            open[count++] = child;
    }
    return found;
}

void DiamondTree::forEachIn(const GridRect& rect,
                            const std::function<void(VertexSlot, TriangleId)>& visit) const
{
    const auto holds = [&](VertexSlot v)
    { return rect.holds(_places[v].point().column, _places[v].point().row); };
    for (VertexSlot corner = 0; corner < kCorners; ++corner)
        if (holds(corner)) visit(corner, {});
    std::vector<TriangleId> open(std::begin(kRoots), std::end(kRoots));
    while (!open.empty())
    {
        const TriangleId t = open.back();
        open.pop_back();
        if (gridTriangle(t).extent().cutTo(rect).isEmpty()) continue;
        if (isLeaf(t))
        {
            visit(kNone, t);
            continue;
        }
        const VertexSlot v = splitVertex(t);
        // One of the two triangles that it has split visits it.
        if (holds(v) && parents(v)[0] == t) visit(v, {});
        for (const TriangleId child : children(t))
            open.push_back(child);
    }
}

} // namespace osgTerrainROAM::core
