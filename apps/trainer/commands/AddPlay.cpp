// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <memory>
#include <string>

#include "actions/HeadlessCommand.h"
#include "actions/PlayCommand.h"
#include "actions/PlayPlaces.h"
#include "actions/PlaySeats.h"
#include "actions/PlayTracks.h"
#include "actions/PlayVariations.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "simulation/track/ReadTrack.h"
#include "terminal/CommandLine.h"
#include "window/OpenWindow.h"
#include "world/SuffixedFile.h"

namespace trainer
{

namespace
{

struct PlayLine
{
    PlayOptions play;
    bool isHeadless = false, isWithoutRoads = false;
    SeatRequest seat;
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
        ->needs(flag)
        ->each([&headless](const std::string&) { headless.hasStep = true; });
    play.add_option("--duration", headless.durationS, "seconds to play at most, with --headless")
        ->check(terminal::between(0.0, 1e5))
        ->needs(flag);
    play.add_option("--csv_logger", headless.logFile, "file for a row of each step");
}

void addSeatOptions(CLI::App& play, SeatRequest& seat)
{
    play.add_option(
        "--drive", seat.entity,
        "vehicle or aircraft of the scenario that a person drives from the start; in a window Tab "
        "gives it back and takes it over");
    play.add_option("--vehicle", seat.vehicle,
                    "data file of what the person drives, instead of one of the entity's category");
    play.add_option("--inputs", seat.inputs, "inputs file to drive by, in place of a person's hands");
    play.add_option("--record-inputs", seat.recordInputs, "inputs file to write of what the person does");
}

/// Completes who sits where; nothing: nobody was asked for. A person without a window has one, unless
/// something else is written. Errors: a person without hands; what a recording cannot have.
foundation::Outcome completeSeat(PlayLine& line)
{
    PlayRequest& request = line.play.request;
    SeatRequest& seat = line.seat;
    const bool isAsked =
        !seat.entity.empty() || !seat.inputs.empty() || !seat.recordInputs.empty() || !seat.vehicle.empty();
    request.output.motionFile = line.headless.logFile;
    if (!isAsked) return foundation::success();
    seat.isTakenAtStart = !seat.entity.empty();
    request.seat = seat;
    if (line.isHeadless && line.headless.hasStep)
        return foundation::Error{"--fixed_timestep", "a person's play has steps of 1/120 s", "leave it out"};
    if (line.isHeadless && simulation::isTrackFile(request.scenario))
        return foundation::Error{"--headless", "a recorded flight has no ground to drive on without pictures",
                                 "leave it out"};
    const OutputRequest& output = request.output;
    const bool drawsPictures = !output.captureFolder.empty() || !output.statsFile.empty() ||
                               !output.reportFile.empty() || !output.partsFile.empty() ||
                               !request.sound.file.empty() || !request.frames.viewFile.empty() ||
                               request.frames.count.has_value();
    if (!line.isHeadless && !drawsPictures && seat.inputs.empty()) request.window.isWanted = true;
    if (request.window.isWanted)
        if (const auto display = checkDisplay(request.window); !display) return display;
    return checkHands(seat, request.window.isWanted);
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

/// A seat whose recording stands beside those of other variations.
std::optional<SeatRequest> seatOfVariation(std::optional<SeatRequest> seat, const std::string& suffix)
{
    if (seat) seat->recordInputs = withSuffix(seat->recordInputs, suffix);
    return seat;
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
foundation::Outcome playOne(PlayLine& line)
{
    if (const auto complete = completeSeat(line); !complete) return complete;
    if (const auto usable = terminal::checkPlaces(placesOf(line.play.request)); !usable) return usable;
    if (simulation::isTrackFile(line.play.request.scenario)) return playRecording(line);
    const auto without =
        line.isWithoutRoads ? simulation::WithoutRoads::played : simulation::WithoutRoads::refused;
    const auto play = [&](const ScenarioPlay& one)
    {
        HeadlessRequest headless = line.headless;
        if (line.isHeadless)
        {
            headless.scenario = one.scenario;
            headless.parameters = one.parameters;
            headless.seed = line.variations.seed.value_or(0);
            headless.logFile = withSuffix(headless.logFile, one.suffix);
            headless.without = without;
            if (!line.play.request.seat) return playHeadless(headless);
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
        output.motionFile = withSuffix(output.motionFile, one.suffix);
        request.seat = seatOfVariation(request.seat, one.suffix);
        return line.isHeadless ? playSeatHeadless(request, headless) : trainer::play(request);
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
    addSeatOptions(*command, line->seat);
    addVariationOptions(*command, line->variations);
    addTrackOptions(*command, line->tracks);
    return {{command, line->play.running([line] { return playOne(*line); })}};
}

} // namespace trainer
