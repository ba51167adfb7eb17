// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "input/KeyTable.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{
class ControlSwitch;
class VehicleMotion;
} // namespace simulation

namespace trainer
{

/// One vehicle with physics in a world, ready to go.
struct Ride
{
    simulation::Scenario scenario;
    std::string entity; ///< of the scenario, which the motion moves
    std::shared_ptr<simulation::VehicleMotion> motion;
    std::string name;                              ///< in the table of motion
    simulation::ControlSwitch* controls = nullptr; ///< of the motion; null: nobody sits in it
};

/// Where a ride may begin.
struct RidePlace
{
    std::string name;
    std::string option; ///< of the command line, with which a ride without a window begins there
};

/// Makes one ride after the other in one world, each from its start.
class RideMaker
{
public:
    virtual ~RideMaker() = default;

    virtual KeyScope kind() const = 0;

    /// At least one.
    virtual std::vector<RidePlace> places() const = 0;

    /// Errors: a place where nothing can begin.
    virtual foundation::Result<Ride> make(std::size_t place) = 0;
};

} // namespace trainer
