// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "FlyRequest.h"
#include "simulation/geodesy/LocalFrame.h"
#include "simulation/vehicle/DynamicVehicle.h"

namespace trainer
{

/// The aircraft of a request: one of our own data files, or one that JSBSim flies.
/// Errors: those of its file; a road vehicle; an aircraft of JSBSim without a root.
foundation::Result<std::unique_ptr<simulation::DynamicVehicle>>
aircraftOf(const FlyRequest& request, const std::optional<simulation::Geodetic>& origin);

/// Tells what is wrong with it without beginning JSBSim. Errors: as aircraftOf().
foundation::Outcome checkAircraft(const FlyRequest& request);

} // namespace trainer
