// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/tour/FlightPlan.h"
#include "simulation/tour/HeightProfile.h"

namespace simulation
{

/// Finds paths past the sights of a terrain, the best for each place where one may begin. A path is flown in
/// kLegs legs, in each of which the turn rate goes over evenly to another, none above that of the scale; from
/// all ways that begin before a sight those are followed that show the most (a beam search). A sight counts
/// while it lies ahead, within 32 degrees, at a distance at which one sees all of it, and the less the longer
/// it was seen; what is seen after ten seconds counts less. Relief ahead counts a little, too, and the edge
/// of the terrain against a path. `FlightPlan::highlight`: the sight that one sees the most of.
/// Empty: no path stays inside. Source of the search: Lowerre, *The HARPY speech recognition system*, 1976.
/// Cost: some 0.3 s. Deterministic.
std::vector<FlightPlan> sightPlans(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale,
                                   double durationS);

/// Returns how much of its sights a flight shows, as sightPlans() counts it, but from the heights flown and
/// with what hills hide.
double shownSights(const FlightPlan& plan, const HeightProfile& profile, const TourTerrain& terrain,
                   const TourScale& scale, double durationS);

} // namespace simulation
