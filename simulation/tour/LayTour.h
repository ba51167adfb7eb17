// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

struct TourOptions
{
    double durationS = 20.0; ///< 4 to 3600
};

/// Makes a flight over a terrain past the sights that it has, the first ten seconds the best (SightPlans.h),
/// or without any towards its highest and most rugged part, along a smooth path with banked turns, from high
/// to a low pass and up again; speeds and heights fit the extent (TourScale). The sun stands to the side and
/// slightly behind, at an hour of a summer day that has this sun there. The scenario has one airborne entity,
/// `ownship`, on one trajectory with times in mode `follow`, and ends by time. Positions are GeoPosition
/// where the terrain has an origin, else WorldPosition. The clearance is checked densely on the curve that is
/// played before the tour is returned. Deterministic. Cost: about a second, some 500 000 height queries.
/// Errors: a terrain without extent, heights that are not finite, a duration out of range.
foundation::Result<Tour> layTour(const TourTerrain& terrain, const TourOptions& options = {});

} // namespace simulation
