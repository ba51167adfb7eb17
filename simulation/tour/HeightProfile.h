// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/tour/FlightPlan.h"
#include "simulation/tour/TourScale.h"
#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// Heights along a flight plan: a high overview, down through a medium height to a low pass, and up again, all above
/// the ground that lies below, to the sides and ahead.
/// Invariant: no closer to the ground than the scale's clearance at any sample, nor to that within a third of the
/// medium height to either side; slopes within the scale's climb and sink (all within rounding). isWithin() checks.
struct HeightProfile
{
    std::vector<double> groundM; ///< highest ground across the corridor at each sample of the plan
    std::vector<double> heightM; ///< of the flight, z in the scene's frame
    double stepM = 0.0;

    double smallestClearanceM() const;
    double largestClimb() const; ///< rise over run
    double largestSink() const;
    bool isWithin(const TourScale& scale) const;

    /// How far the flight is, on average, from the heights above ground that were wanted, in medium heights.
    double excess = 0.0;
};

HeightProfile heightProfile(const FlightPlan& plan, const TourTerrain& terrain, const TourScale& scale);

} // namespace simulation
