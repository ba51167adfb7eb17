// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/ManualController.h"

namespace simulation
{

/// Manual control by a pilot: stick and pedals return to the middle when keys are let go, levers stay.
/// Errors: a vehicle without the inputs of an aircraft.
foundation::Result<ManualController> manualPilot(const DynamicVehicle& aircraft);

} // namespace simulation
