// SPDX-License-Identifier: Apache-2.0
#include "HoleTriangulation.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace osgMultiTriangulation::core
{

void HoleTriangulation::begin(int count)
{
    assert(count >= 3 && count <= kMostCorners);
    _count = count;
    int number = 0;
    for (int i = 0; i + 2 < count; ++i)
        for (int j = i + 1; j + 1 < count; ++j)
        {
            _base[i][j] = number - (j + 1);
            const Point &a = _corners[i], &b = _corners[j];
            const double abX = b.x - a.x, abY = b.y - a.y, abH = b.height - a.height;
            for (int k = j + 1; k < count; ++k, ++number)
            {
                const Point& c = _corners[k];
                const double acX = c.x - a.x, acY = c.y - a.y, acH = c.height - a.height;
                const double area = abX * acY - abY * acX;
                Candidate& piece = _candidates[number];
                piece.error = piece.squares = 0.0;
                piece.isProper = area > 0.0;
                if (!piece.isProper) continue;
                piece.slopeX = (abH * acY - acH * abY) / area;
                piece.slopeY = (abX * acH - acX * abH) / area;
                piece.base = a.height - piece.slopeX * a.x - piece.slopeY * a.y;
            }
        }
}

void HoleTriangulation::add(const Point& point)
{
    // Bit j of left[i]: the point lies left of i→j. Sides of the polygon have it on their left, the last side from 0 on its right.
    std::array<unsigned, kMostCorners> left;
    for (int i = 0; i + 1 < _count; ++i)
    {
        left[i] = 2u << i;
        for (int j = i + 2; j < _count; ++j)
            left[i] |= static_cast<unsigned>(isLeft(i, j, point)) << j;
    }
    left[0] &= ~(1u << (_count - 1));
    for (int i = 0; i + 2 < _count; ++i)
        for (unsigned js = left[i] & ((1u << (_count - 1)) - 1); js != 0; js &= js - 1)
        {
            const int j = std::countr_zero(js);
            for (unsigned ks = left[j] & ~left[i]; ks != 0; ks &= ks - 1)
            {
                Candidate& piece = candidate(i, j, std::countr_zero(ks));
                const double error =
                    std::abs(piece.slopeX * point.x + piece.slopeY * point.y + piece.base - point.height);
                piece.error = std::max(piece.error, error);
                piece.squares += error * error;
            }
        }
}

bool HoleTriangulation::solve()
{
    for (int i = 0; i + 1 < _count; ++i)
        _best[i][i + 1] = {0.0, 0.0, i};
    for (int length = 2; length < _count; ++length)
        for (int i = 0; i + length < _count; ++i)
        {
            const int k = i + length;
            Part best{std::numeric_limits<double>::max(), 0.0, -1};
            for (int j = i + 1; j < k; ++j)
            {
                const Candidate& piece = candidate(i, j, k);
                const Part &before = _best[i][j], &behind = _best[j][k];
                if (!piece.isProper || before.middle < 0 || behind.middle < 0) continue;
                const double error = std::max({piece.error, before.error, behind.error});
                if (error > best.error) continue;
                const double squares = piece.squares + before.squares + behind.squares;
                if (error < best.error || squares < best.squares) best = {error, squares, j};
            }
            _best[i][k] = best;
        }
    return _best[0][_count - 1].middle >= 0;
}

HoleTriangulation::Candidate& HoleTriangulation::fanPiece(int apex, int i)
{
    const int next = (i + 1) % _count;
    if (next == 0) return candidate(0, apex, i);
    return apex < i ? candidate(apex, i, next) : candidate(i, next, apex);
}

bool HoleTriangulation::solveFan(bool isAtBorder)
{
    Part& best = _best[0][_count - 1] = {std::numeric_limits<double>::max(), 0.0, -1};
    for (int apex = 0; apex < _count; apex += isAtBorder ? _count - 1 : 1)
    {
        double error = 0.0, squares = 0.0;
        bool isProper = true;
        for (int i = (apex + 1) % _count; isProper && (i + 1) % _count != apex; i = (i + 1) % _count)
        {
            const Candidate& piece = fanPiece(apex, i);
            isProper = piece.isProper && piece.error <= best.error;
            error = std::max(error, piece.error);
            squares += piece.squares;
        }
        if (!isProper || (error == best.error && squares >= best.squares)) continue;
        best = {error, squares, apex};
        _apex = apex;
    }
    return best.middle >= 0;
}

std::span<const HoleTriangulation::Piece> HoleTriangulation::piecesOfFan()
{
    std::size_t found = 0;
    for (int i = (_apex + 1) % _count; (i + 1) % _count != _apex; i = (i + 1) % _count)
    {
        std::array<std::uint8_t, 3> corners{static_cast<std::uint8_t>(_apex), static_cast<std::uint8_t>(i),
                                            static_cast<std::uint8_t>((i + 1) % _count)};
        std::ranges::sort(corners);
        _pieces[found++] = {corners[0], corners[1], corners[2], fanPiece(_apex, i).error};
    }
    return std::span(_pieces).first(found);
}

std::span<const HoleTriangulation::Piece> HoleTriangulation::pieces()
{
    std::array<std::pair<int, int>, kMostCorners> open; // sides of pieces still to be found
    std::size_t opens = 1, found = 0;
    open[0] = {0, _count - 1};
    while (opens > 0)
    {
        const auto [i, k] = open[--opens];
        if (k - i < 2) continue;
        const int j = _best[i][k].middle;
        _pieces[found++] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                            static_cast<std::uint8_t>(k), candidate(i, j, k).error};
        open[opens++] = {i, j};
        open[opens++] = {j, k};
    }
    return std::span(_pieces).first(found);
}

} // namespace osgMultiTriangulation::core
