// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "simulation/scenario/RoutingActions.h"
#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Makes a trajectory of a track: a polyline of GeoPositions, smooth through all fixes, by the times of the
/// recording counted from its start; without times it is followed at the speed of the entity. Attitudes are
/// taken where every fix has one. Between fixes more than 30 s apart the way is straight; where the gaps are
/// uneven, vertices between the fixes keep the curve from swinging out (TrackGaps.h).
/// Errors: fewer than two fixes.
foundation::Result<FollowTrajectoryAction> trajectoryOf(const FlightTrack& track);

} // namespace simulation
