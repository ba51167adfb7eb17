// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/ManualController.h"

namespace simulation
{

/// Manual control by whoever sits in a vehicle: manualDriver() of a road vehicle, manualPilot() of others.
/// Errors: as manualPilot().
foundation::Result<ManualController> manualControllerFor(const DynamicVehicle& vehicle);

} // namespace simulation
