// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <osgMultiTriangulation/core/input/StripDelaunay.h>

#include "CirclePolygons.h"

namespace osgMultiTriangulation::core
{

StripDelaunay::StripDelaunay(std::function<void(const Triangle&)> emit, std::uint32_t axis,
                             std::array<std::int32_t, 2> high)
    : _emit(std::move(emit)), _axis(axis), _high(high)
{
}

void StripDelaunay::add(std::span<const SurfacePoint> points)
{
    for (const SurfacePoint& point : points)
    {
        _points.push_back(point);
        _numbers.push_back(_added++);
    }
}

foundation::Outcome StripDelaunay::advance(std::int32_t next)
{
    return step(next);
}

foundation::Outcome StripDelaunay::finish()
{
    return step(std::numeric_limits<double>::infinity());
}

foundation::Outcome StripDelaunay::step(double next)
{
    triangulate(next);
    indexSides();
    if (!leaveOutFinished())
        return foundation::Error{"the triangulation of the points",
                                 "comes to two results where circles are nearly equal",
                                 "round the coordinates, or build without --memory"};
    for (const Piece& piece : _pieces)
        if (piece.isFinished && !piece.isBeyond)
            _emit({_numbers[piece.corners[0]], _numbers[piece.corners[1]], _numbers[piece.corners[2]]});
    keepFront(next);
    return foundation::success();
}

void StripDelaunay::triangulate(double next)
{
    _pieces.clear();
    visitCirclePolygons(_points,
                        [&](std::span<const std::uint32_t> around, double x, double y)
                        {
                            const SurfacePoint& first = _points[around[0]];
                            const double radius = std::hypot(x - first.x, y - first.y);
                            const double reach = (_axis == 0 ? x : y) + radius;
                            const bool isFinished = reach + 1e-6 + 1e-9 * std::abs(reach) < next;
                            for (std::size_t i = 1; i + 1 < around.size(); ++i)
                            {
                                const Triangle t{around[0], around[i], around[i + 1]};
                                if (twiceArea(_points[t[0]], _points[t[1]], _points[t[2]]) > 0.0)
                                    _pieces.push_back({t, isFinished, false});
                            }
                        });
}

void StripDelaunay::indexSides()
{
    _pieceOf.clear();
    for (std::uint32_t p = 0; p < _pieces.size(); ++p)
        for (int c = 0; c < 3; ++c)
            _pieceOf.push_back({{_pieces[p].corners[c], _pieces[p].corners[(c + 1) % 3]}, p});
    std::ranges::sort(_pieceOf);
}

/// Finds the triangle with a side; kNone: it is on the hull.
std::uint32_t StripDelaunay::pieceAt(Side side) const
{
    const auto found = std::ranges::lower_bound(_pieceOf, side, {}, &std::pair<Side, std::uint32_t>::first);
    return found != _pieceOf.end() && found->first == side ? found->second : kNone;
}

/// Marks the triangles beyond the front. Returns whether all sides of the front are there.
bool StripDelaunay::leaveOutFinished()
{
    std::vector<std::uint32_t> open;
    const auto mark = [&](std::uint32_t piece)
    {
        if (piece == kNone || _pieces[piece].isBeyond) return;
        _pieces[piece].isBeyond = true;
        open.push_back(piece);
    };
    for (const Side& side : _front)
    {
        const std::uint32_t beyond = pieceAt({side.to, side.from});
        if (beyond == kNone && pieceAt(side) == kNone) return false;
        mark(beyond);
    }
    while (!open.empty())
    {
        const Triangle corners = _pieces[open.back()].corners;
        open.pop_back();
        for (int c = 0; c < 3; ++c)
        {
            const Side opposite{corners[(c + 1) % 3], corners[c]};
            if (!std::ranges::binary_search(_front, opposite)) mark(pieceAt(opposite));
        }
    }
    return std::ranges::none_of(_front,
                                [this](const Side& side)
                                {
                                    const std::uint32_t piece = pieceAt(side);
                                    return piece != kNone && _pieces[piece].isBeyond;
                                });
}

/// Keeps the points of unfinished triangles and of the new front.
void StripDelaunay::keepFront(double next)
{
    std::vector<Side> front;
    std::vector<bool> isKept(_points.size(), false);
    for (const Side& side : _front) // the hull, still
        if (pieceAt(side) == kNone && !isHullForGood(side, next)) front.push_back(side);
    for (const Piece& piece : _pieces)
    {
        if (piece.isBeyond) continue;
        for (int c = 0; c < 3; ++c)
        {
            const Side side{piece.corners[c], piece.corners[(c + 1) % 3]}, opposite{side.to, side.from};
            const std::uint32_t other = pieceAt(opposite);
            if (!piece.isFinished)
            {
                isKept[side.from] = true;
                if (std::ranges::binary_search(_front, side) || (other != kNone && _pieces[other].isFinished))
                    front.push_back(side);
            }
            else if (other == kNone && !std::ranges::binary_search(_front, side) &&
                     !isHullForGood(opposite, next))
                front.push_back(opposite);
        }
    }
    for (const Side& side : front)
        isKept[side.from] = isKept[side.to] = true;
    if (_pieces.empty()) isKept.assign(isKept.size(), true); // all on one line so far
    std::vector<std::uint32_t> places(_points.size(), kNone);
    std::uint32_t count = 0;
    for (std::uint32_t p = 0; p < _points.size(); ++p)
    {
        if (!isKept[p]) continue;
        _points[count] = _points[p];
        _numbers[count] = _numbers[p];
        places[p] = count++;
    }
    _points.resize(count);
    _numbers.resize(count);
    _front.clear();
    for (const Side& side : front)
        _front.push_back({places[side.from], places[side.to]});
    std::ranges::sort(_front);
}

/// Whether no later point can lie outside a side of the hull, given as from outside.
bool StripDelaunay::isHullForGood(const Side& outer, double next) const
{
    if (!std::isfinite(next)) return true;
    const SurfacePoint &a = _points[outer.from], &b = _points[outer.to];
    for (const std::int32_t along : {static_cast<std::int32_t>(next), _high[_axis]})
        for (const std::int32_t across : {0, _high[1 - _axis]})
        {
            SurfacePoint corner{along, across, 0.0};
            if (_axis == 1) std::swap(corner.x, corner.y);
            if (twiceArea(a, b, corner) > 0.0) return false;
        }
    return true;
}

} // namespace osgMultiTriangulation::core
