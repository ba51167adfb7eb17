// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// The speed, the heights and the turns of a flight that fit a terrain.
/// From the longer side D of the extent: the speed is D/50 per second, 15…240 m/s, 110 m/s at most past
/// sights, and at most D/2 in the whole flight; heights above the ground are in proportion to the distance
/// flown, so that the climb allows them.
struct TourScale
{
    double speedMps = 0.0;
    double lengthM = 0.0;
    double lowM = 0.0; ///< above the ground
    double mediumM = 0.0;
    double highM = 0.0;
    double clearanceM = 0.0;      ///< never closer to the ground
    double turnRateRadPerS = 0.0; ///< at most
    double climbSlope = 0.0;      ///< rise over run, at most
    double sinkSlope = 0.0;       ///< the same downwards: steeper, the view is then on the land

    static TourScale of(const TourTerrain& terrain, double durationS);
};

} // namespace simulation
