// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>

#include <osgPMObjects/core/order/TriangleOrders.h>

#include "StripGrowth.h"
#include "VertexTriangles.h"

namespace osgPMObjects::core
{

namespace
{

using Entry = StripGrowth::Entry;

/// The completionCost() of a triangle without a vertex in the queue.
constexpr int kLost = 12;
/// The trials: strips from this share of the queue's size to twice the size, in steps of two triangles; each
/// trial draws this many times the longest strip. Shorter strips have good costs at first, but leave ragged
/// borders.
constexpr double kShortest = 0.375;
constexpr std::size_t kTrialLengths = 4;
/// Between full searches, lengths are tried that differ from the latest by so many triangles at most.
constexpr std::size_t kNearLengths = 4;

/// Draws a mesh strip by strip and tries lengths. Source: see localityOrder().
class LocalitySorter
{
public:
    LocalitySorter(std::span<const Triangle> triangles, std::uint32_t vertexCount, std::uint32_t cacheSize,
                   std::uint32_t fullSearchEvery)
        : _fullSearchEvery(fullSearchEvery),
          _triangles(triangles),
          _count(static_cast<std::uint32_t>(triangles.size())),
          _atVertex(triangles, vertexCount),
          _growth(triangles, vertexCount, cacheSize)
    {
    }

    std::vector<std::uint32_t> run()
    {
        for (Entry start = restart(); start.triangle != StripGrowth::kNone; start = restart())
            _growth.grow(start, bestLength(start));
        return _growth.order();
    }

private:
    /// Returns the triangle at a vertex of the queue that needs the fewest other vertices; a tie goes to the
    /// one with the fewest neighbours left, which would otherwise become a hole.
    Entry cheapestAtQueue()
    {
        const std::vector<std::uint32_t>& order = _growth.order();
        std::uint32_t best = StripGrowth::kNone;
        int least = 0;
        for (std::size_t back = 0; back < std::min<std::size_t>(order.size(), _growth.cache().size()); ++back)
            for (const std::uint32_t vertex : _triangles[order[order.size() - 1 - back]])
            {
                if (!_growth.cache().holds(vertex)) continue;
                for (const std::uint32_t t :
                     _atVertex.nextAt(vertex, [this](std::uint32_t o) { return _growth.isDone(o); }))
                    if (!_growth.isDone(t) &&
                        (best == StripGrowth::kNone || _growth.completionCost(t) < least))
                    {
                        best = t;
                        least = _growth.completionCost(t);
                    }
            }
        return {best, best == StripGrowth::kNone ? 0 : _growth.borderEdge(best)};
    }

    /// Returns where to go on: beside a strip, ahead of one, at a vertex in the queue, or at the first
    /// triangle left.
    Entry restart()
    {
        const Entry beside = _growth.nextBeside();
        if (beside.triangle != StripGrowth::kNone && _growth.completionCost(beside.triangle) < kLost)
            return beside;
        const Entry near = cheapestAtQueue();
        if (near.triangle == StripGrowth::kNone && beside.triangle != StripGrowth::kNone) return beside;
        if (beside.triangle != StripGrowth::kNone) _growth.pushAhead(beside);
        if (near.triangle != StripGrowth::kNone) return near;
        if (const Entry ahead = _growth.nextAhead(); ahead.triangle != StripGrowth::kNone) return ahead;
        while (_firstLeft < _count && _growth.isDone(_firstLeft))
            ++_firstLeft;
        if (_firstLeft == _count) return {StripGrowth::kNone, 0};
        return {_firstLeft, _growth.borderEdge(_firstLeft)};
    }

    /// Returns the best length by trials: of all lengths, or of those near the length of the latest strip.
    std::size_t bestLength(const Entry& start)
    {
        const std::size_t most = 2 * _growth.cache().size();
        const auto shortest =
            std::max<std::size_t>(static_cast<std::size_t>(kShortest * _growth.cache().size()), 1);
        const bool isFull = _strips++ % _fullSearchEvery == 0;
        std::size_t low = shortest, high = most, best = most;
        if (!isFull)
        {
            low = std::max(shortest, _length - std::min(_length, kNearLengths));
            high = std::min(most, _length + kNearLengths);
            low += (_length - low) % 2; // the length before is tried, too
        }
        double least = 4.0; // above the three transforms that a triangle can cost
        for (std::size_t length = low; length <= high; length += 2)
            if (const double cost = _growth.costOf(start, length, kTrialLengths * most, least); cost < least)
            {
                least = cost;
                best = length;
            }
        return _length = best;
    }

    std::uint32_t _fullSearchEvery;
    std::span<const Triangle> _triangles;
    std::uint32_t _count;
    VertexTriangles _atVertex;
    StripGrowth _growth;
    std::uint32_t _firstLeft = 0;
    std::size_t _strips = 0, _length = 0; ///< number of strips laid, and the length of the latest
};

} // namespace

std::vector<std::uint32_t> localityOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                         std::uint32_t cacheSize, std::uint32_t fullSearchEvery)
{
    return LocalitySorter(triangles, vertexCount, cacheSize, fullSearchEvery).run();
}

} // namespace osgPMObjects::core
