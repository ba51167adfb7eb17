// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "../roads/RoadTexts.h"
#include "../simulation/ScenarioText.h"
#include "simulation/control/scenario/ScenarioMotions.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/vehicle/RoadSceneGround.h"

/// Storyboards whose controllers drive vehicles with physics, on a straight road of 3 km or over level
/// ground.
namespace controlplay
{

inline const std::string kCarFile = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";
inline const std::string kAircraftFile = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";

using Roads = std::shared_ptr<const simulation::RoadScene>;

/// Road 1 along x from the origin: lane -1 at y = -1.75 towards x, lane 1 at 1.75 back.
inline Roads straight(const std::string& signals = "")
{
    constexpr double kLengthM = 3000.0;
    return std::make_shared<const simulation::RoadScene>(roadtexts::sound(roadtexts::network(roadtexts::road(
        "1", kLengthM, roadtexts::straightPlan(kLengthM) + roadtexts::twoLanes() + signals))));
}

inline std::string property(const std::string& name, const std::string& value)
{
    return "<Property name=\"" + name + "\" value=\"" + value + "\"/>";
}

inline std::string controller(const std::string& kind, const std::string& properties)
{
    return "<ObjectController><Controller name=\"" + kind + "\"><Properties>" + properties +
           "</Properties></Controller></ObjectController>";
}

/// `longitudinal`, `lateral`: true, false, or empty for neither.
inline std::string activate(const std::string& longitudinal, const std::string& lateral)
{
    const auto attribute = [](const std::string& name, const std::string& value)
    { return value.empty() ? "" : " " + name + "=\"" + value + "\""; };
    return "<PrivateAction><ControllerAction><ActivateControllerAction" +
           attribute("longitudinal", longitudinal) + attribute("lateral", lateral) +
           "/></ControllerAction></PrivateAction>";
}

inline std::string onLane(double s, int lane = -1)
{
    return simulation::teleport("<LanePosition roadId=\"1\" laneId=\"" + std::to_string(lane) + "\" s=\"" +
                                std::to_string(s) + "\"/>");
}

/// A car that drives by its own physics on lane -1, at 100 m with a speed.
inline simulation::ScenarioText driven(double speedMps, const std::string& properties = "",
                                       const std::string& kind = "Driver")
{
    simulation::ScenarioText text;
    text.entities = "<ScenarioObject name=\"Ego\">" + simulation::kCar +
                    controller(kind, property("vehicle", kCarFile) + properties) + "</ScenarioObject>";
    text.privates = onLane(100.0) + simulation::speedAction(speedMps) + activate("true", "true");
    return text;
}

/// An aircraft 1000 m above the ground that flies east by its autopilot.
inline simulation::ScenarioText flown(double speedMps, const std::string& properties)
{
    std::string aircraft = simulation::kCar;
    aircraft.replace(aircraft.find("\"car\">"), 6, "\"aircraft\">");
    simulation::ScenarioText text;
    text.entities = "<ScenarioObject name=\"Ego\">" + aircraft +
                    controller("Autopilot", property("vehicle", kAircraftFile) + properties) +
                    "</ScenarioObject>";
    text.privates = simulation::teleport(R"(<WorldPosition x="0" y="0" z="1000" h="0"/>)") +
                    simulation::speedAction(speedMps) + activate("true", "true");
    return text;
}

struct Stage
{
    Roads roads = straight();
    std::shared_ptr<const simulation::Ground> ground{}; ///< null: that of the roads, else level
    simulation::FixedClock clock = simulation::FixedClock::forStep(0.01);
    std::uint64_t seed = 0;
    std::filesystem::path folder = OSGTRAINER_SOURCE_DIR;
};

inline foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>>
begunPlay(simulation::Scenario scenario, const Stage& stage = {})
{
    std::shared_ptr<const simulation::Ground> ground = stage.ground;
    if (!ground && stage.roads) ground = std::make_shared<simulation::RoadSceneGround>(stage.roads);
    if (!ground) ground = std::make_shared<simulation::LevelGround>();
    simulation::PlayerOptions options;
    options.clock = stage.clock;
    options.roads = stage.roads;
    options.scenarioName = "test.xosc";
    options.motionSource = std::make_shared<simulation::ScenarioMotions>(
        simulation::ScenarioMotions::World{ground, std::nullopt, stage.folder, stage.seed});
    return simulation::ScenarioPlayer::create(std::move(scenario), std::move(options));
}

inline foundation::Result<std::unique_ptr<simulation::ScenarioPlayer>> opened(simulation::ScenarioText text,
                                                                              const Stage& stage = {})
{
    if (text.stop.empty()) text.stop = simulation::stopAt(1000.0);
    auto parsed = simulation::parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    if (!parsed) return parsed.error();
    return begunPlay(std::move(parsed->scenario), stage);
}

inline void playTo(simulation::ScenarioPlayer& player, double timeS)
{
    while (!player.isFinished() && player.timeS() < timeS - 1e-9)
        player.step();
}

inline std::unique_ptr<simulation::ScenarioPlayer> played(const simulation::ScenarioText& text, double timeS,
                                                          const Stage& stage = {})
{
    auto player = opened(text, stage);
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return nullptr;
    playTo(**player, timeS);
    return std::move(*player);
}

inline const simulation::EntityState& ego(const simulation::ScenarioPlayer& player)
{
    return player.entities()[0];
}

} // namespace controlplay
