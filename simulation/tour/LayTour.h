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

/// A flight over any terrain: towards its highest and most rugged part, along a smooth path with banked turns, from a
/// high overview down to a low pass and up again, at speeds and heights that fit the extent (TourScale). The sun stands
/// to the side and somewhat behind, at a summer's hour that the place really has.
/// The scenario has one entity, `ownship`, airborne, on one timed trajectory in mode `follow`, and ends by time.
/// Positions are GeoPosition where the terrain has an origin, else WorldPosition.
/// Checked before it is returned, on the very curve that is played, densely: the clearance is kept everywhere.
/// Deterministic. Cost: about a second, mostly height queries (some 500 000).
/// Errors: a terrain without extent or heights that are not finite, a duration out of range.
foundation::Result<Tour> layTour(const TourTerrain& terrain, const TourOptions& options = {});

} // namespace simulation
