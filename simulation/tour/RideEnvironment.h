// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scenario/Environment.h"
#include "simulation/tour/RideConditions.h"
#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// Leaves sun and visibility out of an environment, so that those of the world stay.
void leaveToWorld(Environment& environment, bool keepsSun, bool keepsVisibility);

/// Returns the environment of a ride that begins in a direction (counter-clockwise from east), for the
/// terrain's place; without georeference for 45° N. Units: radians.
Environment rideEnvironment(const TourTerrain& terrain, double headingRad, const RideConditions& conditions);

} // namespace simulation
