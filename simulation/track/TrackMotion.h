// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Heights.h>

#include "simulation/track/TrackHeights.h"

namespace simulation
{

/// Metres between two fixes in the plane, good to a percent over the way between neighbours.
double metresBetween(const TrackFix& one, const TrackFix& other);

/// The length of a track over ground. Units: metres.
double lengthOf(const FlightTrack& track);

/// Tells what moved where the file does not: an aircraft where a tenth of the fixes is 50 m above the ground
/// or more, or half of them 25 m (of a made ground, which is no measure, the first alone counts), else a
/// person on foot (slower than 2.5 m/s for nine tenths of the moving time) or a vehicle. Precondition:
/// fitToGround() was called.
TrackKind kindByMotion(const FlightTrack& track, const foundation::HeightOnEarth& ground,
                       bool isMadeGround = false);

} // namespace simulation
