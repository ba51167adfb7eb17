// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/ManualController.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

/// Manual control by somebody who drives a road vehicle by keys: wheel and pedals go back when they are
/// let go. In forward gears a manual gearbox is shifted for them (HandShift), and its clutch is worked in
/// reverse, too. `vehicle` must outlive it.
ManualController manualDriver(const RoadVehicle& vehicle);

} // namespace simulation
