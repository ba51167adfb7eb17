// SPDX-License-Identifier: Apache-2.0
// enhMerge, paper 1, §5.2. The paper descends from each merged triangle to its neighbours at once. Here they wait their
// turn, coarser ones first: then everything coarser than a triangle has its final neighbours when the triangle's turn
// comes, and no way around a corner leads into a subtree that is gone already. docs/decisions/0009.
#include <cassert>
#include <utility>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>

namespace osgTerrainROAM::core
{

std::uint32_t BinTriangleTree::enhMerge(NodeIndex t)
{
    assert(!_nodes[t].isLeaf());
    _collapsing.assign(1, t);
    if (_nodes[t].base != kNone) _collapsing.push_back(_nodes[t].base);
    std::uint32_t merges = 0;
    for (std::size_t next = 0; next < _collapsing.size(); ++next) // in the order of levels
    {
        const NodeIndex waiting = _collapsing[next];
        const NodeIndex parent = _nodes[waiting].parent;
        const bool isGone = parent != kNone && _nodes[parent].isLeaf(); // with its parent, meanwhile
        if (!isGone) merges += collapse(waiting);
    }
    _collapsing.clear();
    return merges;
}

/// Makes `t` a leaf and queues what stands on its legs. Returns triangles merged.
std::uint32_t BinTriangleTree::collapse(NodeIndex t)
{
    const std::uint32_t leaves = releaseLeaves(t);
    BinTriangle& node = _nodes[t];
    const NodeIndex pair = node.firstChild;
    for (const NodeIndex child : {pair, pair + 1})
    {
        const NodeIndex outside = _nodes[child].base; // across a leg of t
        (child == pair ? node.left : node.right) = outside;
        const bool losesItsMiddle = outside != kNone && !_nodes[child].isLeaf() && !_nodes[outside].isLeaf();
        if (losesItsMiddle) _collapsing.push_back(outside);
        replaceNeighbour(outside, child, t);
    }
    node.firstChild = kNone;
    _deadPairs.push_back(pair);
    insertLeaf(t);
    return leaves - 1;
}

/// Takes all leaves below the split triangle `t` out of what is drawn: whole regions at once where it is larger than
/// they are. Returns their number.
std::uint32_t BinTriangleTree::releaseLeaves(NodeIndex t)
{
    const BinTriangle& node = _nodes[t];
    if (node.level == _regionLevel)
    {
        const std::uint32_t region = regionOf(node);
        const std::uint32_t leaves = _leaves.clear(region) + std::exchange(_undrawnLeaves[region], 0u);
        _leafCount -= leaves;
        return leaves;
    }
    if (node.isLeaf())
    {
        eraseLeaf(t);
        return 1;
    }
    return releaseLeaves(node.firstChild) + releaseLeaves(node.firstChild + 1);
}

/// Puts one of the pairs that enhMerge() cut off on the free list, and those below it among the dead.
void BinTriangleTree::dismantleOne()
{
    const NodeIndex pair = _deadPairs.back();
    _deadPairs.pop_back();
    for (const NodeIndex child : {pair, pair + 1})
        if (!_nodes[child].isLeaf()) _deadPairs.push_back(_nodes[child].firstChild);
    if (_nodes[pair].freesApex) _freeVertices.push_back(_nodes[pair].vertices[0]);
    _freePairs.push_back(pair);
}

void BinTriangleTree::countUndismantled(std::size_t& pairs, std::size_t& vertices) const
{
    std::vector<NodeIndex> open = _deadPairs;
    while (!open.empty())
    {
        const NodeIndex pair = open.back();
        open.pop_back();
        ++pairs;
        vertices += _nodes[pair].freesApex ? 1 : 0;
        for (const NodeIndex child : {pair, pair + 1})
            if (!_nodes[child].isLeaf()) open.push_back(_nodes[child].firstChild);
    }
}

} // namespace osgTerrainROAM::core
