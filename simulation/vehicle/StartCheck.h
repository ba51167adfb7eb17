// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/DynamicVehicle.h"

namespace simulation
{

/// The error of a vehicle that cannot begin where it should; its place names the start.
foundation::Error noStart(const VehicleStart& start, const std::string& what, const std::string& remedy);

/// Whether a vehicle may begin to fly above the ground below it; where no ground is known it may.
/// Errors: it lies inside the ground, or less than 2 m above it.
foundation::Outcome checkFlyingStart(const VehicleStart& start, const GroundPoint& below);

/// Whether a vehicle may be let down onto the ground.
/// Errors: no ground, water, more than 1 m inside the ground (a hill; a level below a bridge is no inside).
foundation::Outcome checkStandingStart(const VehicleStart& start, const GroundPoint& below);

} // namespace simulation
