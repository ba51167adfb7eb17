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

using Place = StripGrowth::Place;

/// leftAt() of a triangle that has nothing in the queue any more.
constexpr int kLost = 12;
/// Trials: of strips from this share of the queue's size to twice that size, two triangles apart; each over so many times the
/// longest. Shorter strips look well at first, and leave ragged rims.
constexpr double kShortest = 0.375;
constexpr std::size_t kTrialLengths = 4;

class LocalitySorter
{
public:
    LocalitySorter(std::span<const Triangle> triangles, std::uint32_t vertexCount, std::uint32_t cacheSize)
        : _triangles(triangles),
          _count(static_cast<std::uint32_t>(triangles.size())),
          _atVertex(triangles, vertexCount),
          _growth(triangles, vertexCount, cacheSize)
    {
    }

    std::vector<std::uint32_t> run()
    {
        for (Place start = restart(); start.triangle != StripGrowth::kNone; start = restart())
            _growth.grow(start, bestLength(start));
        return _growth.order();
    }

private:
    /// Of the triangles at vertices in the queue the one that needs the fewest others, of equal ones the one with the fewest
    /// neighbours left: what would be left over as a hole goes first.
    Place cheapestAtQueue()
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
                    if (!_growth.isDone(t) && (best == StripGrowth::kNone || _growth.leftAt(t) < least))
                    {
                        best = t;
                        least = _growth.leftAt(t);
                    }
            }
        return {best, best == StripGrowth::kNone ? 0 : _growth.rim(best)};
    }

    /// Where to go on: beside a strip, ahead of one, at a vertex in the queue, or at the first triangle that is left.
    Place restart()
    {
        const Place beside = _growth.nextBeside();
        if (beside.triangle != StripGrowth::kNone && _growth.leftAt(beside.triangle) < kLost) return beside;
        const Place near = cheapestAtQueue();
        if (near.triangle == StripGrowth::kNone && beside.triangle != StripGrowth::kNone) return beside;
        if (beside.triangle != StripGrowth::kNone) _growth.putOnward(beside);
        if (near.triangle != StripGrowth::kNone) return near;
        if (const Place onward = _growth.nextOnward(); onward.triangle != StripGrowth::kNone) return onward;
        while (_firstLeft < _count && _growth.isDone(_firstLeft))
            ++_firstLeft;
        if (_firstLeft == _count) return {StripGrowth::kNone, 0};
        return {_firstLeft, _growth.rim(_firstLeft)};
    }

    std::size_t bestLength(const Place& start)
    {
        const std::size_t most = 2 * _growth.cache().size();
        const auto shortest =
            std::max<std::size_t>(static_cast<std::size_t>(kShortest * _growth.cache().size()), 1);
        std::size_t best = most;
        double least = 4.0; // more than three corners
        for (std::size_t length = shortest; length <= most; length += 2)
            if (const double cost = _growth.costOf(start, length, kTrialLengths * most); cost < least)
            {
                least = cost;
                best = length;
            }
        return best;
    }

    std::span<const Triangle> _triangles;
    std::uint32_t _count;
    VertexTriangles _atVertex;
    StripGrowth _growth;
    std::uint32_t _firstLeft = 0;
};

} // namespace

std::vector<std::uint32_t> localityOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                         std::uint32_t cacheSize)
{
    return LocalitySorter(triangles, vertexCount, cacheSize).run();
}

} // namespace osgPMObjects::core
