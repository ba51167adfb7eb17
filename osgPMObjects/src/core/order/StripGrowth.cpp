// SPDX-License-Identifier: Apache-2.0
#include "StripGrowth.h"

#include <algorithm>

namespace osgPMObjects::core
{

StripGrowth::StripGrowth(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                         std::uint32_t cacheSize)
    : _triangles(triangles),
      _neighbours(triangles.size()),
      _entryEdges(triangles.size()),
      _openNeighbours(triangles.size() + 1, 0),
      _isDone(triangles.size() + 1, 0),
      _cache(vertexCount, cacheSize)
{
    const TriangleAdjacency adjacency(triangles);
    _isDone[outside()] = 1;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (int edge = 0; edge < 3; ++edge)
        {
            const std::uint32_t n = adjacency.across(t, edge);
            _neighbours[t][edge] = n == kNone ? outside() : n;
            if (n == kNone) continue;
            _entryEdges[t][edge] = static_cast<std::uint8_t>(adjacency.edgeTo(n, t));
            ++_openNeighbours[t];
        }
}

void StripGrowth::draw(std::uint32_t t)
{
    _misses += _cache.draw(_triangles[t]);
    _isDone[t] = 1;
    for (const std::uint32_t n : _neighbours[t])
        --_openNeighbours[n];
    _order.push_back(t);
}

void StripGrowth::undraw(std::uint32_t t)
{
    _isDone[t] = 0;
    for (const std::uint32_t n : _neighbours[t])
        ++_openNeighbours[n];
}

/// Draws neighbours that have no other neighbour left: as holes they would need their vertices transformed
/// again later.
void StripGrowth::fillHoles(std::uint32_t t)
{
    for (const std::uint32_t n : _neighbours[t])
        if (!_isDone[n] && _openNeighbours[n] == 0 && missesOf(n) < 2) draw(n);
}

void StripGrowth::grow(const Entry& start, std::size_t length)
{
    const std::size_t firstBeside = _beside.size();
    layStrip(start, length);
    if (_beside.size() > firstBeside) _strips.push_back({firstBeside, _beside.size()});
}

void StripGrowth::layStrip(Entry entry, std::size_t length)
{
    bool turnsRight = true;
    for (std::size_t drawn = 1;; ++drawn, turnsRight = !turnsRight)
    {
        const std::uint32_t t = entry.triangle;
        draw(t);
        fillHoles(t);
        const int right = (entry.edge + 1) % 3, left = (entry.edge + 2) % 3;
        const bool isRightOpen = !_isDone[_neighbours[t][right]];
        const bool isLeftOpen = !_isDone[_neighbours[t][left]];
        if (!isRightOpen && !isLeftOpen) return;
        const bool isRight = isRightOpen && (!isLeftOpen || entry.isBeside || turnsRight);
        const bool isBehind =
            drawn == 1 && entry.isBeside; // the left of the way in leads back along the strip beside
        if (isRight && isLeftOpen) (isBehind ? _ahead : _beside).push_back(entering(t, left, !isBehind));
        if (!isRight && isRightOpen) _ahead.push_back(entering(t, right, false));
        entry = entering(t, isRight ? right : left, entry.isBeside);
        if (drawn < length) continue;
        entry.isBeside = false;
        return _ahead.push_back(entry);
    }
}

StripGrowth::Entry StripGrowth::nextBeside(std::size_t kept)
{
    for (; _strips.size() > kept; _strips.pop_back())
    {
        Beside& strip = _strips.back();
        _beside.resize(strip.end, {kNone, 0});
        while (strip.first < strip.end)
            if (const Entry& entry = _beside[strip.first++]; !_isDone[entry.triangle]) return entry;
    }
    return {kNone, 0};
}

StripGrowth::Entry StripGrowth::nextAhead()
{
    for (; !_ahead.empty(); _ahead.pop_back())
        if (!_isDone[_ahead.back().triangle]) return _ahead.back();
    return {kNone, 0};
}

int StripGrowth::borderEdge(std::uint32_t t) const
{
    for (int edge = 0; edge < 3; ++edge)
        if (_isDone[_neighbours[t][edge]]) return edge;
    return 0;
}

double StripGrowth::costOf(const Entry& start, std::size_t length, std::size_t triangles, double most)
{
    const std::size_t drawnBefore = _order.size(), besideBefore = _beside.size();
    const std::size_t onwardBefore = _ahead.size(), stripsBefore = _strips.size();
    const std::uint64_t missesBefore = _misses;
    const auto tooMany = missesBefore + static_cast<std::uint64_t>(most * static_cast<double>(triangles));
    _cache.beginTrial();
    for (Entry entry = start;
         entry.triangle != kNone && _order.size() < drawnBefore + triangles && _misses <= tooMany;
         entry = nextBeside(stripsBefore))
        grow(entry, std::min(length, drawnBefore + triangles - _order.size()));
    const double cost = _misses > tooMany ? most
                                          : static_cast<double>(_misses - missesBefore) /
                                                static_cast<double>(_order.size() - drawnBefore);
    _cache.endTrial();
    _misses = missesBefore;
    for (; _order.size() > drawnBefore; _order.pop_back())
        undraw(_order.back());
    _beside.resize(besideBefore, {kNone, 0});
    _ahead.resize(onwardBefore, {kNone, 0});
    _strips.resize(stripsBefore, {0, 0});
    return cost;
}

} // namespace osgPMObjects::core
