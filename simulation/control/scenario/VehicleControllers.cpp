// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/VehicleControllers.h"

#include "simulation/scenario/ControllerKinds.h"

namespace simulation
{
namespace
{

/// For a kind in the list of names that is not in the one of makers; a test compares both.
foundation::Result<std::unique_ptr<VehicleController>> makeNothing(ControllerProperties&,
                                                                   const ControllerSite&)
{
    return foundation::Error{"property kind", "names a controller that nothing makes",
                             "add it to kVehicleControllers, or name another one"};
}

} // namespace

VehicleControllerMaker vehicleControllerOf(const Controller& controller)
{
    for (const auto& maker : kVehicleControllers)
        if (maker().name == controller.played()->name) return maker();
    return {controller.played()->name, {}, makeNothing};
}

} // namespace simulation
