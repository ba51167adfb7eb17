// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetProfile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace worldmaking
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;

constexpr double kFadeM = 25.0; ///< over which a road turns out of the plane of a crossing
constexpr int kSmoothings = 2;

/// Rounds bends; the two nodes at each end stay.
void smooth(std::vector<double>& heights)
{
    for (int pass = 0; pass < kSmoothings; ++pass)
    {
        const std::vector<double> old = heights;
        for (std::size_t k = 2; k + 2 < heights.size(); ++k)
            heights[k] = 0.25 * (old[k - 1] + 2.0 * old[k] + old[k + 1]);
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

CubicProfile superelevationOf(const HeightRow& row, const EndPlanes& planes)
{
    const double lengthM = row.lengthM(), fadeM = std::min(kFadeM, 0.5 * lengthM);
    const double start = planes.start ? std::atan(planes.start->leanAcross(row.points.front())) : 0.0;
    const double end = planes.end ? std::atan(planes.end->leanAcross(row.points.back())) : 0.0;
    if (start == 0.0 && end == 0.0) return {};
    const double two = fadeM * fadeM, three = two * fadeM;
    std::vector<Cubic> pieces = {{0.0, start, 0.0, -3.0 * start / two, 2.0 * start / three}};
    if (lengthM > 2.0 * fadeM) pieces.push_back({fadeM, 0.0, 0.0, 0.0, 0.0});
    pieces.push_back({lengthM - fadeM, 0.0, 0.0, 3.0 * end / two, -2.0 * end / three});
    return CubicProfile(std::move(pieces));
}

} // namespace

StreetProfile profileOf(const HeightRow& row, std::vector<double> heightsM, const EndPlanes& planes)
{
    smooth(heightsM);
    return {elevationOf(row, std::move(heightsM), planes), superelevationOf(row, planes)};
}

} // namespace worldmaking
