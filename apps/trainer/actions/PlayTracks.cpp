// SPDX-License-Identifier: Apache-2.0
#include "PlayTracks.h"

#include <iostream>

#include <foundation/WholeFile.h>

#include "PlayCommand.h"
#include "scene/FlatScene.h"
#include "scene/SceneTerrain.h"
#include "simulation/track/ReadTrack.h"
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

} // namespace

foundation::Outcome playTracks(const PlayRequest& request, const TrackRequest& tracks)
{
    const std::string name = request.scenario.string();
    if (const auto writable = foundation::checkWritable(tracks.saveFile); !writable) return writable;
    auto reading = simulation::readTracks(request.scenario);
    if (!reading) return reading.error();
    tellProblems(*reading, name);
    const bool isFlat = request.terrain.file.empty();
    if (isFlat && !tracks.saveFile.empty())
        return foundation::Error{name, "a scenario of it needs a terrain",
                                 "give --terrain FILE of that place"};
    auto terrain = isFlat ? makeFlatScene(reading->tracks) : openScene(request.terrain.file, request.terrain);
    if (!terrain) return terrain.error();
    if (!terrain->origin())
        return foundation::Error{request.terrain.file.string(), "has no place on earth",
                                 "give a terrain with a georeference"};
    const simulation::SceneFrame frame(terrain->origin(), terrain->ground());
    auto made = simulation::scenarioOf(
        std::move(reading->tracks), frame,
        {isFlat ? "flat ground" : std::filesystem::absolute(request.terrain.file).string(),
         request.scenario.filename().string(), tracks.startS, isFlat});
    if (!made) return made.error();
    if (isFlat) std::cout << "track: no --terrain: flat ground is made below it\n";
    for (const std::string& note : made->notes)
        std::cout << "track: " << note << '\n';
    std::cout << "plays " << made->scenario.entities.size() << " entities for "
              << durationText(made->durationS) << " h; --start and --frames choose a part\n";
    if (!tracks.saveFile.empty())
    {
        const auto text = simulation::scenarioText(made->scenario);
        if (!text) return text.error();
        if (const auto saved = foundation::writeWholeFile(tracks.saveFile, *text); !saved) return saved;
    }
    return playOver(std::move(*terrain), std::move(made->scenario), request);
}

} // namespace trainer
