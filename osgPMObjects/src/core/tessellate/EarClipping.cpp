// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <queue>
#include <tuple>

#include <osgPMObjects/core/tessellate/EarClipping.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

#include "TriangleSearch.h"

namespace osgPMObjects::core
{

namespace
{

/// Clips ears, the best-shaped first, from a priority queue. Source: see clipEars().
class Clipper
{
public:
    Clipper(std::span<const glm::dvec2> points, const Loop& loop) : _points(points)
    {
        const auto size = static_cast<std::uint32_t>(loop.size());
        _visits.reserve(size);
        for (std::uint32_t i = 0; i < size; ++i)
            _visits.push_back({loop[i], (i + size - 1) % size, (i + 1) % size, 0, true});
        _left = size;
        collectReflex();
        for (std::uint32_t i = 0; i < size; ++i)
            offer(i);
    }

    std::optional<std::vector<Triangle>> run()
    {
        while (_left > 2)
        {
            if (_ears.empty()) return std::nullopt;
            const Ear ear = _ears.top();
            _ears.pop();
            if (!_visits[ear.tip].exists || _visits[ear.tip].version != ear.version) continue;
            clip(ear.tip);
            if (2 * _left < _leftWhenCollected) collectReflex(); // keeps the cells as few as the points
        }
        return std::move(_triangles);
    }

private:
    struct Visit
    {
        std::uint32_t point, previous, next;
        std::uint32_t version; ///< number of changes of its neighbours; stale if it differs
        bool exists;
    };

    struct Ear
    {
        double shape;
        std::uint32_t tip, version;
        bool operator<(const Ear& other) const // the best ear is on top; the first of equal ones
        {
            return std::tie(shape, other.tip) < std::tie(other.shape, tip);
        }
    };

    const glm::dvec2& position(std::uint32_t visit) const { return _points[_visits[visit].point]; }

    bool isConvex(std::uint32_t i) const
    {
        return orientation(position(_visits[i].previous), position(i), position(_visits[i].next)) > 0.0;
    }

    /// Returns the quality: area over the sum of the squared sides, largest for equal sides, 0 for a sliver.
    double shape(std::uint32_t i) const
    {
        const glm::dvec2 a = position(_visits[i].previous), b = position(i), c = position(_visits[i].next);
        const double squares = glm::dot(b - a, b - a) + glm::dot(c - b, c - b) + glm::dot(a - c, a - c);
        return std::abs(orientation(a, b, c)) / squares;
    }

    void offer(std::uint32_t i)
    {
        if (isConvex(i) && isFree(i)) _ears.push({shape(i), i, _visits[i].version});
    }

    /// Tells whether no other point lies in or on the triangle at `i`. Other visits of its own corners need
    /// no test: an edge that leads from one of them into the triangle ends inside it.
    bool isFree(std::uint32_t i)
    {
        const std::uint32_t corners[3] = {_visits[_visits[i].previous].point, _visits[i].point,
                                          _visits[_visits[i].next].point};
        const glm::dvec2 &a = _points[corners[0]], &b = _points[corners[1]], &c = _points[corners[2]];
        const glm::dvec2 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
        return !_reflex.visit(
            a, b, c,
            [&](std::uint32_t number)
            {
                using Verdict = TriangleSearch::Verdict;
                const Visit& visit = _visits[number];
                if (!visit.exists || isConvex(number))
                    return Verdict::takeOut; // sectors only shrink, except by withoutSpike()
                const glm::dvec2& p = _points[visit.point];
                if (p.x < low.x || p.y < low.y || p.x > high.x || p.y > high.y) return Verdict::goOn;
                if (visit.point == corners[0] || visit.point == corners[1] || visit.point == corners[2])
                    return Verdict::goOn;
                const bool isIn =
                    orientation(a, b, p) >= 0.0 && orientation(b, c, p) >= 0.0 && orientation(c, a, p) >= 0.0;
                return isIn ? Verdict::stop : Verdict::goOn;
            });
    }

    void collectReflex()
    {
        std::vector<TriangleSearch::Entry> reflex;
        for (std::uint32_t i = 0; i < _visits.size(); ++i)
            if (_visits[i].exists && !isConvex(i)) reflex.push_back({i, position(i)});
        _reflex = TriangleSearch(reflex);
        _leftWhenCollected = _left;
    }

    void clip(std::uint32_t tip)
    {
        const std::uint32_t before = _visits[tip].previous, behind = _visits[tip].next;
        _triangles.push_back({_visits[before].point, _visits[tip].point, _visits[behind].point});
        remove(tip);
        const std::uint32_t first = withoutSpike(before);
        if (_left > 2 && _visits[behind].exists && behind != first) changed(withoutSpike(behind));
        if (_left > 2 && _visits[first].exists) changed(first);
    }

    void remove(std::uint32_t visit)
    {
        const Visit& v = _visits[visit];
        _visits[v.previous].next = v.next;
        _visits[v.next].previous = v.previous;
        _visits[visit].exists = false;
        --_left;
    }

    /// Removes the edge at `i` along which the loop turns back onto itself. Returns the visit that replaces
    /// `i`.
    std::uint32_t withoutSpike(std::uint32_t i)
    {
        while (_left > 2 && _visits[_visits[i].previous].point == _visits[_visits[i].next].point)
        {
            const std::uint32_t before = _visits[i].previous;
            remove(_visits[i].next);
            remove(i);
            i = before;
            if (!isConvex(i)) _reflex.add({i, position(i)}); // its sector grew by that of the removed visit
        }
        return i;
    }

    void changed(std::uint32_t i)
    {
        ++_visits[i].version;
        offer(i);
    }

    std::span<const glm::dvec2> _points;
    std::vector<Visit> _visits;
    TriangleSearch _reflex{{}}; ///< the reflex visits, and perhaps some that are convex by now
    std::uint32_t _leftWhenCollected = 0;
    std::priority_queue<Ear> _ears;
    std::vector<Triangle> _triangles;
    std::uint32_t _left = 0;
};

} // namespace

std::optional<std::vector<Triangle>> clipEars(std::span<const glm::dvec2> points, const Loop& loop)
{
    return Clipper(points, loop).run();
}

} // namespace osgPMObjects::core
