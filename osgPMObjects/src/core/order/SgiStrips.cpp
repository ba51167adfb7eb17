// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <queue>
#include <tuple>

#include <osgPMObjects/core/order/TriangleStrips.h>

namespace osgPMObjects::core
{

namespace
{

/// Grows strips from the triangles with the fewest neighbours. Source: see sgiStrips().
class SgiStripper
{
public:
    explicit SgiStripper(std::span<const Triangle> triangles)
        : _adjacency(triangles), _isDone(triangles.size(), 0), _tried(triangles.size(), 0)
    {
    }

    TriangleStrips run()
    {
        for (std::uint32_t t = 0; t < _adjacency.size(); ++t)
            offer(t);
        while (!_starts.empty())
        {
            const Start start = _starts.top();
            _starts.pop();
            if (_isDone[start.triangle] || start != startAt(start.triangle)) continue; // stale
            take(longestThrough(start.triangle));
        }
        for (std::uint32_t t = 0; t < _adjacency.size(); ++t)
            if (!_isDone[t]) take({t}); // no neighbours are left
        return std::move(_strips);
    }

private:
    struct Start
    {
        int degree, neighbourDegrees;
        std::uint32_t triangle;
        auto operator<=>(const Start&) const = default;
    };

    int degree(std::uint32_t t) const
    {
        int count = 0;
        for (const std::uint32_t n : _adjacency.neighbours(t))
            count += n != TriangleAdjacency::kNone && !_isDone[n];
        return count;
    }

    Start startAt(std::uint32_t t) const
    {
        Start start{degree(t), 0, t};
        for (const std::uint32_t n : _adjacency.neighbours(t))
            if (n != TriangleAdjacency::kNone && !_isDone[n]) start.neighbourDegrees += degree(n);
        return start;
    }

    void offer(std::uint32_t t)
    {
        if (const Start start = startAt(t); start.degree > 0) _starts.push(start);
    }

    /// Extends a strip from `t` through `edge` as far as triangles are new. The path through a triangle with
    /// an even number goes from one edge to the next, with an odd number to the one before; backwards it is
    /// the opposite. So `step` changes with each triangle in either direction.
    void extend(std::uint32_t t, int edge, int step, std::vector<std::uint32_t>& row)
    {
        for (std::uint32_t next = _adjacency.across(t, edge);
             next != TriangleAdjacency::kNone && !_isDone[next] && _tried[next] != _trial;
             next = _adjacency.across(t, edge))
        {
            _tried[next] = _trial;
            row.push_back(next);
            edge = (_adjacency.edgeTo(next, t) + step) % 3;
            step = 3 - step;
            t = next;
        }
    }

    std::vector<std::uint32_t> longestThrough(std::uint32_t start)
    {
        std::vector<std::uint32_t> longest, forward, backward;
        for (int edge = 0; edge < 3; ++edge)
        {
            ++_trial;
            _tried[start] = _trial;
            forward.clear();
            backward.clear();
            extend(start, edge, 2, forward); // the start has number 0 and was entered by the edge before
            extend(start, (edge + 2) % 3, 1, backward);
            if (forward.size() + backward.size() + 1 <= longest.size()) continue;
            longest.assign(backward.rbegin(), backward.rend());
            longest.push_back(start);
            longest.insert(longest.end(), forward.begin(), forward.end());
        }
        return longest;
    }

    void take(const std::vector<std::uint32_t>& strip)
    {
        _strips.firsts.push_back(static_cast<std::uint32_t>(_strips.triangles.size()));
        _strips.triangles.insert(_strips.triangles.end(), strip.begin(), strip.end());
        for (const std::uint32_t t : strip)
            _isDone[t] = 1;
        for (const std::uint32_t t : strip)
            for (const std::uint32_t n : _adjacency.neighbours(t))
            {
                if (n == TriangleAdjacency::kNone || _isDone[n]) continue;
                offer(n);
                for (const std::uint32_t farther : _adjacency.neighbours(n))
                    if (farther != TriangleAdjacency::kNone && !_isDone[farther]) offer(farther);
            }
    }

    TriangleAdjacency _adjacency;
    std::vector<char> _isDone;
    std::vector<std::uint32_t> _tried; ///< by triangle: the last trial that it was part of
    std::uint32_t _trial = 0;
    std::priority_queue<Start, std::vector<Start>, std::greater<>> _starts; ///< some may be stale
    TriangleStrips _strips;
};

} // namespace

TriangleStrips sgiStrips(std::span<const Triangle> triangles)
{
    return SgiStripper(triangles).run();
}

} // namespace osgPMObjects::core
