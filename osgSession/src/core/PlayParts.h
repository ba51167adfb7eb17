// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osgSession/core/Play.h>

#include "DrivenVehicle.h"
#include "simulation/player/ScenarioPlayer.h"

namespace osgSession::core
{

/// What a play consists of.
class Play::Parts
{
public:
    std::unique_ptr<simulation::ScenarioPlayer> owned; ///< null: the session owns it
    simulation::ScenarioPlayer* player = nullptr;      ///< never null once made
    std::map<std::string, DrivenVehicle> driven;
    std::vector<std::string> notes; ///< of its opening
    std::size_t eventsTaken = 0;
};

/// Makes the vehicles that a host drives. Errors: as DrivenVehicle::create(); one of no entity.
foundation::Result<std::map<std::string, DrivenVehicle>>
makeDriven(const PlaySettings& settings, const simulation::Scenario& scenario,
           const std::shared_ptr<const simulation::Ground>& ground,
           const std::optional<simulation::Geodetic>& origin);

/// Their motions by entity, as players take them.
std::map<std::string, std::shared_ptr<simulation::ExternalMotion>>
motionsOf(const std::map<std::string, DrivenVehicle>& driven);

/// Errors: steps a second below 1 or above 10 000.
foundation::Outcome checkSteps(const PlaySettings& settings);

/// Reads a scenario; what it has and the player has not is passed over, one line each in `notes`.
/// Errors: as readScenario() and checkSteps().
foundation::Result<simulation::Scenario> readForPlay(const PlaySettings& settings,
                                                     std::vector<std::string>& notes);

} // namespace osgSession::core
