// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace worldmaking
{

/// What a runway of some length may do along and across. Units: metres; slopes in metres a metre.
struct RunwayLimits
{
    int code = 1;               ///< 1 to 4, by length
    double slope = 0.02;        ///< of any part
    double endSlope = 0.02;     ///< of the first and the last quarter
    double leastRadiusM = 7500; ///< of vertical curves
    double crossfall = 0.015;
    double stripHalfM = 30.0; ///< of graded ground, from the centre line
    double stripEndM = 60.0;  ///< of graded ground beyond the ends
    double stripFall = 0.015;
};

/// Source: ICAO, *Annex 14*, volume I, 8th edition, 3.1.13 to 3.1.18 and 3.4.3 to 3.4.11 (from memory of its
/// figures).
RunwayLimits runwayLimits(double lengthM);

/// The heights of a runway.
struct RunwayProfile
{
    std::vector<double> heightsM; ///< at the stations
    bool isSteep = false;         ///< the ground leaves no room for the limits: its own slope, straight
};

/// Fits heights to those of the ground at even stations: as near to them as the limits of slope and curvature
/// allow, in the sense of least squares with the smallest penalty on curvature that meets the limits. A
/// straight line steeper than the limit gets the limit, unless its ends would then lie more than kMostEarthM
/// above or below the ground's.
/// Source: Eilers & Marx, *Flexible smoothing with B-splines and penalties*, 1996, with splines of degree 0.
/// Differs: the penalty is found from limits. Cost: some milliseconds.
RunwayProfile runwayProfile(std::span<const double> groundM, double stationM, const RunwayLimits& limits);

/// Smooths heights at even stations: the least squares of their weighted distances, plus `penalty` times
/// those of second differences.
/// `weights`: of each station, above 0; large ones pin it.
std::vector<double> smoothedHeights(std::span<const double> groundM, std::span<const double> weights,
                                    double penalty);

inline constexpr double kMostEarthM = 12.0;

} // namespace worldmaking
