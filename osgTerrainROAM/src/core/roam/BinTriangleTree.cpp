// SPDX-License-Identifier: Apache-2.0
// ROAM's triangle bintree: split, forced split and the merge of diamonds after Duchaineau et al. 1997, §4.
// Differences: an index pool instead of pointers, children in pairs, vertices shared through slots, and each
// node keeps the error bound of its split vertex, so that the walk touches one cache line a triangle.
#include <algorithm>
#include <cassert>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>

namespace osgTerrainROAM::core
{

namespace
{
constexpr int kApex = 0, kLeft = 1, kRight = 2;
}

BinTriangleTree::BinTriangleTree(std::shared_ptr<const RoamTile> tile)
    : _tile(std::move(tile)),
      _regionLevel(_tile->regions.level()),
      _leaves(_tile->regions.regionCount() + 1),
      _undrawnLeaves(_tile->regions.regionCount() + 1)
{
    const int side = _tile->tile.side();
    const auto add = [&](GridPoint p)
    { return addVertex(static_cast<SampleIndex>(p.row * side + p.column)); };
    const auto [first, second] = rootTriangles(side);
    const std::uint32_t apex = add(first.apex), left = add(first.left), right = add(first.right);
    const std::uint32_t corners[2][3] = {{apex, left, right}, {add(second.apex), right, left}};
    takePair();
    for (const NodeIndex root : kRoots)
    {
        BinTriangle& t = _nodes[root];
        std::copy_n(corners[root], 3, t.vertices);
        t.base = 1 - root;
        t.path = static_cast<std::uint16_t>(root);
        completeNode(t);
        insertLeaf(root);
    }
}

NodeIndex BinTriangleTree::takePair()
{
    if (_freePairs.empty() && !_deadPairs.empty()) dismantleOne();
    if (!_freePairs.empty())
    {
        const NodeIndex first = _freePairs.back();
        _freePairs.pop_back();
        return first;
    }
    const auto first = static_cast<NodeIndex>(_nodes.size());
    _nodes.resize(_nodes.size() + 2);
    return first;
}

std::uint32_t BinTriangleTree::addVertex(SampleIndex sample)
{
    std::uint32_t slot;
    while (_freeVertices.empty() && !_deadPairs.empty())
        dismantleOne();
    if (_freeVertices.empty())
    {
        slot = static_cast<std::uint32_t>(_vertices.size());
        _vertices.emplace_back();
        _sampleOfVertex.emplace_back();
    }
    else
    {
        slot = _freeVertices.back();
        _freeVertices.pop_back();
    }
    const auto side = static_cast<SampleIndex>(_tile->tile.side());
    const int column = static_cast<int>(sample % side), row = static_cast<int>(sample / side);
    const glm::dvec3 position = _tile->tile.position(column, row);
    const glm::vec3 high(position);
    _vertices[slot] = {high, glm::vec3(position - glm::dvec3(high)), glm::vec2(column, row)};
    _sampleOfVertex[slot] = sample;
    _changes.vertices.push_back(slot);
    return slot;
}

void BinTriangleTree::completeNode(BinTriangle& t)
{
    if (t.level < _tile->tile.levels())
    {
        // Both coordinates of the ends differ by an even number, so their linear indices have an exact middle.
        t.splitSample = static_cast<SampleIndex>(
            (std::uint64_t{_sampleOfVertex[t.vertices[kLeft]]} + _sampleOfVertex[t.vertices[kRight]]) / 2);
        t.bound = _tile->bound(t.splitSample);
    }
    else
    {
        t.splitSample = kNone;
    }
    t.inData = overlapsData(t);
}

bool BinTriangleTree::overlapsData(const BinTriangle& t) const
{
    const auto side = static_cast<SampleIndex>(_tile->tile.side());
    SampleIndex west = side, south = side;
    for (const std::uint32_t vertex : t.vertices)
    {
        west = std::min(west, _sampleOfVertex[vertex] % side);
        south = std::min(south, _sampleOfVertex[vertex] / side);
    }
    return static_cast<int>(west) < _tile->tile.dataColumns() - 1 &&
           static_cast<int>(south) < _tile->tile.dataRows() - 1;
}

void BinTriangleTree::insertLeaf(NodeIndex t)
{
    const BinTriangle& node = _nodes[t];
    ++_leafCount;
    if (node.inData)
        _leaves.insert(t, regionOf(node), {{node.vertices[0], node.vertices[1], node.vertices[2]}}, _changes);
    else
        ++_undrawnLeaves[regionOf(node)];
}

void BinTriangleTree::eraseLeaf(NodeIndex t)
{
    --_leafCount;
    const BinTriangle& node = _nodes[t];
    if (node.inData)
        _leaves.erase(t, regionOf(node), _changes);
    else
        --_undrawnLeaves[regionOf(node)];
}

void BinTriangleTree::replaceNeighbour(NodeIndex of, NodeIndex from, NodeIndex to)
{
    if (of == kNone) return;
    BinTriangle& node = _nodes[of];
    if (node.base == from)
        node.base = to;
    else if (node.left == from)
        node.left = to;
    else
    {
        assert(node.right == from);
        node.right = to;
    }
}

void BinTriangleTree::splitOne(NodeIndex t, std::uint32_t middle)
{
    eraseLeaf(t);
    const NodeIndex pair = takePair(); // may move the pool: no reference is taken before
    BinTriangle& parent = _nodes[t];
    parent.firstChild = pair;
    const std::uint32_t apex = parent.vertices[kApex];
    const std::uint32_t corners[2][3] = {{middle, apex, parent.vertices[kLeft]},
                                         {middle, parent.vertices[kRight], apex}};
    const NodeIndex outer[2] = {parent.left, parent.right};
    for (int which = 0; which < 2; ++which)
    {
        BinTriangle& child = _nodes[pair + static_cast<NodeIndex>(which)];
        child = BinTriangle{};
        std::copy_n(corners[which], 3, child.vertices);
        child.parent = t;
        child.base = outer[which];
        child.level = static_cast<std::uint8_t>(parent.level + 1);
        child.path =
            child.level <= _regionLevel ? static_cast<std::uint16_t>(2 * parent.path + which) : parent.path;
        completeNode(child);
        replaceNeighbour(outer[which], t, pair + static_cast<NodeIndex>(which));
        insertLeaf(pair + static_cast<NodeIndex>(which));
    }
    _nodes[pair].left = pair + 1;
    _nodes[pair + 1].right = pair;
}

std::uint32_t BinTriangleTree::forceSplit(NodeIndex t)
{
    assert(canSplit(t));
    std::uint32_t splits = 0;
    if (const NodeIndex base = _nodes[t].base; base != kNone && _nodes[base].base != t)
        splits += forceSplit(base);

    const NodeIndex partner = _nodes[t].base; // forced or not, now of the same level
    const std::uint32_t middle = addVertex(_nodes[t].splitSample);
    splitOne(t, middle);
    _nodes[_nodes[t].firstChild].freesApex = true;
    if (partner == kNone) return splits + 1;
    splitOne(partner, middle);
    // The two halves meet crosswise along the former base.
    const NodeIndex mine = _nodes[t].firstChild, theirs = _nodes[partner].firstChild;
    _nodes[mine].right = theirs + 1;
    _nodes[theirs + 1].left = mine;
    _nodes[theirs].right = mine + 1;
    _nodes[mine + 1].left = theirs;
    return splits + 2;
}

bool BinTriangleTree::isMergeable(NodeIndex t) const
{
    const auto hasLeafChildren = [this](NodeIndex n)
    {
        const NodeIndex child = _nodes[n].firstChild;
        return child != kNone && _nodes[child].isLeaf() && _nodes[child + 1].isLeaf();
    };
    const NodeIndex partner = _nodes[t].base;
    return hasLeafChildren(t) && (partner == kNone || hasLeafChildren(partner));
}

void BinTriangleTree::mergeOne(NodeIndex t)
{
    BinTriangle& parent = _nodes[t];
    const NodeIndex pair = parent.firstChild;
    eraseLeaf(pair);
    eraseLeaf(pair + 1);
    parent.left = _nodes[pair].base;
    parent.right = _nodes[pair + 1].base;
    replaceNeighbour(parent.left, pair, t);
    replaceNeighbour(parent.right, pair + 1, t);
    parent.firstChild = kNone;
    _freePairs.push_back(pair);
    insertLeaf(t);
}

void BinTriangleTree::merge(NodeIndex t)
{
    assert(isMergeable(t));
    const std::uint32_t middle = _nodes[_nodes[t].firstChild].vertices[kApex];
    const NodeIndex partner = _nodes[t].base;
    mergeOne(t);
    if (partner != kNone) mergeOne(partner);
    _freeVertices.push_back(middle);
}

std::uint32_t BinTriangleTree::forceMerge(NodeIndex t)
{
    std::uint32_t merges = 0;
    const NodeIndex partner = _nodes[t].base;
    for (const NodeIndex half : {t, partner})
    {
        if (half == kNone) continue;
        const NodeIndex pair = _nodes[half].firstChild;
        for (const NodeIndex child : {pair, pair + 1})
            if (!_nodes[child].isLeaf()) merges += forceMerge(child);
    }
    merge(t);
    return merges + (partner == kNone ? 1u : 2u);
}

} // namespace osgTerrainROAM::core
