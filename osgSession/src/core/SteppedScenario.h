// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/player/ScenarioPlayer.h"
#include "simulation/road/ScenarioRoads.h"
#include "simulation/vehicle/Ground.h"

namespace osgSession::core
{

/// What a scenario without pictures is stepped on: its roads, else level ground.
struct ScenarioGround
{
    std::shared_ptr<const simulation::RoadScene> roads; ///< null: none
    /// a place on earth that Init names, where there are no roads
    std::optional<simulation::Geodetic> origin;
    std::shared_ptr<const simulation::Ground> wheels; ///< as wheels meet it; never null
    simulation::MissingFiles missing;
};

/// Opens the roads of a scenario. `file`: of the scenario. Errors: as missingFiles(); a network that cannot
/// be read.
foundation::Result<ScenarioGround> openScenarioGround(const simulation::Scenario& scenario,
                                                      const std::filesystem::path& file,
                                                      simulation::WithoutRoads without);

/// Makes the player of a scenario on its ground. `motions`: of entities that something else moves.
/// Errors: as ScenarioPlayer::create().
foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>>
makePlayer(simulation::Scenario scenario, const std::filesystem::path& file, const ScenarioGround& ground,
           const simulation::FixedClock& clock, std::uint64_t seed,
           std::map<std::string, std::shared_ptr<simulation::ExternalMotion>> motions = {});

} // namespace osgSession::core
