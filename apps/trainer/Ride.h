// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <foundation/Result.h>

#include "PlayRequest.h"
#include "SceneTerrain.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// One vehicle with physics in a world, ready to go.
struct Ride
{
    simulation::Scenario scenario;
    std::string entity; ///< of the scenario, which the motion moves
    std::shared_ptr<simulation::VehicleMotion> motion;
    std::string name; ///< in the table of motion
};

/// How a ride is played.
struct RideRequest
{
    PlayRequest play; ///< pictures, and the table of motion
    bool isHeadless = false;
    double durationS = 600.0; ///< at most
};

/// Plays a ride, with pictures or at 120 steps a second without. Errors: as playScene() and playOut().
foundation::Outcome playRide(const RideRequest& request, SceneTerrain terrain, Ride ride);

} // namespace trainer
