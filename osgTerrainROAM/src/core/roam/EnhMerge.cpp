// SPDX-License-Identifier: Apache-2.0
// enhMerge, paper 1, §5.2. The paper descends from each merged triangle to its neighbours at once. Here they wait their
// turn, coarser ones first: then everything coarser than a triangle has its final neighbours when the triangle's turn
// comes, and no way around a corner leads into a subtree that is gone already. docs/decisions/0009.
#include <cassert>
#include <utility>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

std::uint32_t DiamondTree::enhMerge(VertexSlot v)
{
    assert(v >= kCorners && !_places[v].isFree());
    for (const TriangleId t : parents(v))
        if (t.exists()) _collapsing.push_back(t);
    std::uint32_t merges = 0;
    for (std::size_t next = 0; next < _collapsing.size(); ++next) // in the order of levels
    {
        const TriangleId waiting = _collapsing[next];
        const bool isGone =
            _places[waiting.apex()].isFree() || isLeaf(waiting); // with a coarser one, meanwhile
        if (!isGone) merges += collapse(waiting);
    }
    _collapsing.clear();
    return merges;
}

/// Makes `t` a leaf and queues what stands on its legs. Returns triangles merged.
std::uint32_t DiamondTree::collapse(TriangleId t)
{
    for (const TriangleId child : children(t))
    {
        if (isLeaf(child)) continue;
        for (const TriangleId half : parents(splitVertex(child))) // the base of a half is a leg of t
            if (half.exists() && half != child) _collapsing.push_back(half);
    }
    const std::uint32_t leaves = dismantle(t);
    addLeaf(t);
    return leaves - 1;
}

/// Takes everything below the split triangle `t` out: leaves by whole regions where it is larger than they are. Returns
/// the number of leaves.
std::uint32_t DiamondTree::dismantle(TriangleId t)
{
    if (level(t) == _regionLevel)
    {
        const std::uint32_t region = regionOf(t);
        const std::uint32_t leaves = _leaves.clear(region) + std::exchange(_undrawnLeaves[region], 0u);
        _leafCount -= leaves;
        freeVertices(t);
        return leaves;
    }
    if (isLeaf(t))
    {
        removeLeaf(t);
        return 1;
    }
    const auto [first, second] = children(t);
    if (const VertexSlot v = splitVertex(t); !_places[v].isFree()) removeVertex(v);
    return dismantle(first) + dismantle(second);
}

/// Frees the vertices below `t`. Each is met from both of its sides; its place and links stay readable until the slot is
/// taken again.
void DiamondTree::freeVertices(TriangleId t)
{
    if (isLeaf(t)) return;
    const auto [first, second] = children(t);
    if (const VertexSlot v = splitVertex(t); !_places[v].isFree()) removeVertex(v);
    freeVertices(first);
    freeVertices(second);
}

} // namespace osgTerrainROAM::core
