// SPDX-License-Identifier: Apache-2.0
// Breadth-first halves mended after Fiduccia & Mattheyses, "A linear-time heuristic for improving network
// partitions" (1982).
#include "GraphBisection.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace osgPMObjects::core
{

namespace
{

constexpr int kPasses = 8;
constexpr std::size_t kSlackShare = 16; ///< the halves may differ from the middle by 1/16 of the set
constexpr std::size_t kIdleMoves = 64;  ///< moves without a better cut that end a pass

} // namespace

GraphBisection::GraphBisection(const TriangleAdjacency& adjacency)
    : _adjacency(adjacency),
      _set(adjacency.size(), 0),
      _seen(adjacency.size(), 0),
      _moved(adjacency.size(), 0),
      _isSecond(adjacency.size(), 0)
{
}

std::size_t GraphBisection::halve(std::span<std::uint32_t> triangles)
{
    ++_sets;
    for (const std::uint32_t t : triangles)
        _set[t] = _sets;
    // Two searches find an end of the graph; a third begins there, and its fronts are cuts across the graph.
    const std::uint32_t oneEnd = search(triangles, search(triangles, triangles.front()));
    search(triangles, oneEnd);
    std::copy(_found.begin(), _found.end(), triangles.begin());
    const std::size_t middle = triangles.size() / 2;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        _isSecond[triangles[i]] = i >= middle;
    mend(triangles, middle);
    const auto second = std::stable_partition(triangles.begin(), triangles.end(),
                                              [this](std::uint32_t t) { return !_isSecond[t]; });
    return static_cast<std::size_t>(second - triangles.begin());
}

/// Searches all of the set breadth first, from `first` and then from triangles not reached. Returns the last
/// triangle of the first connected part.
std::uint32_t GraphBisection::search(std::span<std::uint32_t> triangles, std::uint32_t first)
{
    ++_searches;
    _found.clear();
    std::uint32_t end = TriangleAdjacency::kNone;
    std::size_t done = 0;
    const auto enter = [this](std::uint32_t t)
    {
        if (std::exchange(_seen[t], _searches) != _searches) _found.push_back(t);
    };
    enter(first);
    for (std::size_t next = 0; next <= triangles.size(); ++next)
    {
        for (; done < _found.size(); ++done)
            for (const std::uint32_t n : _adjacency.neighbours(_found[done]))
                if (n != TriangleAdjacency::kNone && _set[n] == _sets) enter(n);
        if (end == TriangleAdjacency::kNone) end = _found.back();
        if (next < triangles.size()) enter(triangles[next]);
    }
    return end;
}

/// Returns by how much the cut shrinks if the triangle changes sides.
int GraphBisection::gain(std::uint32_t triangle) const
{
    int sum = 0;
    for (const std::uint32_t n : _adjacency.neighbours(triangle))
        if (n != TriangleAdjacency::kNone && _set[n] == _sets)
            sum += _isSecond[n] != _isSecond[triangle] ? 1 : -1;
    return sum;
}

void GraphBisection::addCandidate(std::uint32_t triangle)
{
    if (_moved[triangle] != _passes)
        _candidates[_isSecond[triangle] != 0][gain(triangle) + 3].push_back(triangle);
}

/// Returns the triangle with the largest gain whose move keeps the halves balanced. Candidates may be stale.
std::uint32_t GraphBisection::bestMove(std::size_t slack)
{
    for (int g = 6; g >= 0; --g)
        for (const int half : {_excess >= 0 ? 0 : 1, _excess >= 0 ? 1 : 0})
        {
            const std::ptrdiff_t after = _excess + (half == 0 ? -1 : 1);
            if (static_cast<std::size_t>(std::abs(after)) > std::max<std::size_t>(slack, std::abs(_excess)))
                continue;
            auto& offers = _candidates[half][g];
            while (!offers.empty())
            {
                const std::uint32_t t = offers.back();
                offers.pop_back();
                if (_moved[t] != _passes && (_isSecond[t] != 0) == (half == 1) && gain(t) + 3 == g) return t;
            }
        }
    return TriangleAdjacency::kNone;
}

/// Makes one pass: moves each triangle at most once, and undoes the moves after the best cut. Returns whether
/// it is better.
bool GraphBisection::improve(std::span<const std::uint32_t> triangles, std::size_t slack)
{
    ++_passes;
    for (auto& half : _candidates)
        for (auto& offers : half)
            offers.clear();
    for (const std::uint32_t t : triangles)
        if (gain(t) > -3)
            addCandidate(t); // others have no neighbour on the other side, or are far from the cut
    std::vector<Move> moves;
    int cut = 0, best = 0;
    std::size_t bestCount = 0;
    while (moves.size() < bestCount + kIdleMoves)
    {
        const std::uint32_t t = bestMove(slack);
        if (t == TriangleAdjacency::kNone) break;
        cut -= gain(t);
        _excess += _isSecond[t] ? 1 : -1;
        _isSecond[t] ^= 1;
        _moved[t] = _passes;
        moves.push_back({t, cut});
        for (const std::uint32_t n : _adjacency.neighbours(t))
            if (n != TriangleAdjacency::kNone && _set[n] == _sets) addCandidate(n);
        if (cut >= best) continue;
        best = cut;
        bestCount = moves.size();
    }
    for (; moves.size() > bestCount; moves.pop_back())
    {
        _excess += _isSecond[moves.back().triangle] ? 1 : -1;
        _isSecond[moves.back().triangle] ^= 1;
    }
    return best < 0;
}

void GraphBisection::mend(std::span<const std::uint32_t> triangles, std::size_t target)
{
    _excess = 0;
    const std::size_t wanted =
        std::max<std::size_t>(triangles.size() / kSlackShare, 1); // with 0, no triangle could move
    const std::size_t slack = std::min(wanted, target > 0 ? target - 1 : 0);
    for (int pass = 0; pass < kPasses && improve(triangles, slack); ++pass)
    {
    }
}

} // namespace osgPMObjects::core
