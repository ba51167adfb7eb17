// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/ManualControllerFor.h"

#include "simulation/control/driver/ManualDriver.h"
#include "simulation/control/flight/ManualPilot.h"

namespace simulation
{

foundation::Result<ManualController> manualControllerFor(const DynamicVehicle& vehicle)
{
    if (const auto* const car = dynamic_cast<const RoadVehicle*>(&vehicle)) return manualDriver(*car);
    return manualPilot(vehicle);
}

} // namespace simulation
