// SPDX-License-Identifier: Apache-2.0
// The drawn leaves at the border of the data, found down the bintree.
#include <algorithm>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Descends into the triangles that touch the border of the data.
class BorderSearch
{
public:
    BorderSearch(const DiamondTree& tree, const TerrainMesh::BorderVisit& visit)
        : _tree(tree),
          _visit(visit),
          _lastColumn(tree.tile().tile.grid().dataColumns() - 1),
          _lastRow(tree.tile().tile.grid().dataRows() - 1)
    {
    }

    void descend(TriangleId t, const GridTriangle& g) const
    {
        if (!touchesBorder(g)) return;
        if (_tree.isLeaf(t)) return _visit({g.apex, g.left, g.right}, _tree.vertices(t));
        const auto children = _tree.children(t);
        const auto halves = g.children();
        for (const std::size_t half : {0u, 1u})
            descend(children[half], halves[half]);
    }

private:
    bool touchesBorder(const GridTriangle& g) const
    {
        const auto [west, east] = std::minmax({g.apex.column, g.left.column, g.right.column});
        const auto [south, north] = std::minmax({g.apex.row, g.left.row, g.right.row});
        if (west > _lastColumn || south > _lastRow) return false;
        return west == 0 || south == 0 || east >= _lastColumn || north >= _lastRow;
    }

    const DiamondTree& _tree;
    const TerrainMesh::BorderVisit& _visit;
    int _lastColumn, _lastRow;
};

} // namespace

void RoamMesh::forEachTriangleAtBorder(const BorderVisit& visit) const
{
    const BorderSearch search(_tree, visit);
    for (const TriangleId root : DiamondTree::kRoots)
        search.descend(root, _tree.gridTriangle(root));
}

} // namespace osgTerrainROAM::core
