// SPDX-License-Identifier: Apache-2.0
#include "UniteConvex.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

namespace osgPMObjects::core
{

namespace
{

/// Removes sides between pieces as long as the united piece is convex. Source: see uniteConvex().
class Uniter
{
public:
    Uniter(std::span<const glm::dvec2> points, std::span<const Loop> pieces) : _points(points)
    {
        for (const Loop& piece : pieces)
        {
            const auto first = static_cast<std::uint32_t>(_sides.size());
            const auto size = static_cast<std::uint32_t>(piece.size());
            for (std::uint32_t i = 0; i < size; ++i)
                _sides.push_back({piece[i], first + (i + size - 1) % size, first + (i + 1) % size});
        }
    }

    std::vector<Loop> run()
    {
        for (const auto& [side, twin] : twins())
            if (staysConvex(side, twin) && staysConvex(twin, side)) unite(side, twin);
        std::vector<Loop> pieces;
        for (std::uint32_t first = 0; first < _sides.size(); ++first)
        {
            if (!_sides[first].exists) continue;
            Loop& piece = pieces.emplace_back();
            for (std::uint32_t side = first; _sides[side].exists; side = _sides[side].next)
            {
                _sides[side].exists = false;
                piece.push_back(_sides[side].from);
            }
        }
        return pieces;
    }

private:
    struct Side
    {
        std::uint32_t from, previous, next;
        bool exists = true;
    };

    std::uint32_t to(std::uint32_t side) const { return _sides[_sides[side].next].from; }

    /// Returns pairs of sides that run along one another in opposite directions, in the order of the first.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> twins() const
    {
        std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> byEnds;
        for (std::uint32_t side = 0; side < _sides.size(); ++side)
            byEnds.emplace_back(std::min(_sides[side].from, to(side)), std::max(_sides[side].from, to(side)),
                                side);
        std::sort(byEnds.begin(), byEnds.end());
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::size_t i = 0; i + 1 < byEnds.size(); ++i)
        {
            const auto& [a, b, side] = byEnds[i];
            const auto& [c, d, twin] = byEnds[i + 1];
            if (a == c && b == d) pairs.emplace_back(side, twin);
        }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    /// Tells whether the corner at the beginning of `side` stays convex once `side` is removed.
    bool staysConvex(std::uint32_t side, std::uint32_t twin) const
    {
        return turnsLeftOrStraight(_points[_sides[_sides[side].previous].from], _points[_sides[side].from],
                                   _points[to(_sides[twin].next)]);
    }

    void unite(std::uint32_t side, std::uint32_t twin)
    {
        const auto link = [this](std::uint32_t before, std::uint32_t behind)
        {
            _sides[before].next = behind;
            _sides[behind].previous = before;
        };
        link(_sides[side].previous, _sides[twin].next);
        link(_sides[twin].previous, _sides[side].next);
        _sides[side].exists = _sides[twin].exists = false;
    }

    std::span<const glm::dvec2> _points;
    std::vector<Side> _sides;
};

} // namespace

bool turnsLeftOrStraight(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const double turn = orientation(a, b, c);
    return turn > 0.0 || (turn == 0.0 && glm::dot(b - a, c - b) > 0.0);
}

std::vector<Loop> uniteConvexPieces(std::span<const glm::dvec2> points, std::span<const Loop> pieces)
{
    return Uniter(points, pieces).run();
}

std::vector<Loop> uniteConvex(std::span<const glm::dvec2> points, std::span<const Triangle> triangles)
{
    std::vector<Loop> pieces;
    pieces.reserve(triangles.size());
    for (const Triangle& t : triangles)
        pieces.push_back({t[0], t[1], t[2]});
    return uniteConvexPieces(points, pieces);
}

} // namespace osgPMObjects::core
