// SPDX-License-Identifier: Apache-2.0
#include "StripCut.h"

#include <algorithm>
#include <cmath>

namespace osgRoads::core
{

namespace
{

constexpr int kHalvings = 5;         ///< 8 cm of a verge of 2.5 m
constexpr int kHalvingsOfRaised = 8; ///< of lanes, and of verges that lie higher than lanes
constexpr double kBeyond = 0.1;
constexpr double kBeyondM = 0.02;    ///< of lanes: between two rows the cut is no straight line
constexpr std::size_t kDrawnRow = 2; ///< every second one is drawn

/// Returns what a covered vertex needs beside one that is drawn, so that the line between both is cut where
/// the cover begins, found by halving, or `beyond` of the line farther.
template<class IsCoveredAt>
double presentBeside(const IsCoveredAt& isCoveredAt, int halvings, double beyond)
{
    constexpr double kWhole = 255.0, kCut = 127.5;
    double drawn = 0.5, covered = 1.0;
    if (isCoveredAt(drawn)) return 0.0;
    for (int i = 1; i < halvings; ++i)
    {
        const double middle = 0.5 * (drawn + covered);
        (isCoveredAt(middle) ? covered : drawn) = middle;
    }
    return kWhole - kCut / std::min(covered + beyond, 1.0);
}

} // namespace

bool StripCut::isCovered(const ChunkRow& row, std::size_t column) const
{
    return _cover.covers(row.s, row.points[column].t, JunctionCover::By::paving);
}

/// Returns the place across the road that lies a share of the way from the other border to this one.
double StripCut::tBetween(const Place& place, double way) const
{
    const ChunkRow& row = _rows.rows()[place.row];
    return std::lerp(row.points[place.across].t, row.points[place.column].t, way);
}

bool StripCut::isRaised(const Place& place) const
{
    return _rows.rows()[place.row].points[place.across].h > kBeyondM;
}

StripCut::Ends StripCut::ofRaisedVerge(const Place& place) const
{
    constexpr double kWhole = 255.0, kCut = 127.5;
    const ChunkRow& row = _rows.rows()[place.row];
    double drawn = 0.0, covered = 1.0;
    for (int i = 0; i < kHalvingsOfRaised; ++i)
    {
        const double middle = 0.5 * (drawn + covered);
        (_cover.covers(row.s, tBetween(place, middle), JunctionCover::By::paving) ? covered : drawn) = middle;
    }
    const auto byte = [](double present) { return static_cast<std::uint8_t>(std::lround(present)); };
    if (covered >= 0.5) return {byte(kWhole - kCut / covered), byte(kWhole)};
    return {0, byte(kCut / (1.0 - covered))};
}

std::uint8_t StripCut::ofVerge(const Place& place, bool isCoveredAcross) const
{
    const ChunkRow& here = _rows.rows()[place.row];
    double present = 0.0;
    if (!isCoveredAcross)
        present =
            presentBeside([&](double way)
                          { return _cover.covers(here.s, tBetween(place, way), JunctionCover::By::paving); },
                          kHalvings, kBeyond);
    const auto lookAlong = [&](const ChunkRow& next)
    {
        if (isCovered(next, place.column)) return;
        present = std::max(
            present,
            presentBeside([&](double way)
                          { return isCovered(_rows.rowAt(std::lerp(next.s, here.s, way)), place.column); },
                          kHalvings, kBeyond));
    };
    if (place.row >= kDrawnRow) lookAlong(_rows.rows()[place.row - kDrawnRow]);
    if (place.row + kDrawnRow < _rows.rows().size()) lookAlong(_rows.rows()[place.row + kDrawnRow]);
    return static_cast<std::uint8_t>(std::lround(present));
}

std::uint8_t StripCut::ofLane(const Place& place) const
{
    const ChunkRow& row = _rows.rows()[place.row];
    const double widthM = std::fabs(row.points[place.column].t - row.points[place.across].t);
    if (widthM < kBeyondM) return 0;
    return static_cast<std::uint8_t>(std::lround(
        presentBeside([&](double way)
                      { return _cover.covers(row.s, tBetween(place, way), JunctionCover::By::carriageway); },
                      kHalvingsOfRaised, kBeyondM / widthM)));
}

} // namespace osgRoads::core
