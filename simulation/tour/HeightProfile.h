// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/tour/FlightPlan.h"
#include "simulation/tour/TourScale.h"
#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// The heights along a flight path: first high, then medium, a low pass, and up again, above the ground
/// below, beside and ahead. Invariant (within rounding), checked by isWithin(): every sample keeps the
/// clearance of the scale above the ground below and above the ground within a third of the medium height to
/// either side; slopes keep the climb and sink of the scale.
struct HeightProfile
{
    std::vector<double> groundM; ///< highest ground across the corridor at each sample of the plan
    std::vector<double> heightM; ///< of the flight, z in the scene's frame
    double stepM = 0.0;

    double smallestClearanceM() const;
    double largestClimb() const; ///< rise over run
    double largestSink() const;
    bool isWithin(const TourScale& scale) const;

    /// Returns the mean difference from the wanted heights above ground, as a share of the medium height.
    double excess = 0.0;
};

HeightProfile heightProfile(const FlightPlan& plan, const TourTerrain& terrain, const TourScale& scale);

} // namespace simulation
