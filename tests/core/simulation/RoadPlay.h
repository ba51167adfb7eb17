// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "../roads/RoadTexts.h"
#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

/// Storyboards on small roads, played in steps of 0.01 s.
namespace roadplay
{

inline constexpr double kStepS = 0.01;

using Roads = std::shared_ptr<const simulation::RoadScene>;

/// Road 1 along x from the origin, a lane of 3.5 m on each side: lane -1 at y = -1.75 towards x, lane 1 at
/// 1.75 back.
inline Roads straight(double lengthM = 3000.0)
{
    return std::make_shared<const simulation::RoadScene>(roadtexts::sound(roadtexts::network(
        roadtexts::road("1", lengthM, roadtexts::straightPlan(lengthM) + roadtexts::twoLanes()))));
}

inline std::string onLane(double s, int lane = -1, const std::string& road = "1")
{
    return simulation::teleport("<LanePosition roadId=\"" + road + "\" laneId=\"" + std::to_string(lane) +
                                "\" s=\"" + std::to_string(s) + "\"/>");
}

inline foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>>
created(simulation::ScenarioText text, Roads roads = straight(), std::uint64_t seed = 0)
{
    if (text.stop.empty()) text.stop = simulation::stopAt(1000.0);
    auto parsed = simulation::parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    if (!parsed) return parsed.error();
    simulation::PlayerOptions options;
    options.clock = simulation::FixedClock::forStep(kStepS);
    options.roads = std::move(roads);
    options.seed = seed;
    return simulation::ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
}

inline std::unique_ptr<simulation::ScenarioPlayer> begun(const simulation::ScenarioText& text,
                                                         Roads roads = straight(), std::uint64_t seed = 0)
{
    auto player = created(text, std::move(roads), seed);
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

inline void playTo(simulation::ScenarioPlayer& player, double timeS)
{
    while (!player.isFinished() && player.timeS() < timeS - 1e-9)
        player.step();
}

inline std::unique_ptr<simulation::ScenarioPlayer> played(const simulation::ScenarioText& text, double timeS,
                                                          Roads roads = straight(), std::uint64_t seed = 0)
{
    auto player = begun(text, std::move(roads), seed);
    if (player) playTo(*player, timeS);
    return player;
}

} // namespace roadplay
