// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <utility>

#include <osgPMObjects/core/order/TriangleStrips.h>

namespace osgPMObjects::core
{

namespace
{

/// A spanning forest of the dual graph: triangles in the order of the search, and the triangle each was
/// reached from.
struct SpanningForest
{
    std::vector<std::uint32_t> order, parent;
};

/// Builds the spanning forest by a depth-first search. Source: see dualGraphStrips().
class DepthFirst
{
public:
    explicit DepthFirst(const TriangleAdjacency& adjacency)
        : _adjacency(adjacency), _isDone(adjacency.size(), 0), _left(adjacency.size())
    {
        _forest.parent.assign(adjacency.size(), TriangleAdjacency::kNone);
        for (std::uint32_t t = 0; t < adjacency.size(); ++t)
            _left[t] =
                static_cast<int>(3 - std::count(adjacency.neighbours(t).begin(),
                                                adjacency.neighbours(t).end(), TriangleAdjacency::kNone));
    }

    SpanningForest run()
    {
        for (int degree = 0; degree <= 3; ++degree) // from the borders inwards
            for (std::uint32_t root = 0; root < _adjacency.size(); ++root)
                if (!_isDone[root] && _left[root] == degree) search(root);
        for (std::uint32_t root = 0; root < _adjacency.size(); ++root)
            if (!_isDone[root]) search(root);
        return std::move(_forest);
    }

private:
    void search(std::uint32_t root)
    {
        enter(root);
        std::vector<std::uint32_t> path{root};
        while (!path.empty())
        {
            const std::uint32_t next = mostIsolated(path.back());
            if (next == TriangleAdjacency::kNone)
            {
                path.pop_back();
                continue;
            }
            _forest.parent[next] = path.back();
            enter(next);
            path.push_back(next);
        }
    }

    void enter(std::uint32_t t)
    {
        _isDone[t] = 1;
        _forest.order.push_back(t);
        for (const std::uint32_t n : _adjacency.neighbours(t))
            if (n != TriangleAdjacency::kNone) --_left[n];
    }

    std::uint32_t mostIsolated(std::uint32_t t) const
    {
        std::uint32_t best = TriangleAdjacency::kNone;
        for (const std::uint32_t n : _adjacency.neighbours(t))
            if (n != TriangleAdjacency::kNone && !_isDone[n] &&
                (best == TriangleAdjacency::kNone || _left[n] < _left[best]))
                best = n;
        return best;
    }

    const TriangleAdjacency& _adjacency;
    std::vector<char> _isDone;
    std::vector<int> _left; ///< by triangle: neighbours that are not reached yet
    SpanningForest _forest;
};

/// By triangle: the triangles before and after it on its path.
using Links = std::vector<std::array<std::uint32_t, 2>>;

/// Cuts the tree into paths, from the leaves up: each triangle joins two paths that end at its children, or
/// extends one of them. No other cut of the tree has fewer paths.
Links pathsOf(const SpanningForest& forest)
{
    Links links(forest.order.size(), {TriangleAdjacency::kNone, TriangleAdjacency::kNone});
    for (auto t = forest.order.rbegin(); t != forest.order.rend(); ++t)
    {
        const std::uint32_t parent = forest.parent[*t];
        if (parent == TriangleAdjacency::kNone || links[*t][1] != TriangleAdjacency::kNone ||
            links[parent][1] != TriangleAdjacency::kNone)
            continue;
        links[parent][links[parent][0] == TriangleAdjacency::kNone ? 0 : 1] = *t;
        links[*t][links[*t][0] == TriangleAdjacency::kNone ? 0 : 1] = parent;
    }
    return links;
}

} // namespace

TriangleStrips dualGraphStrips(std::span<const Triangle> triangles)
{
    const TriangleAdjacency adjacency(triangles);
    const SpanningForest forest = DepthFirst(adjacency).run();
    const Links links = pathsOf(forest);
    TriangleStrips strips;
    std::vector<char> isDone(triangles.size(), 0);
    for (const std::uint32_t end : forest.order)
    {
        if (isDone[end] || links[end][1] != TriangleAdjacency::kNone) continue; // not the end of a path
        strips.firsts.push_back(static_cast<std::uint32_t>(strips.triangles.size()));
        for (std::uint32_t t = end, next = TriangleAdjacency::kNone; t != TriangleAdjacency::kNone; t = next)
        {
            isDone[t] = 1;
            strips.triangles.push_back(t);
            next = TriangleAdjacency::kNone;
            for (const std::uint32_t linked : links[t])
                if (linked != TriangleAdjacency::kNone && !isDone[linked]) next = linked;
        }
    }
    return strips;
}

} // namespace osgPMObjects::core
