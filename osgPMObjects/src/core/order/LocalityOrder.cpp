// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <utility>

#include <osgPMObjects/core/order/TriangleAdjacency.h>
#include <osgPMObjects/core/order/TriangleOrders.h>

#include "TrialCache.h"
#include "VertexTriangles.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kNone = TriangleAdjacency::kNone;

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
          _adjacency(triangles),
          _atVertex(triangles, vertexCount),
          _cache(vertexCount, cacheSize),
          _isDone(triangles.size(), 0)
    {
    }

    std::vector<std::uint32_t> run()
    {
        for (Place start = restart(); start.triangle != kNone; start = restart())
        {
            const std::size_t length = bestLength(start);
            grow(start, length);
        }
        return std::move(_order);
    }

private:
    /// A triangle, and the edge through which the strip came; whether there is a strip to the right of it.
    struct Place
    {
        std::uint32_t triangle;
        int edge;
        bool isBeside = false;
    };

    /// The places left beside one strip, in _beside.
    struct Beside
    {
        std::size_t first, end;
    };

    void draw(std::uint32_t t)
    {
        _misses += _cache.draw(_triangles[t]);
        _isDone[t] = 1;
        _order.push_back(t);
    }

    bool isOpen(std::uint32_t t) const { return t != kNone && !_isDone[t]; }

    /// Draws neighbours that have no other one left: later they would be holes, whose vertices come back for them alone.
    void fillHoles(std::uint32_t t)
    {
        for (const std::uint32_t n : _adjacency.neighbours(t))
            if (isOpen(n) && leftAt(n) < 8 && leftAt(n) % 4 == 0) draw(n);
    }

    Place entering(std::uint32_t from, int edge, bool isBeside) const
    {
        const std::uint32_t next = _adjacency.across(from, edge);
        return {next, _adjacency.edgeTo(next, from), isBeside};
    }

    /// Draws a strip of at most so many triangles. Beside another one it keeps to its right; alone it goes straight on. What
    /// lies on its left is where the next ones begin; what lies ahead and on its right has time.
    void grow(const Place& start, std::size_t length)
    {
        const std::size_t firstBeside = _beside.size();
        layStrip(start, length);
        if (_beside.size() > firstBeside) _strips.push_back({firstBeside, _beside.size()});
    }

    void layStrip(Place place, std::size_t length)
    {
        bool turnsRight = true;
        for (std::size_t drawn = 1;; ++drawn, turnsRight = !turnsRight)
        {
            const std::uint32_t t = place.triangle;
            draw(t);
            fillHoles(t);
            const int right = (place.edge + 1) % 3, left = (place.edge + 2) % 3;
            const bool isRightOpen = isOpen(_adjacency.across(t, right));
            const bool isLeftOpen = isOpen(_adjacency.across(t, left));
            if (!isRightOpen && !isLeftOpen) return;
            const bool isRight = isRightOpen && (!isLeftOpen || place.isBeside || turnsRight);
            const bool isBehind =
                drawn == 1 && place.isBeside; // the left of the way in leads back along the strip beside
            if (isRight && isLeftOpen) (isBehind ? _onward : _beside).push_back(entering(t, left, !isBehind));
            if (!isRight && isRightOpen) _onward.push_back(entering(t, right, false));
            place = entering(t, isRight ? right : left, place.isBeside);
            if (drawn < length) continue;
            place.isBeside = false;
            return _onward.push_back(place);
        }
    }

    /// The first place left beside the latest strip that has one, but for the oldest `kept` strips; kNone, when there is none.
    Place nextBeside(std::size_t kept)
    {
        for (; _strips.size() > kept; _strips.pop_back())
        {
            Beside& strip = _strips.back();
            _beside.resize(strip.end, {kNone, 0});
            while (strip.first < strip.end)
                if (const Place& place = _beside[strip.first++]; !_isDone[place.triangle]) return place;
        }
        return {kNone, 0};
    }

    /// Of the triangles at vertices in the queue the one that needs the fewest others, of equal ones the one with the fewest
    /// neighbours left: what would be left over as a hole goes first.
    Place cheapestAtQueue()
    {
        std::uint32_t best = kNone;
        int least = 0;
        for (std::size_t back = 0; back < std::min<std::size_t>(_order.size(), _cache.size()); ++back)
            for (const std::uint32_t vertex : _triangles[_order[_order.size() - 1 - back]])
            {
                if (!_cache.holds(vertex)) continue;
                for (const std::uint32_t t :
                     _atVertex.nextAt(vertex, [this](std::uint32_t o) { return _isDone[o] != 0; }))
                    if (!_isDone[t] && (best == kNone || leftAt(t) < least))
                    {
                        best = t;
                        least = leftAt(t);
                    }
            }
        return {best, best == kNone ? 0 : rim(best)};
    }

    /// Four for each vertex that is not in the queue, and one for each neighbour left.
    int leftAt(std::uint32_t t) const
    {
        int left = 0;
        for (int i = 0; i < 3; ++i)
            left += 4 * !_cache.holds(_triangles[t][i]) + isOpen(_adjacency.across(t, i));
        return left;
    }

    /// Where to go on: beside a strip, ahead of one, at a vertex in the queue, or at the first triangle that is left.
    Place restart()
    {
        const Place beside = nextBeside(0);
        if (beside.triangle != kNone && leftAt(beside.triangle) < kLost) return beside;
        const Place near = cheapestAtQueue();
        if (near.triangle == kNone && beside.triangle != kNone) return beside;
        if (beside.triangle != kNone) _onward.push_back(beside);
        if (near.triangle != kNone) return near;
        for (; !_onward.empty(); _onward.pop_back())
            if (!_isDone[_onward.back().triangle]) return _onward.back();
        while (_firstLeft < _isDone.size() && _isDone[_firstLeft])
            ++_firstLeft;
        if (_firstLeft == _isDone.size()) return {kNone, 0};
        return {_firstLeft, rim(_firstLeft)};
    }

    /// An edge with nothing new across, to come in through.
    int rim(std::uint32_t t) const
    {
        for (int edge = 0; edge < 3; ++edge)
            if (!isOpen(_adjacency.across(t, edge))) return edge;
        return 0;
    }

    /// Transforms per triangle when this strip and those after it have that length, over so many triangles.
    double costOf(Place start, std::size_t length, std::size_t triangles)
    {
        const std::size_t drawnBefore = _order.size(), besideBefore = _beside.size();
        const std::size_t onwardBefore = _onward.size(), stripsBefore = _strips.size();
        const std::uint64_t missesBefore = _misses;
        _cache.beginTrial();
        for (Place place = start; place.triangle != kNone && _order.size() < drawnBefore + triangles;
             place = nextBeside(stripsBefore))
            grow(place, std::min(length, drawnBefore + triangles - _order.size()));
        const double cost =
            static_cast<double>(_misses - missesBefore) / static_cast<double>(_order.size() - drawnBefore);
        _cache.endTrial();
        _misses = missesBefore;
        for (; _order.size() > drawnBefore; _order.pop_back())
            _isDone[_order.back()] = 0;
        _beside.resize(besideBefore, {kNone, 0});
        _onward.resize(onwardBefore, {kNone, 0});
        _strips.resize(stripsBefore, {0, 0});
        return cost;
    }

    std::size_t bestLength(Place start)
    {
        const std::size_t most = 2 * _cache.size();
        const auto shortest = std::max<std::size_t>(static_cast<std::size_t>(kShortest * _cache.size()), 1);
        std::size_t best = most;
        double least = 4.0; // more than three corners
        for (std::size_t length = shortest; length <= most; length += 2)
            if (const double cost = costOf(start, length, kTrialLengths * most); cost < least)
            {
                least = cost;
                best = length;
            }
        return best;
    }

    std::span<const Triangle> _triangles;
    TriangleAdjacency _adjacency;
    VertexTriangles _atVertex;
    TrialCache _cache;
    std::vector<char> _isDone;
    std::vector<std::uint32_t> _order;
    std::vector<Beside> _strips; ///< those with places left beside them, the latest last
    std::vector<Place> _beside,
        _onward; ///< places where a strip may begin, in the order in which they were found
    std::uint32_t _firstLeft = 0;
    std::uint64_t _misses = 0;
};

} // namespace

std::vector<std::uint32_t> localityOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                         std::uint32_t cacheSize)
{
    return LocalitySorter(triangles, vertexCount, cacheSize).run();
}

} // namespace osgPMObjects::core
