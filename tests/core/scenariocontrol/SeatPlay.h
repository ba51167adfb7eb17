// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "ControlPlay.h"
#include "simulation/control/scenario/PersonSeat.h"

/// Storyboards in which somebody sits, on a straight road of 3 km.
namespace seatplay
{

using namespace controlplay;

/// An inputs file that is removed with this.
class InputsFile
{
public:
    InputsFile(const std::string& name, const std::string& text)
        : _file(std::filesystem::path(testing::TempDir()) / (name + ".inputs.txt"))
    {
        std::ofstream(_file) << text;
    }
    ~InputsFile() { std::filesystem::remove(_file); }
    InputsFile(const InputsFile&) = delete;
    InputsFile& operator=(const InputsFile&) = delete;

    const std::filesystem::path& path() const { return _file; }

private:
    std::filesystem::path _file;
};

/// A player with somebody in Ego.
struct SeatedPlay
{
    std::shared_ptr<simulation::PersonSeat> seat;
    std::unique_ptr<simulation::ScenarioPlayer> player;

    void playTo(double timeS) const { controlplay::playTo(*player, timeS); }
    const simulation::EntityState& ego() const { return player->entities()[0]; }
    bool tells(const std::string& words) const
    {
        const auto notes = player->notes();
        return std::any_of(notes.begin(), notes.end(),
                           [&](const std::string& note) { return note.find(words) != std::string::npos; });
    }
    bool hasBegun(const std::string& name) const
    {
        return std::any_of(player->log().begin(), player->log().end(),
                           [&](const simulation::StoryboardLogEntry& entry)
                           {
                               return entry.path.ends_with("::" + name) &&
                                      entry.transition == simulation::StoryboardElementState::startTransition;
                           });
    }
};

/// Ego at 100 m of lane -1 with a speed.
inline simulation::ScenarioText moving(double speedMps)
{
    simulation::ScenarioText text;
    text.privates = onLane(100.0) + simulation::speedAction(speedMps);
    return text;
}

/// Where somebody sits besides the road.
struct SeatStage
{
    Roads roads = straight(); ///< null: level ground
    std::shared_ptr<const simulation::ObstacleMap> obstacles{};
};

inline SeatedPlay seated(simulation::ScenarioText text, simulation::SeatSettings settings,
                         const SeatStage& stage = {})
{
    if (text.stop.empty()) text.stop = simulation::stopAt(1000.0);
    SeatedPlay play;
    auto parsed = simulation::parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return play;
    std::shared_ptr<const simulation::Ground> ground = std::make_shared<simulation::LevelGround>();
    if (stage.roads) ground = std::make_shared<simulation::RoadSceneGround>(stage.roads);
    settings.entity = "Ego";
    if (settings.vehicle.empty()) settings.vehicle = kCarFile;
    auto seat = simulation::PersonSeat::create(settings, parsed->scenario.entities[0],
                                               {ground, std::nullopt, stage.obstacles});
    EXPECT_TRUE(seat) << seat.error().message();
    if (!seat) return play;
    simulation::PlayerOptions options;
    options.clock = simulation::FixedClock(120);
    options.roads = stage.roads;
    options.scenarioName = "test.xosc";
    options.motionSource = std::make_shared<simulation::ScenarioMotions>(
        simulation::ScenarioMotions::World{ground, std::nullopt, OSGTRAINER_SOURCE_DIR, 0});
    options.seats["Ego"] = *seat;
    auto player = simulation::ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return play;
    play.seat = std::move(*seat);
    play.player = std::move(*player);
    return play;
}

/// The same by inputs, from the start.
inline SeatedPlay byInputs(const simulation::ScenarioText& text, const std::filesystem::path& inputs,
                           bool isRecorded = false)
{
    return seated(text, {.entity = "", .isTakenAtStart = true, .inputs = inputs, .isRecorded = isRecorded});
}

} // namespace seatplay
