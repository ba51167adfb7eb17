// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/Hands.h"

namespace simulation
{

/// The hands and feet of a pilot: stick and pedals return to the middle when keys are let go, levers stay.
/// Errors: a vehicle without the inputs of an aircraft.
foundation::Result<Hands> pilotHands(const DynamicVehicle& aircraft);

} // namespace simulation
