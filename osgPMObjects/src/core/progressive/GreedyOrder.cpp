// SPDX-License-Identifier: Apache-2.0
#include "GreedyOrder.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <foundation/VertexCache.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kFacesOfLine = 10; // in 64 bytes of 16-bit indices

/// Builds the greedy order triangle by triangle. Source: see greedyOrder().
class GreedyBuffer
{
public:
    GreedyBuffer(std::span<const Triangle> triangles, std::uint32_t vertexCount, const GreedyRules& rules,
                 GreedyPlaces places)
        : _triangles(triangles),
          _rules(rules),
          _positionOf(std::move(places.positionOf)),
          _isTouched(std::move(places.isTouched)),
          _cache(vertexCount, rules.cacheSize),
          _isPlaced(triangles.size(), false),
          _trianglesOf(vertexCount),
          _recent(rules.cacheSize)
    {
        if (_positionOf.empty())
        {
            _positionOf.resize(triangles.size());
            std::iota(_positionOf.begin(), _positionOf.end(), 0u);
        }
        const std::uint32_t end = _positionOf.back() + 1;
        _triangleAt.resize(end, kNone);
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            _triangleAt[_positionOf[t]] = t;
        const std::vector<bool> isWritten = std::exchange(_isTouched, {});
        _isTouched.resize(end / kFacesOfLine * kFacesOfLine + kFacesOfLine, false);
        for (std::uint32_t position = 0; position < std::min<std::size_t>(end, isWritten.size()); ++position)
            if (isWritten[position]) touchLineOf(position);
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (const std::uint32_t vertex : triangles[t])
                _trianglesOf[vertex].push_back(t);
    }

    std::vector<std::uint32_t> order()
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t position = 0; position < _triangles.size(); ++position)
        {
            const std::uint32_t t = position == 0          ? 0
                                    : _rules.lookAhead > 1 ? bestAhead(position)
                                                           : bestFor(position).triangle;
            order.push_back(t);
            append(t, position);
        }
        return order;
    }

private:
    static constexpr std::uint32_t kNone = ~0u;

    struct Choice
    {
        std::uint32_t triangle = kNone;
        float cost = 1e9f;

        bool operator<(const Choice& other) const
        {
            return cost != other.cost ? cost < other.cost : triangle < other.triangle;
        }
    };

    /// Calls visit(triangle) for each triangle that has this position already or a vertex in the cache; some
    /// twice.
    template<class Visit>
    void visitCandidates(std::uint32_t position, const Visit& visit) const
    {
        if (const std::uint32_t t = _triangleAt[position]; t != kNone && !_isPlaced[t]) visit(t);
        for (const std::uint32_t vertex : _recent)
            for (const std::uint32_t t : _trianglesOf[vertex])
                if (!_isPlaced[t]) visit(t);
    }

    Choice bestFor(std::uint32_t position)
    {
        Choice best;
        visitCandidates(position, [&](std::uint32_t t) { best = std::min(best, {t, costOf(t, position)}); });
        return best.triangle != kNone ? best : firstLeft(position);
    }

    Choice firstLeft(std::uint32_t position)
    {
        std::uint32_t t = _firstLeft;
        while (_isPlaced[t])
            ++t;
        return {t, costOf(t, position)};
    }

    /// Chooses by trials of `lookAhead` triangles.
    std::uint32_t bestAhead(std::uint32_t position)
    {
        std::vector<std::uint32_t> candidates;
        visitCandidates(position, [&](std::uint32_t t) { candidates.push_back(t); });
        if (candidates.empty()) return firstLeft(position).triangle;
        std::sort(candidates.begin(), candidates.end());
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
        Choice best;
        for (const std::uint32_t t : candidates)
            best = std::min(best, {t, trialCost(t, position)});
        return best.triangle;
    }

    /// Returns the cost of a triangle and of those that the order without look-ahead would draw after it.
    float trialCost(std::uint32_t t, std::uint32_t position)
    {
        const std::vector<std::uint32_t> recentBefore = _recent;
        const std::size_t end = std::min<std::size_t>(position + _rules.lookAhead, _triangles.size());
        Choice next{t, costOf(t, position)};
        float cost = 0.0f;
        for (;;)
        {
            cost += next.cost;
            draw(next.triangle, true);
            if (++position == end) break;
            next = bestFor(position);
        }
        for (; !_tried.empty(); _tried.pop_back())
            _isPlaced[_tried.back()] = false;
        for (; !_missed.empty(); _missed.pop_back())
            _cache.takeBack(_missed.back().first, _missed.back().second);
        _recent = recentBefore;
        return cost;
    }

    float costOf(std::uint32_t t, std::uint32_t position) const
    {
        float cost = 0.0f;
        for (const std::uint32_t vertex : _triangles[t])
            cost += _cache.holds(vertex) ? 0.0f : 1.0f;
        if (_positionOf[t] == position) return cost - _rules.weights.stays;
        return _isTouched[_positionOf[t]] ? cost - _rules.weights.lineTouched : cost;
    }

    void draw(std::uint32_t t, bool isTrial)
    {
        _isPlaced[t] = true;
        if (isTrial) _tried.push_back(t);
        for (const std::uint32_t vertex : _triangles[t])
        {
            const std::uint64_t before = _cache.lastMiss(vertex);
            if (!_cache.transform(vertex)) continue;
            if (isTrial) _missed.emplace_back(vertex, before);
            _recent[_cache.misses() % _recent.size()] = vertex;
        }
    }

    void append(std::uint32_t t, std::uint32_t position)
    {
        draw(t, false);
        while (_firstLeft < _triangles.size() && _isPlaced[_firstLeft])
            ++_firstLeft;
        if (_positionOf[t] != position)
        {
            touchLineOf(position);
            touchLineOf(_positionOf[t]);
        }
        for (const std::uint32_t vertex : _triangles[t])
            std::erase(_trianglesOf[vertex], t);
    }

    void touchLineOf(std::uint32_t position)
    {
        std::fill_n(_isTouched.begin() + position / kFacesOfLine * kFacesOfLine, kFacesOfLine, true);
    }

    std::span<const Triangle> _triangles;
    GreedyRules _rules;
    std::vector<std::uint32_t> _positionOf, _triangleAt; ///< before; kNone: no triangle
    std::vector<bool> _isTouched;                        ///< by position, whole lines
    foundation::FifoCache _cache;
    std::vector<bool> _isPlaced;
    std::vector<std::vector<std::uint32_t>> _trianglesOf; ///< by vertex: triangles left
    std::vector<std::uint32_t> _recent;                   ///< vertices in the cache
    std::uint32_t _firstLeft = 0;
    std::vector<std::uint32_t> _tried; ///< triangles of the trial
    std::vector<std::pair<std::uint32_t, std::uint64_t>>
        _missed; ///< vertices transformed in the trial, with their last miss before
};

} // namespace

std::vector<std::uint32_t> greedyOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                       const GreedyRules& rules, GreedyPlaces places)
{
    if (triangles.empty()) return {};
    return GreedyBuffer(triangles, vertexCount, rules, std::move(places)).order();
}

} // namespace osgPMObjects::core
