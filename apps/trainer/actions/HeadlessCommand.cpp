// SPDX-License-Identifier: Apache-2.0
#include "HeadlessCommand.h"

#include <chrono>
#include <cstdio>
#include <optional>

#include "ScenarioProblems.h"
#include "osgSession/src/core/SteppedScenario.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/record/MotionLog.h"

namespace trainer
{

foundation::Outcome playHeadless(const HeadlessRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.logFile); !writable) return writable;
    auto parsed =
        simulation::readScenario(request.scenario, {.tolerant = true, .parameters = request.parameters});
    if (!parsed) return parsed.error();
    if (const auto sound = tellProblems(parsed->problems); !sound) return sound;
    if (const auto laid = tellRecordings(parsed->scenario, {request.scenario}); !laid) return laid;
    const auto ground =
        osgSession::core::openScenarioGround(parsed->scenario, request.scenario, request.without);
    if (!ground) return ground.error();
    if (const auto& roads = ground->missing.roads)
        std::fprintf(stderr, "warning: %s\n", roads->message().c_str());
    if (ground->roads)
        for (const foundation::Error& mistake : ground->roads->mistakes())
            std::fprintf(stderr, "warning: %s\n", mistake.message().c_str());
    auto player = osgSession::core::makePlayer(std::move(parsed->scenario), request.scenario, *ground,
                                               simulation::FixedClock::forStep(request.stepS), request.seed);
    if (!player) return player.error();
    return playOut(**player, request);
}

foundation::Outcome playOut(simulation::ScenarioPlayer& player, const HeadlessRequest& request)
{
    std::optional<simulation::MotionLog> log;
    if (!request.logFile.empty())
        log.emplace(request.logFile, player.scenario(), request.scenario.filename().string(),
                    !player.told().empty());
    tellWarnings(player);
    const auto begin = std::chrono::steady_clock::now();
    if (log) log->add(0.0, player.entities(), player.told());
    while (!player.isFinished() && !player.areMotionsDone() && player.timeS() < request.durationS - 1e-9)
    {
        player.step();
        if (log) log->add(player.timeS(), player.entities(), player.told());
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
