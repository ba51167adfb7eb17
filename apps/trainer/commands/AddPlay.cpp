// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <memory>
#include <string>

#include "actions/HeadlessCommand.h"
#include "actions/PlayCommand.h"
#include "actions/PlayTracks.h"
#include "actions/PlayVariations.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "simulation/track/ReadTrack.h"
#include "terminal/CommandLine.h"
#include "world/SuffixedFile.h"

namespace trainer
{

namespace
{

struct PlayLine
{
    PlayOptions play;
    bool isHeadless = false, isWithoutRoads = false;
    HeadlessRequest headless;
    VariationRequest variations;
    TrackRequest tracks;
};

void addHeadlessOptions(CLI::App& play, PlayLine& line)
{
    HeadlessRequest& headless = line.headless;
    CLI::Option* const flag =
        play.add_flag("--headless", line.isHeadless, "play without pictures, terrain and models");
    play.add_option("--fixed_timestep", headless.stepS, "seconds of a step, with --headless")
        ->check(terminal::between(1e-4, 1.0))
        ->needs(flag);
    play.add_option("--duration", headless.durationS, "seconds to play at most, with --headless")
        ->check(terminal::between(0.0, 1e5))
        ->needs(flag);
    play.add_option("--csv_logger", headless.logFile, "file for a row of each step, with --headless")
        ->needs(flag);
}

void addVariationOptions(CLI::App& play, VariationRequest& request)
{
    CLI::Option* const number =
        play.add_option("--variation", request.number,
                        "number of the only variation to play, of a file of parameter-value distributions");
    play.add_flag("--list-variations", request.isListed, "print the variations instead of playing them")
        ->excludes(number);
    play.add_option("--seed", request.seed,
                    "of everything that is left to chance, instead of the file's own");
}

void addTrackOptions(CLI::App& play, TrackRequest& request)
{
    play.add_option("--start", request.startS, "seconds into a recording at which to begin")
        ->check(terminal::between(0.0, 1e6));
    play.add_option("--save", request.saveFile, "file for the scenario that is made of a recording");
    const std::map<std::string, simulation::HeightDatum> datums{
        {"sea", simulation::HeightDatum::meanSeaLevel},
        {"ellipsoid", simulation::HeightDatum::ellipsoid},
        {"pressure", simulation::HeightDatum::pressure},
        {"ground", simulation::HeightDatum::ground}};
    play.add_option("--heights-above", request.datum, "what the heights of a recording count from")
        ->transform(terminal::named(datums));
}

/// Plays a recording.
foundation::Outcome playRecording(const PlayLine& line)
{
    if (!line.isHeadless) return playTracks(line.play.request, line.tracks);
    HeadlessRequest headless = line.headless;
    headless.scenario = line.play.request.scenario;
    headless.seed = line.variations.seed.value_or(0);
    return playTracksHeadless(line.play.request, line.tracks, headless);
}

/// Plays a scenario, or the variations of one.
foundation::Outcome playOne(const PlayLine& line)
{
    if (simulation::isTrackFile(line.play.request.scenario)) return playRecording(line);
    const auto without =
        line.isWithoutRoads ? simulation::WithoutRoads::played : simulation::WithoutRoads::refused;
    const auto play = [&](const ScenarioPlay& one)
    {
        if (line.isHeadless)
        {
            HeadlessRequest headless = line.headless;
            headless.scenario = one.scenario;
            headless.parameters = one.parameters;
            headless.seed = line.variations.seed.value_or(0);
            headless.logFile = withSuffix(headless.logFile, one.suffix);
            headless.without = without;
            return playHeadless(headless);
        }
        PlayRequest request = line.play.request;
        request.scenario = one.scenario;
        request.parameters = one.parameters;
        request.seed = line.variations.seed.value_or(0);
        request.without = without;
        OutputRequest& output = request.output;
        output.captureFolder = withSuffix(output.captureFolder, one.suffix);
        output.statsFile = withSuffix(output.statsFile, one.suffix);
        output.reportFile = withSuffix(output.reportFile, one.suffix);
        return trainer::play(request);
    };
    return playVariations(line.play.request.scenario, line.variations, play);
}

} // namespace

std::vector<Command> addPlay(CLI::App& program)
{
    const auto line = std::make_shared<PlayLine>();
    CLI::App* command = program.add_subcommand("play", "play an OpenSCENARIO file, or a recorded flight");
    command
        ->add_option("SCENARIO", line->play.request.scenario,
                     "OpenSCENARIO XML, or a recording (.igc, .gpx, .kml, .kmz, .acmi, .csv)")
        ->required();
    command->add_option("--terrain", line->play.request.terrain.file,
                        "terrain or scene file instead of the scenario's SceneGraphFile");
    command->add_flag("--without-roads", line->isWithoutRoads,
                      "play a scenario whose LogicFile is not there without roads");
    line->play.addTo(*command);
    addHeadlessOptions(*command, *line);
    addVariationOptions(*command, line->variations);
    addTrackOptions(*command, line->tracks);
    return {{command, line->play.running([line] { return playOne(*line); })}};
}

} // namespace trainer
