// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>
#include <tuple>

#include <osgPMObjects/core/tessellate/HoleBridges.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

#include "LeftRay.h"

namespace osgPMObjects::core
{

namespace
{

/// Joins holes from left to right. Source: see bridgeHoles().
class Bridger
{
public:
    Bridger(std::span<const glm::dvec2> points, std::span<const Loop> loops) : _points(points)
    {
        for (const Loop& loop : loops)
        {
            const auto first = static_cast<std::uint32_t>(_visits.size());
            const auto size = static_cast<std::uint32_t>(loop.size());
            for (std::uint32_t i = 0; i < size; ++i)
                _visits.push_back({loop[i], first + (i + size - 1) % size, first + (i + 1) % size});
            _firsts.push_back(leftmost(first, size));
        }
        std::sort(_firsts.begin(), _firsts.end(),
                  [this](std::uint32_t a, std::uint32_t b) { return isLeftOf(position(a), position(b)); });
    }

    std::vector<Loop> run()
    {
        for (const std::uint32_t first : _firsts)
            if (const auto hole = westernVisit(first)) bridge(*hole);
        std::vector<Loop> loops;
        std::vector<char> isDone(_visits.size(), 0);
        for (std::uint32_t first = 0; first < _visits.size(); ++first)
        {
            if (isDone[first]) continue;
            Loop& loop = loops.emplace_back();
            for (std::uint32_t visit = first; !isDone[visit]; visit = _visits[visit].next)
            {
                isDone[visit] = 1;
                loop.push_back(_visits[visit].point);
            }
        }
        return loops;
    }

private:
    struct Visit
    {
        std::uint32_t point, previous, next;
    };

    static bool isLeftOf(const glm::dvec2& a, const glm::dvec2& b)
    {
        return std::tie(a.x, a.y) < std::tie(b.x, b.y);
    }

    const glm::dvec2& position(std::uint32_t visit) const { return _points[_visits[visit].point]; }

    std::uint32_t leftmost(std::uint32_t first, std::uint32_t size) const
    {
        std::uint32_t best = first;
        for (std::uint32_t visit = first + 1; visit < first + size; ++visit)
            if (isLeftOf(position(visit), position(best))) best = visit;
        return best;
    }

    bool looksAt(std::uint32_t visit, const glm::dvec2& target) const
    {
        const Visit& v = _visits[visit];
        return isInSector(position(v.previous), position(visit), position(v.next), target);
    }

    /// Returns the visit to a hole's leftmost point with the inside on its left; nothing for a loop that is
    /// no hole.
    std::optional<std::uint32_t> westernVisit(std::uint32_t leftmost) const
    {
        const glm::dvec2 west = position(leftmost) - glm::dvec2(1.0, 0.0);
        std::uint32_t visit = leftmost;
        do
        {
            if (_visits[visit].point == _visits[leftmost].point && looksAt(visit, west)) return visit;
            visit = _visits[visit].next;
        } while (visit != leftmost);
        return std::nullopt;
    }

    void bridge(std::uint32_t hole)
    {
        // Only edges that run down have the inside on their right; the ray meets that side of a bridge, too.
        std::vector<UprightEdge> edges;
        for (const Visit& visit : _visits)
            if (const std::uint32_t behind = _visits[visit.next].point;
                _points[visit.point].y > _points[behind].y)
                edges.push_back({behind, visit.point});
        const auto hit = firstEdgeLeft(_points, edges, position(hole));
        assert(hit && "a hole lies within something");
        if (!hit) return;
        const std::uint32_t seen = firstInTheWay(edges[*hit], position(hole));
        for (std::uint32_t visit = 0; visit < _visits.size(); ++visit)
            if (_visits[visit].point == seen && looksAt(visit, position(hole))) return splice(visit, hole);
        assert(false && "one of the visits to a point in sight looks back");
    }

    /// Turns the ray towards the end of the hit edge that lies left of `from`; returns the first point that
    /// it passes, which may be that end.
    std::uint32_t firstInTheWay(const UprightEdge& edge, const glm::dvec2& from) const
    {
        const bool isDown = _points[edge.low].x <= from.x;
        const double turn = isDown ? 1.0 : -1.0; // counter-clockwise from -x
        std::uint32_t first = isDown ? edge.low : edge.high;
        const glm::dvec2 low = _points[edge.low], high = _points[edge.high];
        for (const Visit& visit : _visits)
        {
            const glm::dvec2& p = _points[visit.point];
            if (p.x > from.x || p == from) continue;
            if (isDown ? p.y > from.y || (p.y == from.y && p.x == from.x) : p.y <= from.y) continue;
            if (orientation(low, high, p) > 0.0) continue; // beyond the edge
            const double before = turn * orientation(from, p, _points[first]);
            if (before > 0.0 || (before == 0.0 && distance2(from, p) < distance2(from, _points[first])))
                first = visit.point;
        }
        return first;
    }

    static double distance2(const glm::dvec2& a, const glm::dvec2& b) { return glm::dot(a - b, a - b); }

    /// Joins a hole: the loop becomes …, outer, hole, around it, hole again, outer again, …
    void splice(std::uint32_t outer, std::uint32_t hole)
    {
        const auto holeAgain = static_cast<std::uint32_t>(_visits.size()), outerAgain = holeAgain + 1;
        const std::uint32_t beforeHole = _visits[hole].previous, behindOuter = _visits[outer].next;
        _visits.push_back({_visits[hole].point, beforeHole, outerAgain});
        _visits.push_back({_visits[outer].point, holeAgain, behindOuter});
        _visits[beforeHole].next = holeAgain;
        _visits[behindOuter].previous = outerAgain;
        _visits[outer].next = hole;
        _visits[hole].previous = outer;
    }

    std::span<const glm::dvec2> _points;
    std::vector<Visit> _visits;
    std::vector<std::uint32_t> _firsts; ///< the leftmost visit of each loop, from left to right
};

} // namespace

std::vector<Loop> bridgeHoles(std::span<const glm::dvec2> points, std::span<const Loop> loops)
{
    return Bridger(points, loops).run();
}

} // namespace osgPMObjects::core
