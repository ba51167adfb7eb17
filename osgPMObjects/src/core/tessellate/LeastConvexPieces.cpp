// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

#include "EdgeContacts.h"
#include "UniteConvex.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kImpossible = std::numeric_limits<std::uint32_t>::max() / 4;

/// A square table with a row and a column for each visit of the loop.
class Square
{
public:
    Square(std::size_t size, std::uint32_t value) : _size(size), _values(size * size, value) {}
    std::uint32_t& operator()(std::size_t row, std::size_t column) { return _values[row * _size + column]; }
    std::uint32_t operator()(std::size_t row, std::size_t column) const
    {
        return _values[row * _size + column];
    }

private:
    std::size_t _size;
    std::vector<std::uint32_t> _values;
};

/// Solves the sub-polygons of a loop by dynamic programming. Source: see leastConvexPieces().
class LeastPieces
{
public:
    LeastPieces(std::span<const glm::dvec2> points, const Loop& loop)
        : _points(points),
          _loop(loop),
          _count(static_cast<std::uint32_t>(loop.size())),
          _best(_count, kImpossible)
    {
        findWays();
        for (std::uint32_t span = 2; span < _count; ++span)
            for (std::uint32_t i = 0; i + span < _count; ++i)
                if (const std::uint32_t j = i + span; _best(i, j) == kMayBe || span + 1 == _count)
                    _best(i, j) = convexChain(i, j).pieces;
    }

    std::optional<std::vector<Loop>> run() const
    {
        if (_best(0, _count - 1) >= kImpossible) return std::nullopt;
        std::vector<Loop> pieces;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, _count - 1}};
        while (!open.empty())
        {
            const auto [i, j] = open.back();
            open.pop_back();
            Loop& piece = pieces.emplace_back();
            const std::vector<std::uint32_t> visits = convexChain(i, j).visits;
            for (std::size_t k = 0; k < visits.size(); ++k)
            {
                piece.push_back(_loop[visits[k]]);
                if (k + 1 < visits.size() && visits[k + 1] > visits[k] + 1)
                    open.emplace_back(visits[k], visits[k + 1]);
            }
        }
        return pieces;
    }

private:
    static constexpr std::uint32_t kMayBe = kImpossible - 1; ///< a diagonal that is not solved yet

    /// The piece at a diagonal, and the cost behind its other sides.
    struct Chain
    {
        std::uint32_t pieces = kImpossible;
        std::vector<std::uint32_t> visits; ///< from i to j
    };

    const glm::dvec2& position(std::uint32_t visit) const { return _points[_loop[visit]]; }
    bool turnsLeft(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return turnsLeftOrStraight(position(a), position(b), position(c));
    }

    /// Returns the edges and the useful diagonals: between two convex corners none is needed.
    void findWays()
    {
        std::vector<EdgeEnds> edges;
        std::vector<char> isConvex;
        for (std::uint32_t i = 0; i < _count; ++i)
        {
            edges.push_back({_loop[i], _loop[(i + 1) % _count]});
            isConvex.push_back(turnsLeft((i + _count - 1) % _count, i, (i + 1) % _count));
        }
        for (std::uint32_t i = 0; i + 1 < _count; ++i)
        {
            _best(i, i + 1) = 0;
            for (std::uint32_t j = i + 2; j < _count; ++j)
                if (!(isConvex[i] && isConvex[j]) && isDiagonal(i, j, edges)) _best(i, j) = kMayBe;
        }
    }

    bool looksAt(std::uint32_t i, std::uint32_t j) const
    {
        return isInSector(position((i + _count - 1) % _count), position(i), position((i + 1) % _count),
                          position(j));
    }

    bool isDiagonal(std::uint32_t i, std::uint32_t j, const std::vector<EdgeEnds>& edges) const
    {
        if (_loop[i] == _loop[j] || !looksAt(i, j) || !looksAt(j, i)) return false;
        return std::none_of(edges.begin(), edges.end(),
                            [&](const EdgeEnds& edge) {
                                return contactOf(_points, {_loop[i], _loop[j]}, edge).exists();
                            });
    }

    /// Returns the convex chain of visits from i to j with the fewest pieces behind its sides; closed by the
    /// diagonal from j to i it is a piece.
    Chain convexChain(std::uint32_t i, std::uint32_t j) const
    {
        const std::uint32_t size = j - i + 1;
        // By the last two visits of a chain, counted from i: its cost, and the visit before them.
        Square cost(size, kImpossible), before(size, 0);
        for (std::uint32_t q = 1; q < size; ++q)
            if (_best(i, i + q) < kMayBe && q + 1 < size && turnsLeft(j, i, i + q))
                cost(q, 0) = _best(i, i + q);
        for (std::uint32_t p = 1; p + 1 < size; ++p)
            for (std::uint32_t q = p + 1; q < size; ++q)
            {
                if (_best(i + p, i + q) >= kMayBe) continue;
                for (std::uint32_t o = 0; o < p; ++o)
                {
                    const std::uint32_t sum = cost(p, o) + _best(i + p, i + q);
                    if (sum >= cost(q, p) || !turnsLeft(i + o, i + p, i + q)) continue;
                    cost(q, p) = sum;
                    before(q, p) = o;
                }
            }
        Chain chain;
        std::uint32_t last = 0;
        for (std::uint32_t p = 1; p + 1 < size; ++p)
            if (cost(size - 1, p) + 1 < chain.pieces && turnsLeft(i + p, j, i))
            {
                chain.pieces = cost(size - 1, p) + 1;
                last = p;
            }
        if (chain.pieces >= kImpossible) return {};
        for (std::uint32_t q = size - 1, p = last; q != 0; q = std::exchange(p, before(q, p)))
            chain.visits.push_back(i + q);
        chain.visits.push_back(i);
        std::reverse(chain.visits.begin(), chain.visits.end());
        return chain;
    }

    std::span<const glm::dvec2> _points;
    const Loop& _loop;
    std::uint32_t _count;
    Square _best; ///< least pieces of the part from visit i to j > i that the diagonal i–j cuts off
};

} // namespace

std::optional<std::vector<Loop>> leastConvexPieces(std::span<const glm::dvec2> points, const Loop& loop)
{
    if (loop.size() < 3 || loop.size() > kMostCornersForLeastPieces) return std::nullopt;
    return LeastPieces(points, loop).run();
}

} // namespace osgPMObjects::core
