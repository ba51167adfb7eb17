// SPDX-License-Identifier: Apache-2.0
#include "StripGrowth.h"

#include <algorithm>

namespace osgPMObjects::core
{

StripGrowth::StripGrowth(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                         std::uint32_t cacheSize)
    : _triangles(triangles),
      _adjacency(triangles),
      _cache(vertexCount, cacheSize),
      _isDone(triangles.size(), 0)
{
}

void StripGrowth::draw(std::uint32_t t)
{
    _misses += _cache.draw(_triangles[t]);
    _isDone[t] = 1;
    _order.push_back(t);
}

/// Draws neighbours that have no other one left: later they would be holes, whose vertices come back for them alone.
void StripGrowth::fillHoles(std::uint32_t t)
{
    for (const std::uint32_t n : _adjacency.neighbours(t))
        if (isOpen(n) && leftAt(n) < 8 && leftAt(n) % 4 == 0) draw(n);
}

StripGrowth::Place StripGrowth::entering(std::uint32_t from, int edge, bool isBeside) const
{
    const std::uint32_t next = _adjacency.across(from, edge);
    return {next, _adjacency.edgeTo(next, from), isBeside};
}

void StripGrowth::grow(const Place& start, std::size_t length)
{
    const std::size_t firstBeside = _beside.size();
    layStrip(start, length);
    if (_beside.size() > firstBeside) _strips.push_back({firstBeside, _beside.size()});
}

void StripGrowth::layStrip(Place place, std::size_t length)
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

StripGrowth::Place StripGrowth::nextBeside(std::size_t kept)
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

StripGrowth::Place StripGrowth::nextOnward()
{
    for (; !_onward.empty(); _onward.pop_back())
        if (!_isDone[_onward.back().triangle]) return _onward.back();
    return {kNone, 0};
}

int StripGrowth::leftAt(std::uint32_t t) const
{
    int left = 0;
    for (int i = 0; i < 3; ++i)
        left += 4 * !_cache.holds(_triangles[t][i]) + isOpen(_adjacency.across(t, i));
    return left;
}

int StripGrowth::rim(std::uint32_t t) const
{
    for (int edge = 0; edge < 3; ++edge)
        if (!isOpen(_adjacency.across(t, edge))) return edge;
    return 0;
}

double StripGrowth::costOf(const Place& start, std::size_t length, std::size_t triangles)
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

} // namespace osgPMObjects::core
