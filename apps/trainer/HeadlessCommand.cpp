// SPDX-License-Identifier: Apache-2.0
#include "HeadlessCommand.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>

#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/record/MotionLog.h"
#include "simulation/road/ScenarioRoads.h"

namespace trainer
{
namespace
{

/// Tells what is passed over. Errors: the first thing that is wrong.
foundation::Outcome tell(const std::vector<simulation::Problem>& problems)
{
    for (const simulation::Problem& problem : problems)
        if (problem.kind == simulation::Problem::Kind::invalid) return problem.error;
    for (const simulation::Problem& problem : problems)
        std::cerr << "warning: " << problem.error.place << ": " << problem.error.what
                  << "; it is passed over\n";
    return foundation::success();
}

foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>> openPlayer(simulation::Scenario scenario,
                                                                           const HeadlessRequest& request)
{
    simulation::PlayerOptions options;
    auto roads = simulation::openRoads(scenario, request.scenario.parent_path());
    if (!roads) return roads.error();
    options.roads = std::move(*roads);
    options.clock = simulation::FixedClock::forStep(request.stepS);
    options.scenarioName = request.scenario.string();
    return simulation::ScenarioPlayer::create(std::move(scenario), std::move(options));
}

} // namespace

foundation::Outcome playHeadless(const HeadlessRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.logFile); !writable) return writable;
    auto parsed = simulation::readScenario(request.scenario, {.tolerant = true, .parameters = {}});
    if (!parsed) return parsed.error();
    if (const auto sound = tell(parsed->problems); !sound) return sound;
    auto player = openPlayer(std::move(parsed->scenario), request);
    if (!player) return player.error();
    std::optional<simulation::MotionLog> log;
    if (!request.logFile.empty())
        log.emplace(request.logFile, (*player)->scenario(), request.scenario.filename().string());
    const auto begin = std::chrono::steady_clock::now();
    if (log) log->add(0.0, (*player)->entities());
    while (!(*player)->isFinished() && (*player)->timeS() < request.durationS - 1e-9)
    {
        (*player)->step();
        if (log) log->add((*player)->timeS(), (*player)->entities());
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::printf("played %.2f s, %.0f times as fast as real time\n", (*player)->timeS(),
                (*player)->timeS() / took.count());
    return log ? log->finish() : foundation::success();
}

} // namespace trainer
