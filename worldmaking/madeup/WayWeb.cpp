// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/WayWeb.h"

#include <map>
#include <utility>

#include <foundation/NearestOnSegment.h>

#include "worldmaking/streets/LaneLayout.h"
#include "worldmaking/streets/StreetTraits.h"

namespace worldmaking
{

namespace
{

constexpr double kTouchM = 0.01, kParallelSine = 1e-9;

double crossOf(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

bool isSamePoint(const glm::dvec2& a, const glm::dvec2& b)
{
    return a == b;
}

/// A point that two segments ought to have in common: where they cross, or where one's end lies on the other.
std::optional<glm::dvec2> meetingOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                                    const glm::dvec2& d)
{
    if (isSamePoint(a, c) || isSamePoint(a, d) || isSamePoint(b, c) || isSamePoint(b, d)) return std::nullopt;
    for (const glm::dvec2& end : {c, d})
        if (glm::distance(foundation::nearestOnSegment(end, a, b), end) < kTouchM) return end;
    for (const glm::dvec2& end : {a, b})
        if (glm::distance(foundation::nearestOnSegment(end, c, d), end) < kTouchM) return end;
    return crossingOf(a, b, c, d);
}

} // namespace

double MadeWay::halfWidthM() const
{
    const auto traits = traitsOf({{"highway", std::string(kind)}});
    return traits ? layoutOf(*traits).halfWidthM() : 2.0;
}

std::optional<glm::dvec2> crossingOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                                     const glm::dvec2& d)
{
    const glm::dvec2 first = b - a, second = d - c;
    const double sine = crossOf(first, second);
    if (std::abs(sine) <= kParallelSine * glm::length(first) * glm::length(second)) return std::nullopt;
    const double u = crossOf(c - a, second) / sine, v = crossOf(c - a, first) / sine;
    if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) return std::nullopt;
    return a + u * first;
}

std::size_t WayWeb::add(MadeWay way)
{
    const std::size_t number = _ways.size();
    for (std::size_t i = 0; i + 1 < way.points.size(); ++i)
    {
        _grid.add(_pieces.size(), boxOf({way.points[i], way.points[i + 1]}));
        _pieces.push_back({number, way.points[i], way.points[i + 1]});
    }
    _ways.push_back(std::move(way));
    return number;
}

std::optional<WayMatch> WayWeb::nearest(const glm::dvec2& place, double withinM, std::size_t except) const
{
    std::optional<WayMatch> best;
    double leastM = withinM;
    _grid.near({place - withinM, place + withinM},
               [&](std::size_t i)
               {
                   const Piece& piece = _pieces[i];
                   if (piece.way == except) return;
                   const glm::dvec2 at = foundation::nearestOnSegment(place, piece.a, piece.b);
                   const double distanceM = glm::distance(at, place);
                   if (distanceM >= leastM) return;
                   leastM = distanceM;
                   best = WayMatch{piece.way, 0, at, glm::normalize(piece.b - piece.a), distanceM};
               });
    return best;
}

void WayWeb::insert(std::size_t way, const glm::dvec2& place)
{
    auto& points = _ways[way].points;
    std::size_t best = 0;
    double leastM = 1e300;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
        const double distanceM =
            glm::distance(foundation::nearestOnSegment(place, points[i], points[i + 1]), place);
        if (distanceM < leastM) leastM = distanceM, best = i;
    }
    if (isSamePoint(points[best], place) || isSamePoint(points[best + 1], place)) return;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(best) + 1, place);
}

void WayWeb::weave()
{
    std::vector<std::pair<std::size_t, glm::dvec2>> found;
    for (std::size_t i = 0; i < _pieces.size(); ++i)
    {
        const Piece& one = _pieces[i];
        const MapBox box = boxOf({one.a, one.b});
        _grid.near({box.low - kTouchM, box.high + kTouchM},
                   [&](std::size_t j)
                   {
                       const Piece& other = _pieces[j];
                       if (j <= i || other.way == one.way) return;
                       if (const auto place = meetingOf(one.a, one.b, other.a, other.b))
                       {
                           found.emplace_back(one.way, *place);
                           found.emplace_back(other.way, *place);
                       }
                   });
    }
    for (const auto& [way, place] : found)
        insert(way, place);
}

std::vector<glm::dvec2> WayWeb::knots() const
{
    std::map<std::pair<double, double>, int> counts;
    for (const MadeWay& way : _ways)
        for (std::size_t i = 0; i < way.points.size(); ++i)
            counts[{way.points[i].x, way.points[i].y}] += i == 0 || i + 1 == way.points.size() ? 2 : 1;
    std::vector<glm::dvec2> knots;
    for (const auto& [place, count] : counts)
        if (count > 1) knots.emplace_back(place.first, place.second);
    return knots;
}

bool WayWeb::crossesAnywhere() const
{
    for (std::size_t one = 0; one < _ways.size(); ++one)
        for (std::size_t other = one + 1; other < _ways.size(); ++other)
        {
            const auto &p = _ways[one].points, &q = _ways[other].points;
            for (std::size_t i = 0; i + 1 < p.size(); ++i)
                for (std::size_t j = 0; j + 1 < q.size(); ++j)
                    if (meetingOf(p[i], p[i + 1], q[j], q[j + 1])) return true;
        }
    return false;
}

} // namespace worldmaking
