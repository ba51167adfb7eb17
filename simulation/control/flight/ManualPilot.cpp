// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/ManualPilot.h"

namespace simulation
{

foundation::Result<ManualController> manualPilot(const DynamicVehicle& aircraft)
{
    // Full deflection is for devices; keys, which know no half, reach less the faster the air is.
    constexpr double kSoftMps = 12.0, kElevatorLeast = 0.12, kAileronLeast = 0.25;
    std::vector<InputAxis> axes{
        {"elevator", -1.0, 1.0, 0.4, 0.8, 0.0, kSoftMps, kElevatorLeast},
        {"aileron", -1.0, 1.0, 0.8, 1.6, 0.0, kSoftMps, kAileronLeast},
        {"rudder", -1.0, 1.0, 1.2, 2.4, 0.0, kSoftMps, kAileronLeast},
        {"elevator_trim", -1.0, 1.0, 0.1},
        {"flaps", 0.0, 1.0, 0.5},
        {"throttle", 0.0, 1.0, 0.5},
        {"mixture", 0.0, 1.0, 0.25},
        {"left_brake", 0.0, 1.0, 2.0, 4.0},
        {"right_brake", 0.0, 1.0, 2.0, 4.0},
        {"starter", 0.0, 1.0, 1e3, 1e3},
        {"ignition", 0.0, 1.0, 1e3},
    };
    return ManualController::create(std::move(axes), aircraft);
}

} // namespace simulation
