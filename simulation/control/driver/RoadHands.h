// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/Hands.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

/// The hands and feet of somebody who drives a road vehicle by keys: wheel and pedals go back when they are
/// let go. In forward gears a manual gearbox is shifted for them (HandShift), and its clutch is worked in
/// reverse, too. `vehicle` must outlive it.
Hands driverHands(const RoadVehicle& vehicle);

} // namespace simulation
