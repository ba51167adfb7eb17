// SPDX-License-Identifier: Apache-2.0
#include "PlayTracks.h"

#include <iostream>

#include <foundation/WholeFile.h>

#include "HeadlessCommand.h"
#include "PlayCommand.h"
#include "scene/FlatScene.h"
#include "scene/SceneTerrain.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackGeoid.h"
#include "simulation/track/TrackScenario.h"
#include "simulation/writer/WriteScenario.h"

namespace trainer
{

namespace
{

/// The first of what was passed over, each with its line, and how many more there are.
void tellProblems(const simulation::TrackReading& reading, const std::string& file)
{
    constexpr std::size_t kTold = 5;
    for (std::size_t i = 0; i < std::min(kTold, reading.problems.size()); ++i)
        std::cerr << "warning: " << file << ':' << reading.problems[i].line << ": "
                  << reading.problems[i].what << "; passed over\n";
    for (std::size_t i = 0; i < std::min(kTold, reading.notes.size()); ++i)
        std::cerr << "warning: " << file << ':' << reading.notes[i].line << ": " << reading.notes[i].what
                  << '\n';
    if (reading.problemCount > kTold)
        std::cerr << "warning: " << file << ": " << reading.problemCount - kTold << " more such lines\n";
}

std::string durationText(double seconds)
{
    const auto whole = static_cast<long>(seconds + 0.5);
    char text[64];
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    return text;
}

/// Reads a recording, and tells what was passed over.
foundation::Result<simulation::TrackReading> readTold(const PlayRequest& request, const TrackRequest& tracks)
{
    if (const auto writable = foundation::checkWritable(tracks.saveFile); !writable) return writable.error();
    const std::string name = request.scenario.string();
    auto reading = simulation::readTracks(request.scenario);
    if (!reading) return reading.error();
    tellProblems(*reading, name);
    if (tracks.datum) simulation::setDatum(reading->tracks, *tracks.datum);
    if (request.terrain.file.empty() && !tracks.saveFile.empty())
        return foundation::Error{name, "a scenario of it needs a terrain",
                                 "give --terrain FILE of that place"};
    return reading;
}

/// Makes a scenario of a recording, tells what was done to it, and saves it.
foundation::Result<simulation::Scenario> madeOf(simulation::TrackReading reading,
                                                const simulation::SceneFrame& frame,
                                                const PlayRequest& request, const TrackRequest& tracks)
{
    const bool isFlat = request.terrain.file.empty();
    auto made = simulation::scenarioOf(
        std::move(reading.tracks), frame,
        {isFlat ? "flat ground" : std::filesystem::absolute(request.terrain.file).string(),
         request.scenario.filename().string(), tracks.startS, isFlat});
    if (!made) return made.error();
    for (const std::string& note : made->notes)
        std::cout << "track: " << note << '\n';
    std::cout << "plays " << made->scenario.entities.size() << " entities for "
              << durationText(made->durationS) << " h; --start and --frames choose a part\n";
    if (!tracks.saveFile.empty())
    {
        const auto text = simulation::scenarioText(made->scenario);
        if (!text) return text.error();
        if (const auto saved = foundation::writeWholeFile(tracks.saveFile, *text); !saved)
            return saved.error();
    }
    return std::move(made->scenario);
}

/// The terrain of a request. Errors: it has no place on earth.
foundation::Result<SceneTerrain> placedScene(const PlayRequest& request)
{
    auto terrain = openScene(request.terrain.file, request.terrain);
    if (!terrain || terrain->origin()) return terrain;
    return foundation::Error{request.terrain.file.string(), "has no place on earth",
                             "give a terrain with a georeference"};
}

} // namespace

foundation::Outcome playTracks(const PlayRequest& request, const TrackRequest& tracks)
{
    auto reading = readTold(request, tracks);
    if (!reading) return reading.error();
    const auto note = simulation::countFromEllipsoid(reading->tracks);
    if (note) std::cout << "track: " << *note << '\n';
    const bool isFlat = request.terrain.file.empty();
    auto terrain = isFlat ? makeFlatScene(reading->tracks) : placedScene(request);
    if (!terrain) return terrain.error();
    if (isFlat) std::cout << "track: no --terrain: flat ground is made below it\n";
    const simulation::SceneFrame frame(terrain->origin(), terrain->ground());
    auto scenario = madeOf(std::move(*reading), frame, request, tracks);
    if (!scenario) return scenario.error();
    return playOver(std::move(*terrain), std::move(*scenario), request);
}

foundation::Outcome playTracksHeadless(const PlayRequest& request, const TrackRequest& tracks,
                                       const HeadlessRequest& headless)
{
    if (const auto writable = foundation::checkWritable(headless.logFile); !writable) return writable;
    auto reading = readTold(request, tracks);
    if (!reading) return reading.error();
    simulation::PlayerOptions options;
    std::optional<SceneTerrain> terrain; // outlives the player, whose ground it is
    if (request.terrain.file.empty())
    {
        const simulation::TrackFix& first = reading->tracks.front().fixes.front();
        options.origin =
            simulation::Geodetic{first.latitudeDeg, first.longitudeDeg,
                                 simulation::geoidHeightM(first.latitudeDeg, first.longitudeDeg)};
        std::cout
            << "track: no --terrain: heights are those recorded; z counts from the sea at the first fix\n";
    }
    else
    {
        auto opened = placedScene(request);
        if (!opened) return opened.error();
        terrain = std::move(*opened);
        options.origin = terrain->origin();
        options.ground = terrain->ground();
    }
    auto scenario =
        madeOf(std::move(*reading), simulation::SceneFrame(options.origin, options.ground), request, tracks);
    if (!scenario) return scenario.error();
    options.clock = simulation::FixedClock::forStep(headless.stepS);
    options.scenarioName = request.scenario.string();
    options.seed = headless.seed;
    auto player = simulation::ScenarioPlayer::create(std::move(*scenario), std::move(options));
    if (!player) return player.error();
    return playOut(**player, headless);
}

} // namespace trainer
