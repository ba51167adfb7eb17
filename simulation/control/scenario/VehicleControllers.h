// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <foundation/Result.h>

#include "simulation/control/VehicleController.h"
#include "simulation/control/scenario/ControllerProperties.h"
#include "simulation/player/MotionSource.h"
#include "simulation/vehicle/EarthFrame.h"

namespace simulation
{

/// What a controller with physics is made for.
struct ControllerSite
{
    const DynamicVehicle& vehicle; ///< that it drives; it must outlive the controller
    const std::shared_ptr<const EarthFrame>& earth;
    const Ground& ground;
    const MotionStart* start = nullptr; ///< null: properties are checked alone, and no controller is made
};

/// A controller of scenarios that drives a vehicle with physics.
struct VehicleControllerMaker
{
    std::string_view name;                        ///< of its kind: see controllerKinds()
    std::span<const std::string_view> properties; ///< beside kVehicleProperties; it knows no others

    /// Errors: a property and what is wrong with it; null where it only checks.
    foundation::Result<std::unique_ptr<VehicleController>> (*make)(ControllerProperties& properties,
                                                                   const ControllerSite& site);
};

/// The properties that say which vehicle is driven, whoever drives it.
inline constexpr std::string_view kVehicleProperties[] = {"vehicle", "seed", "turbulence"};

VehicleControllerMaker autopilotController();
VehicleControllerMaker driverController();
VehicleControllerMaker recordedController();

/// All controllers that drive a vehicle with physics, a file for each in the folder `controllers`.
inline constexpr VehicleControllerMaker (*kVehicleControllers[])() = {autopilotController, driverController,
                                                                      recordedController};

/// The maker of a controller of a scenario. The controller must have physics (Controller::hasPhysics()).
VehicleControllerMaker vehicleControllerOf(const Controller& controller);

} // namespace simulation
