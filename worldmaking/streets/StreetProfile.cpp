// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetProfile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "worldmaking/streets/ConnectingRoad.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;

constexpr double kFadeM = 25.0; ///< over which a road turns out of the plane of a crossing
constexpr int kSmoothings = 2;

/// Rounds bends; the nodes that are held in planes stay.
void smooth(const HeightRow& row, std::vector<double>& heights)
{
    for (int pass = 0; pass < kSmoothings; ++pass)
    {
        const std::vector<double> old = heights;
        for (std::size_t k = 2; k + 2 < heights.size(); ++k)
            if (!row.isHeld(k)) heights[k] = 0.25 * (old[k - 1] + 2.0 * old[k] + old[k + 1]);
    }
}

/// Sets the coefficients of held nodes so that the spline lies in the planes: less a sixth of the second
/// differences of the plane along the line, which bends.
void layHeld(const HeightRow& row, const EndPlanes& planes, std::vector<double>& heights)
{
    const bool isOnePlane = planes.isOne();
    const std::size_t last = row.last();
    for (std::size_t k = 1; k < last; ++k)
    {
        const bool isOfStart = k <= row.heldStart || (isOnePlane && 2 * k <= last);
        const bool isOfEnd = k + row.heldEnd >= last || isOnePlane;
        const CrossingPlane* plane = isOfStart ? planes.start : isOfEnd ? planes.end : nullptr;
        if (!plane) continue;
        const auto at = [&](std::size_t node) { return plane->at(row.points[node].position); };
        heights[k] = at(k) - (at(k - 1) - 2.0 * at(k) + at(k + 1)) / 6.0;
    }
}

/// Sets the coefficient at an end, and returns that beyond it, such that the spline has the plane's height
/// and grade there.
/// `next`: the coefficient beside it. `grade`: of the plane, away from the road's inside.
double holdEnd(double& end, double next, double heightM, double outwardRiseM)
{
    const double beyond = next + 2.0 * outwardRiseM;
    end = 0.25 * (6.0 * heightM - beyond - next);
    return beyond;
}

/// The cubic of the interval in the middle of four coefficients.
Cubic pieceOf(double s, double stepM, const double* c)
{
    return {s, (c[0] + 4.0 * c[1] + c[2]) / 6.0, (c[2] - c[0]) / (2.0 * stepM),
            (c[0] - 2.0 * c[1] + c[2]) / (2.0 * stepM * stepM),
            (c[3] - c[0] + 3.0 * (c[1] - c[2])) / (6.0 * stepM * stepM * stepM)};
}

CubicProfile elevationOf(const HeightRow& row, std::vector<double> heights, const EndPlanes& planes)
{
    const std::size_t last = row.last();
    double before = 2.0 * heights[0] - heights[1], after = 2.0 * heights[last] - heights[last - 1];
    if (planes.start)
        before = holdEnd(heights[0], heights[1], planes.start->at(row.points[0].position),
                         -row.stepM * planes.start->gradeAlong(row.points[0]));
    if (planes.end)
        after = holdEnd(heights[last], heights[last - 1], planes.end->at(row.points[last].position),
                        row.stepM * planes.end->gradeAlong(row.points[last]));
    heights.insert(heights.begin(), before);
    heights.push_back(after);
    std::vector<Cubic> pieces;
    for (std::size_t k = 0; k < last; ++k)
        pieces.push_back(pieceOf(static_cast<double>(k) * row.stepM, row.stepM, heights.data() + k));
    return CubicProfile(std::move(pieces));
}

/// How a plane leans across a road at one of its nodes.
struct Lean
{
    double rad = 0.0, rate = 0.0; ///< rad/m along the road
};

Lean leanAt(const CrossingPlane* plane, const osgRoads::core::PlanPoint& point)
{
    if (!plane) return {};
    const double across = plane->leanAcross(point);
    return {std::atan(across), -point.curvature * plane->gradeAlong(point) / (1.0 + across * across)};
}

/// Collects the pieces of a road's superelevation.
class LeanPieces
{
public:
    explicit LeanPieces(const HeightRow& row) : _row(row) {}

    /// In a plane, from one node to another.
    void addHeld(const CrossingPlane* plane, std::size_t first, std::size_t last)
    {
        for (std::size_t k = first; k < last; ++k)
            add(placeOf(k), _row.stepM, leanAt(plane, _row.points[k]), leanAt(plane, _row.points[k + 1]));
    }

    /// Out of one plane, upright, and into another; straight from one to the other where there is little
    /// room.
    void addBetween(const EndPlanes& planes, std::size_t first, std::size_t last)
    {
        const Lean start = leanAt(planes.start, _row.points[first]),
                   end = leanAt(planes.end, _row.points[last]);
        const double fromM = placeOf(first), lengthM = placeOf(last) - fromM;
        if (lengthM < 2.0 * kFadeM && planes.start && planes.end) return add(fromM, lengthM, start, end);
        const double fadeM = std::min(kFadeM, 0.5 * lengthM);
        add(fromM, fadeM, start, {});
        if (lengthM > 2.0 * fadeM) add(fromM + fadeM, lengthM - 2.0 * fadeM, {}, {});
        add(fromM + lengthM - fadeM, fadeM, {}, end);
    }

    CubicProfile profile() { return _isLevel ? CubicProfile() : CubicProfile(std::move(_pieces)); }

private:
    double placeOf(std::size_t k) const { return static_cast<double>(k) * _row.stepM; }

    void add(double s, double lengthM, const Lean& from, const Lean& to)
    {
        _isLevel = _isLevel && from.rad == 0.0 && to.rad == 0.0;
        _pieces.push_back(hermitePiece(s, lengthM, from.rad, from.rate, to.rad, to.rate));
    }

    const HeightRow& _row;
    std::vector<Cubic> _pieces;
    bool _isLevel = true;
};

CubicProfile superelevationOf(const HeightRow& row, const EndPlanes& planes)
{
    LeanPieces pieces(row);
    const std::size_t last = row.last();
    if (planes.isOne())
    {
        pieces.addHeld(planes.start, 0, last);
        return pieces.profile();
    }
    // The last held node is there for the curve before it.
    const std::size_t first = planes.start ? row.heldStart - 1 : 0,
                      end = planes.end ? last + 1 - row.heldEnd : last;
    pieces.addHeld(planes.start, 0, first);
    pieces.addBetween(planes, first, end);
    pieces.addHeld(planes.end, end, last);
    return pieces.profile();
}

} // namespace

StreetProfile profileOf(const HeightRow& row, std::vector<double> heightsM, const EndPlanes& planes)
{
    smooth(row, heightsM);
    layHeld(row, planes, heightsM);
    return {elevationOf(row, std::move(heightsM), planes), superelevationOf(row, planes)};
}

} // namespace worldmaking
