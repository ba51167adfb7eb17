// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/player/ScenarioPlayer.h"
#include "simulation/road/SignalProgrammes.h"
#include "simulation/scenario/DefaultVehicle.h"
#include "simulation/scenario/SessionTraffic.h"

/// Traffic around somebody, and what was seen of it.
namespace simulation::trafficnetworks
{

/// Somebody who stands at a place, with traffic around it.
inline Scenario trafficAround(const glm::dvec2& place, double perKm, double radiusM)
{
    Scenario scenario;
    scenario.entities.push_back({{}, "Ego", defaultVehicle("car")});
    TeleportAction teleport;
    teleport.position = WorldPosition{{}, place.x, place.y, 0.0, Orientation{0.0, {}, {}}};
    scenario.storyboard.init.privates.push_back({{}, "Ego", {teleport}});
    addTraffic(scenario, "Ego", {perKm, radiusM});
    return scenario;
}

/// The mutation of whatever says that there are no collisions: drivers who do not give way.
inline Scenario withoutGivingWay(Scenario scenario)
{
    auto& action = std::get<TrafficAction>(scenario.storyboard.init.globals.back());
    for (TrafficMix::Driver& driver : std::get<TrafficSwarm>(action.content).mix.drivers)
        driver.controller.properties.values.emplace_back("givesWay", "false");
    return scenario;
}

/// Whose lights, if there are some, go by themselves.
inline std::unique_ptr<ScenarioPlayer> playerOf(Scenario scenario, std::shared_ptr<const RoadScene> roads,
                                                std::uint64_t seed = 0, int stepsPerSecond = 60)
{
    scenario.roadNetwork.signalControllers = signalProgrammes(*roads);
    PlayerOptions options;
    options.clock = FixedClock(stepsPerSecond);
    options.seed = seed;
    options.roads = std::move(roads);
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

/// What was seen of the traffic.
struct Watched
{
    int collisions = 0; ///< pairs that began to touch
    double longestStandS = 0.0;
    double drivenM = 0.0; ///< by all
    std::size_t most = 0, least = 1000;
    double fastestMps = 0.0;
};

/// `eachStep`: called after each one.
inline Watched watch(ScenarioPlayer& player, double untilS, const std::function<void()>& eachStep = {})
{
    Watched seen;
    const auto count = player.entities().size();
    std::vector<double> standsS(count, 0.0);
    std::vector<std::vector<int>> touching(count);
    while (player.timeS() < untilS)
    {
        player.step();
        if (eachStep) eachStep();
        std::size_t present = 0;
        for (std::size_t i = 1; i < count; ++i)
        {
            const EntityState& state = player.entities()[i];
            if (!state.isPresent) continue;
            ++present;
            standsS[i] = state.speedMps < 0.1 ? standsS[i] + player.clock().stepS() : 0.0;
            seen.longestStandS = std::max(seen.longestStandS, standsS[i]);
            seen.drivenM += state.speedMps * player.clock().stepS();
            seen.fastestMps = std::max(seen.fastestMps, state.speedMps);
            for (const int other : state.collidesWith)
                if (std::find(touching[i].begin(), touching[i].end(), other) == touching[i].end())
                    ++seen.collisions;
            touching[i] = state.collidesWith;
        }
        seen.most = std::max(seen.most, present);
        seen.least = std::min(seen.least, present);
    }
    return seen;
}

} // namespace simulation::trafficnetworks
