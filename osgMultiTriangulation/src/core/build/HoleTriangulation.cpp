// SPDX-License-Identifier: Apache-2.0
#include "HoleTriangulation.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr int kCodeBits = 4; ///< of a corner

double areaOf(const HoleTriangulation::Point& a, const HoleTriangulation::Point& b,
              const HoleTriangulation::Point& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Goes through the triangles of a triangulation of corners 0 … count - 1, by middle(i, k, number): the third
/// corner of the triangle at i–k.
template<class Middle>
void visitPieces(int count, const Middle& middle)
{
    std::array<std::pair<int, int>, HoleTriangulation::kMostCorners>
        open; // sides of pieces still to be found
    std::size_t opens = 1, number = 0;
    open[0] = {0, count - 1};
    while (opens > 0)
    {
        const auto [i, k] = open[--opens];
        if (k - i < 2) continue;
        const int j = middle(i, k, number++);
        open[opens++] = {i, j};
        open[opens++] = {j, k};
    }
}

} // namespace

HoleTriangulation::Plane HoleTriangulation::planeOf(const Point& a, const Point& b, const Point& c)
{
    const double abX = b.x - a.x, abY = b.y - a.y, abH = b.height - a.height;
    const double acX = c.x - a.x, acY = c.y - a.y, acH = c.height - a.height;
    const double area = abX * acY - abY * acX;
    const double slopeX = (abH * acY - acH * abY) / area, slopeY = (abX * acH - acX * abH) / area;
    return {slopeX, slopeY, a.height - slopeX * a.x - slopeY * a.y};
}

void HoleTriangulation::begin(std::span<const Point> corners)
{
    assert(corners.size() >= 3 && corners.size() <= kMostCorners);
    std::ranges::copy(corners, _corners.begin());
    const int count = _count = static_cast<int>(corners.size());
    _points = _taken = 0;
    int number = 0;
    for (int i = 0; i + 2 < count; ++i)
        for (int j = i + 1; j + 1 < count; ++j)
        {
            const Point &a = _corners[i], &b = _corners[j];
            _lines[i][j] = lineOf(a, b);
            _base[i][j] = number - (j + 1);
            for (int k = j + 1; k < count; ++k, ++number)
            {
                Candidate& piece = _candidates[number];
                piece.errors = piece.squares = Lanes{};
                piece.isProper = areaOf(a, b, _corners[k]) > 0.0;
                piece.plane = piece.isProper ? planeOf(a, b, _corners[k]) : Plane{};
            }
        }
    for (int i = 1; i + 1 < count; ++i)
        _lines[i][count - 1] = lineOf(_corners[i], _corners[count - 1]);
}

void HoleTriangulation::add(const Point& point)
{
    assert(_points < kMostPoints);
    PointLanes& block = _blocks[_points / kLanes];
    const std::size_t lane = _points++ % kLanes;
    if (lane == 0) block = PointLanes{};
    block.set(lane, point.x, point.y, point.height);
}

/// Lets candidates know of points that were added since the last time.
OSGTRAINER_WIDE void HoleTriangulation::take()
{
    for (; _taken * kLanes < _points; ++_taken)
        take(_blocks[_taken]);
    _points = _taken * kLanes; // further ones begin another block
    for (int c = 0; c < _count * (_count - 1) * (_count - 2) / 6; ++c)
    {
        Candidate& piece = _candidates[c];
        const Lanes &e = piece.errors, &s = piece.squares;
        piece.error = std::max(std::max(e[0], e[1]), std::max(e[2], e[3]));
        piece.sum = (s[0] + s[1]) + (s[2] + s[3]);
    }
}

[[gnu::always_inline]] inline void HoleTriangulation::take(const PointLanes& points)
{
    // left[i][j]: the points left of i→j. Sides of the polygon have all on their left, the last side from 0
    // on its right.
    std::array<std::array<LaneMask, kMostCorners>, kMostCorners> left;
    for (int i = 0; i + 1 < _count; ++i)
    {
        left[i][i + 1] = points.isThere;
        for (int j = i + 2; j < _count; ++j)
        {
            const Line& line = _lines[i][j];
            left[i][j] = (line.x * points.x + line.y * points.y >= line.least) & points.isThere;
        }
    }
    left[0][_count - 1] = LaneMask{};
    Candidate* piece = _candidates.data();
    for (int i = 0; i + 2 < _count; ++i)
        for (int j = i + 1; j + 1 < _count; ++j)
            for (int k = j + 1; k < _count; ++k, ++piece)
            {
                const LaneMask isIn = left[i][j] & left[j][k] & ~left[i][k];
                const Plane& plane = piece->plane;
                const Lanes away =
                    plane.slopeX * points.x + plane.slopeY * points.y + plane.base - points.height;
                const auto error = (Lanes)((LaneMask)away & kWithoutSign & isIn);
                piece->errors = piece->errors > error ? piece->errors : error;
                piece->squares += error * error;
            }
}

bool HoleTriangulation::solve()
{
    take();
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
                const double squares = piece.sum + before.squares + behind.squares;
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
    take();
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
            squares += piece.sum;
        }
        if (!isProper || (error == best.error && squares >= best.squares)) continue;
        best = {error, squares, apex};
        _apex = apex;
    }
    return best.middle >= 0;
}

HoleTriangulation::Pieces HoleTriangulation::piecesOfFan(std::uint32_t code, int count)
{
    Pieces found;
    const int apex = static_cast<int>(code);
    for (int i = (apex + 1) % count; (i + 1) % count != apex; i = (i + 1) % count)
    {
        std::array<std::uint8_t, 3> corners{static_cast<std::uint8_t>(apex), static_cast<std::uint8_t>(i),
                                            static_cast<std::uint8_t>((i + 1) % count)};
        std::ranges::sort(corners);
        found.all[found.count++] = {corners[0], corners[1], corners[2]};
    }
    return found;
}

std::uint32_t HoleTriangulation::code() const
{
    std::uint32_t code = 0;
    visitPieces(_count,
                [&](int i, int k, std::size_t piece)
                {
                    const int j = _best[i][k].middle;
                    code |= static_cast<std::uint32_t>(j) << (kCodeBits * piece);
                    return j;
                });
    return code;
}

HoleTriangulation::Pieces HoleTriangulation::pieces(std::uint32_t code, int count)
{
    Pieces found;
    visitPieces(count,
                [&](int i, int k, std::size_t piece)
                {
                    const int j = static_cast<int>(code >> (kCodeBits * piece)) & 15;
                    found.all[found.count++] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                                                static_cast<std::uint8_t>(k)};
                    return j;
                });
    return found;
}

} // namespace osgMultiTriangulation::core
