// SPDX-License-Identifier: Apache-2.0
// The exhaustive check behind BinTriangleTree::isConforming. It trusts neither neighbour links nor levels: the
// edges of all leaves are matched by their end samples, so that a T-junction shows as an edge without its twin.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>

namespace osgTerrainROAM::core
{

namespace
{

struct Grid
{
    std::int64_t side;
    std::int64_t column(SampleIndex s) const { return s % side; }
    std::int64_t row(SampleIndex s) const { return s / side; }

    std::int64_t doubleArea(SampleIndex a, SampleIndex b, SampleIndex c) const
    {
        return (column(b) - column(a)) * (row(c) - row(a)) - (column(c) - column(a)) * (row(b) - row(a));
    }

    bool onBorder(SampleIndex a, SampleIndex b) const
    {
        const std::int64_t last = side - 1;
        return (column(a) == column(b) && (column(a) == 0 || column(a) == last)) ||
               (row(a) == row(b) && (row(a) == 0 || row(a) == last));
    }
};

using EdgeOwners = std::map<std::pair<SampleIndex, SampleIndex>, NodeIndex>;

std::vector<NodeIndex> leavesOf(const BinTriangleTree& tree)
{
    std::vector<NodeIndex> open(std::begin(BinTriangleTree::kRoots), std::end(BinTriangleTree::kRoots)),
        leaves;
    while (!open.empty())
    {
        const NodeIndex t = open.back();
        open.pop_back();
        if (tree.node(t).isLeaf())
            leaves.push_back(t);
        else
            open.insert(open.end(), {tree.node(t).firstChild, tree.node(t).firstChild + 1});
    }
    return leaves;
}

} // namespace

bool BinTriangleTree::isConforming() const
{
    const Grid grid{_tile->tile.side()};
    const std::vector<NodeIndex> leaves = leavesOf(*this);
    EdgeOwners owners;
    std::map<SampleIndex, std::uint32_t> slotOfSample;
    std::int64_t doubleArea = 0;
    std::uint32_t drawn = 0;
    for (const NodeIndex t : leaves)
    {
        const BinTriangle& node = _nodes[t];
        SampleIndex s[3];
        for (int i = 0; i < 3; ++i)
        {
            s[i] = _sampleOfVertex[node.vertices[i]];
            if (slotOfSample.try_emplace(s[i], node.vertices[i]).first->second != node.vertices[i])
                return false;
        }
        const std::int64_t area = grid.doubleArea(s[0], s[1], s[2]);
        if (area <= 0) return false;
        doubleArea += area;
        drawn += node.inData ? 1 : 0;
        for (int i = 0; i < 3; ++i)
            if (!owners.emplace(std::pair{s[i], s[(i + 1) % 3]}, t).second) return false;
    }
    if (doubleArea != 2 * (grid.side - 1) * (grid.side - 1)) return false;

    const auto acrossEdge = [&](NodeIndex t, int from, NodeIndex link)
    {
        const SampleIndex a = _sampleOfVertex[_nodes[t].vertices[from]];
        const SampleIndex b = _sampleOfVertex[_nodes[t].vertices[(from + 1) % 3]];
        const auto twin = owners.find({b, a});
        if (twin == owners.end()) return link == kNone && grid.onBorder(a, b);
        return twin->second == link && std::abs(int{_nodes[link].level} - int{_nodes[t].level}) <= 1;
    };
    for (const NodeIndex t : leaves)
    {
        const BinTriangle& node = _nodes[t];
        if (!acrossEdge(t, 0, node.left) || !acrossEdge(t, 1, node.base) || !acrossEdge(t, 2, node.right))
            return false;
    }
    std::size_t sparePairs = _freePairs.size(), spareVertices = _freeVertices.size();
    countUndismantled(sparePairs, spareVertices);
    const std::size_t undrawn = std::accumulate(_undrawnLeaves.begin(), _undrawnLeaves.end(), std::size_t{0});
    return leaves.size() == _leafCount && drawn == _leaves.leafCount() && undrawn == leaves.size() - drawn &&
           _leaves.isConsistent() && slotOfSample.size() + spareVertices == _vertices.size() &&
           2 * (leaves.size() - 1) + 2 * sparePairs == _nodes.size();
}

} // namespace osgTerrainROAM::core
