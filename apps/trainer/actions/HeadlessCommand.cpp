// SPDX-License-Identifier: Apache-2.0
#include "HeadlessCommand.h"

#include <chrono>
#include <cstdio>
#include <optional>

#include "ScenarioProblems.h"
#include "osgSession/src/core/ScenarioPlace.h"
#include "simulation/control/scenario/ScenarioMotions.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/record/MotionLog.h"
#include "simulation/road/ScenarioRoads.h"
#include "simulation/vehicle/RoadSceneGround.h"

namespace trainer
{
namespace
{

foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>> openPlayer(simulation::Scenario scenario,
                                                                           const HeadlessRequest& request)
{
    simulation::PlayerOptions options;
    if (const auto missing = simulation::missingRoads(scenario, request.scenario.parent_path()))
        std::fprintf(stderr, "warning: %s\n", missing->message().c_str());
    auto roads = simulation::openRoads(scenario, request.scenario.parent_path());
    if (!roads) return roads.error();
    options.roads = std::move(*roads);
    if (options.roads) options.projection = simulation::projectionOf(*options.roads);
    if (!options.roads) options.origin = placeOnEarth(scenario);
    options.clock = simulation::FixedClock::forStep(request.stepS);
    options.scenarioName = request.scenario.string();
    options.seed = request.seed;
    std::shared_ptr<const simulation::Ground> ground = std::make_shared<simulation::LevelGround>();
    if (options.roads) ground = std::make_shared<simulation::RoadSceneGround>(options.roads);
    options.motionSource = std::make_shared<simulation::ScenarioMotions>(simulation::ScenarioMotions::World{
        std::move(ground), options.origin, request.scenario.parent_path(), request.seed});
    return simulation::ScenarioPlayer::create(std::move(scenario), std::move(options));
}

} // namespace

foundation::Outcome playHeadless(const HeadlessRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.logFile); !writable) return writable;
    auto parsed =
        simulation::readScenario(request.scenario, {.tolerant = true, .parameters = request.parameters});
    if (!parsed) return parsed.error();
    if (const auto sound = tellProblems(parsed->problems); !sound) return sound;
    if (const auto laid = tellRecordings(parsed->scenario, {request.scenario}); !laid) return laid;
    auto player = openPlayer(std::move(parsed->scenario), request);
    if (!player) return player.error();
    return playOut(**player, request);
}

foundation::Outcome playOut(simulation::ScenarioPlayer& player, const HeadlessRequest& request)
{
    std::optional<simulation::MotionLog> log;
    if (!request.logFile.empty())
        log.emplace(request.logFile, player.scenario(), request.scenario.filename().string());
    tellWarnings(player);
    const auto begin = std::chrono::steady_clock::now();
    if (log) log->add(0.0, player.entities());
    while (!player.isFinished() && !player.areMotionsDone() && player.timeS() < request.durationS - 1e-9)
    {
        player.step();
        if (log) log->add(player.timeS(), player.entities());
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::printf("played %.2f s, %.0f times as fast as real time\n", player.timeS(),
                player.timeS() / took.count());
    for (const std::string& note : player.notes())
        std::printf("note: %s\n", note.c_str());
    for (const auto& [name, value] : player.monitors())
        std::printf("monitor %s: %s\n", name.c_str(), value ? "true" : "false");
    return log ? log->finish() : foundation::success();
}

} // namespace trainer
