// SPDX-License-Identifier: Apache-2.0
// The mesh follows edits of its tile: moved vertices are written again, and vertices with changed bounds are
// checked in the next refinement.
#include <osgTerrainROAM/core/roam/RoamMesh.h>

namespace osgTerrainROAM::core
{

/// The other drivers ask all bounds anew.
void RoamMesh::recheck(GridPoint p)
{
    if (_driver == Driver::wheel) _wheel.recheck(p);
}

void RoamMesh::followTile()
{
    if (!isBehind()) return;
    const auto changes = tile().changesSince(_revision);
    _revision = tile().revision();
    if (patchExponent() > 0) _tree.setBounds(_tree.bounds().remade());
    if (!changes || patchExponent() > 0) _wheel.forget();
    _queues.recheck();
    if (!changes) return followAll();
    for (const TileChange* change : *changes)
    {
        for (const GridPoint v : change->vertices)
            recheck(v);
        for (const GridRect& rect : change->moved)
        {
            if (_patches)
                _moved.push_back(rect);
            else
                followMoved(rect);
        }
    }
}

void RoamMesh::followMoved(const GridRect& rect)
{
    _tree.forEachIn(rect,
                    [&](VertexSlot v, TriangleId leaf)
                    {
                        if (v != kNone)
                        {
                            _tree.noteMoved(v);
                            if (v >= DiamondTree::kCorners) recheck(_tree.place(v).point());
                            return;
                        }
                        if (!_tree.canSplit(leaf)) return;
                        const GridPoint mid = _tree.middle(leaf);
                        if (rect.holds(mid.column, mid.row)) recheck(mid);
                    });
}

/// Follows when the list of changes is incomplete: everything may have changed.
void RoamMesh::followAll()
{
    const int last = tile().tile.grid().side() - 1;
    if (_patches)
        _moved.assign(1, {0, 0, last, last});
    else
        for (VertexSlot v = 0; v < _tree.vertexSlots(); ++v)
            if (!_tree.place(v).isFree()) _tree.noteMoved(v);
}

void RoamMesh::rewritePatches()
{
    for (const GridRect& rect : _moved)
        _tree.forEachIn(rect,
                        [&](VertexSlot, TriangleId leaf)
                        {
                            if (leaf.exists()) _patches->rewrite(_tree, leaf);
                        });
    _moved.clear();
}

} // namespace osgTerrainROAM::core
