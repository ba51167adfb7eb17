// SPDX-License-Identifier: Apache-2.0
#include "SteppedScenario.h"

#include "ScenarioPlace.h"
#include "simulation/control/scenario/ScenarioMotions.h"
#include "simulation/vehicle/RoadSceneGround.h"

namespace osgSession::core
{

foundation::Result<ScenarioGround> openScenarioGround(const simulation::Scenario& scenario,
                                                      const std::filesystem::path& file,
                                                      simulation::WithoutRoads without)
{
    ScenarioGround ground;
    auto missing = simulation::missingFiles(scenario, file, without);
    if (!missing) return missing.error();
    ground.missing = std::move(*missing);
    auto roads = simulation::openRoads(scenario, file.parent_path());
    if (!roads) return roads.error();
    ground.roads = std::move(*roads);
    if (ground.roads)
        ground.wheels = std::make_shared<simulation::RoadSceneGround>(ground.roads);
    else
    {
        ground.origin = trainer::placeOnEarth(scenario);
        ground.wheels = std::make_shared<simulation::LevelGround>();
    }
    return ground;
}

foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>>
makePlayer(simulation::Scenario scenario, const std::filesystem::path& file, const ScenarioGround& ground,
           const simulation::FixedClock& clock, std::uint64_t seed,
           std::map<std::string, std::shared_ptr<simulation::ExternalMotion>> motions)
{
    simulation::PlayerOptions options;
    options.roads = ground.roads;
    if (ground.roads) options.projection = simulation::projectionOf(*ground.roads);
    options.origin = ground.origin;
    options.clock = clock;
    options.scenarioName = file.string();
    options.seed = seed;
    options.motionSource = std::make_shared<simulation::ScenarioMotions>(
        simulation::ScenarioMotions::World{ground.wheels, ground.origin, file.parent_path(), seed});
    options.motions = std::move(motions);
    return simulation::ScenarioPlayer::create(std::move(scenario), std::move(options));
}

} // namespace osgSession::core
