// SPDX-License-Identifier: Apache-2.0
// The exhaustive check of DiamondTree::isConforming. It uses neither neighbours nor levels: it matches the
// edges of all leaves by their end samples, so a T-junction shows as an edge without a twin.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

namespace
{

/// An edge of a leaf, from one point of the grid to another.
struct Edge
{
    using Ends = std::pair<std::uint64_t, std::uint64_t>;
    Ends ends; ///< linear indices of both places
    TriangleId leaf;

    friend bool operator<(const Edge& a, const Edge& b) { return a.ends < b.ends; }
};

struct Grid
{
    std::int64_t side;

    Edge::Ends ends(GridPoint a, GridPoint b) const
    {
        const auto index = [this](GridPoint p)
        { return static_cast<std::uint64_t>(p.row * side + p.column); };
        return {index(a), index(b)};
    }

    bool onBorder(GridPoint a, GridPoint b) const
    {
        const std::int64_t last = side - 1;
        return (a.column == b.column && (a.column == 0 || a.column == last)) ||
               (a.row == b.row && (a.row == 0 || a.row == last));
    }
};

std::int64_t doubleArea(const GridTriangle& t)
{
    const std::int64_t uc = t.left.column - t.apex.column, ur = t.left.row - t.apex.row;
    const std::int64_t wc = t.right.column - t.apex.column, wr = t.right.row - t.apex.row;
    return uc * wr - wc * ur;
}

std::vector<TriangleId> leavesOf(const DiamondTree& tree)
{
    std::vector<TriangleId> open(std::begin(DiamondTree::kRoots), std::end(DiamondTree::kRoots)), leaves;
    while (!open.empty())
    {
        const TriangleId t = open.back();
        open.pop_back();
        if (tree.isLeaf(t))
            leaves.push_back(t);
        else
            for (const TriangleId child : tree.children(t))
                open.push_back(child);
    }
    return leaves;
}

} // namespace

/// Whether a vertex lies in the middle of the base of the triangles that it has split, one level below, and
/// their links name it.
bool DiamondTree::linksAreSound(VertexSlot v) const
{
    const DiamondPlace& place = _places[v];
    const auto split = parents(v);
    for (int side = 0; side < 2; ++side)
    {
        const TriangleId t = split[static_cast<std::size_t>(side)];
        if (!t.exists()) continue;
        if (link(t) != (kSplit | v) || level(t) != place.level) return false;
        const GridTriangle g = gridTriangle(t);
        if (g.middleOfBase() != place.point()) return false;
        if (gridTriangle(children(t)[0]).left != g.apex || gridTriangle(children(t)[1]).right != g.apex)
            return false;
    }
    return true;
}

bool DiamondTree::isConforming() const
{
    const Grid grid{tile().tile.grid().side()};
    const std::vector<TriangleId> leaves = leavesOf(*this);
    std::vector<Edge> edges;
    edges.reserve(3 * leaves.size());
    std::int64_t area = 0;
    for (const TriangleId t : leaves)
    {
        const GridTriangle g = gridTriangle(t);
        if (doubleArea(g) <= 0) return false;
        const LeafTriangle corners = vertices(t);
        const GridPoint places[3] = {g.apex, g.left, g.right};
        for (std::size_t i = 0; i < 3; ++i)
            if (place(corners.vertices[i]).point() != places[i]) return false;
        area += doubleArea(g);
        const bool drawn = link(t) != kUndrawn;
        if (drawn != isDrawn(t) || (drawn && _leaves.leaf(link(t)) != t)) return false;
        if (drawn && _leaves.regionOf(link(t)) != regionOf(t)) return false;
        edges.push_back({grid.ends(g.apex, g.left), t});
        edges.push_back({grid.ends(g.left, g.right), t});
        edges.push_back({grid.ends(g.right, g.apex), t});
    }
    if (area != 2 * (grid.side - 1) * (grid.side - 1)) return false;
    std::sort(edges.begin(), edges.end());

    const auto isShared = [&](GridPoint a, GridPoint b, TriangleId t, TriangleId across)
    {
        const auto twin = std::lower_bound(edges.begin(), edges.end(), Edge{grid.ends(b, a), t});
        if (twin == edges.end() || twin->ends != grid.ends(b, a))
            return !across.exists() && grid.onBorder(a, b);
        return twin->leaf == across && std::abs(level(across) - level(t)) <= 1;
    };
    for (const TriangleId t : leaves)
    {
        const GridTriangle g = gridTriangle(t);
        if (!isShared(g.apex, g.left, t, acrossLeg(t, false)) ||
            !isShared(g.left, g.right, t, acrossBase(t)) || !isShared(g.right, g.apex, t, acrossLeg(t, true)))
            return false;
    }
    std::size_t used = kCorners;
    for (VertexSlot v = kCorners; v < vertexSlots(); ++v)
    {
        if (_places[v].isFree()) continue;
        if (!linksAreSound(v)) return false;
        ++used;
    }
    return leaves.size() == _leafCount && _leaves.leafCount() + _undrawnLeaves == leaves.size() &&
           _leaves.isConsistent() && used + _freeSlots.size() == _places.size();
}

} // namespace osgTerrainROAM::core
