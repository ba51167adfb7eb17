// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Result.h>

#include "ride/Ride.h"
#include "ride/RideRequest.h"

namespace trainer
{

struct SceneTerrain;

/// Opens the roads of a ride, before it is made, for its traffic and their lights. Where the world has none,
/// and traffic is wanted, that is told, and there is no traffic.
void openRoads(RideRequest& request, const SceneTerrain& terrain);

/// Plays rides: in a window, with pictures, or at 120 steps a second without. Writes the files of the
/// request, and returns the motion of the last one. Errors: as playScene(), playOut() and WindowSession.
foundation::Result<std::shared_ptr<simulation::VehicleMotion>>
playRides(const RideRequest& request, SceneTerrain terrain, RideMaker& maker);

} // namespace trainer
