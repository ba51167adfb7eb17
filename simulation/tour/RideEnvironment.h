// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scenario/Environment.h"
#include "simulation/tour/RideConditions.h"
#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// What of its air a world tells itself.
struct KeptAir
{
    bool sun = false, visibility = false, clouds = false;
};

/// Leaves it out of an environment, so that the world's stays.
void leaveToWorld(Environment& environment, const KeptAir& kept);

/// Returns the environment of a ride that begins in a direction (counter-clockwise from east), for the
/// terrain's place; without georeference for 45° N. Units: radians.
Environment rideEnvironment(const TourTerrain& terrain, double headingRad, const RideConditions& conditions);

} // namespace simulation
