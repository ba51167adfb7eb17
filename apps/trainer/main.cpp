// SPDX-License-Identifier: Apache-2.0
// trainer: plays scenarios over terrain and writes images of them.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <osgOffscreen/OpenGlVersion>

#include "CheckCommand.h"
#include "CompareCommand.h"
#include "DriveCommand.h"
#include "FlyCommand.h"
#include "HeadlessCommand.h"
#include "PlayCommand.h"
#include "PlayTracks.h"
#include "PlayVariations.h"
#include "QualifyCommand.h"
#include "simulation/track/ReadTrack.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terminal/Terminal.h"

namespace
{

using trainer::PlayRequest;

constexpr int kMostFrames = 1'000'000; ///< 11 hours at 24 a second
constexpr double kHighestDriverM = 10.0;

constexpr std::array<std::pair<const char*, trainer::EyePoint>, 8> kEyes = {
    {{"own", trainer::EyePoint::own},
     {"driver", trainer::EyePoint::driver},
     {"pilot", trainer::EyePoint::pilot},
     {"chase", trainer::EyePoint::chase},
     {"above", trainer::EyePoint::above},
     {"tower", trainer::EyePoint::tower},
     {"kerb", trainer::EyePoint::kerb},
     {"free", trainer::EyePoint::free}}};

std::vector<std::string> eyeNames()
{
    std::vector<std::string> names;
    for (const auto& [name, eye] : kEyes)
        names.emplace_back(name);
    return names;
}

/// The values of the command line.
struct Arguments
{
    PlayRequest request;
    std::string size = "960x540";
    std::string backend{osgOffscreen::backendName(osgOffscreen::defaultBackend())};
    std::string eye = "own";
    std::vector<double> freeEye;
    std::filesystem::path saveFile;
    double durationS = 20.0;
    std::string patchExponent = "0";
    bool isHeadless = false;
    trainer::HeadlessRequest headless;
    trainer::VariationRequest variations;
    trainer::TrackRequest tracks;
    trainer::CheckRequest check;
    trainer::CompareRequest compare;
    trainer::QualifyRequest qualify;
    trainer::QualifyDriveRequest qualifyDrive;
    trainer::DriveRequest drive;
    trainer::FlyRequest fly;
    std::vector<double> strip;
};

void addHeadlessOptions(CLI::App& play, Arguments& arguments)
{
    trainer::HeadlessRequest& headless = arguments.headless;
    CLI::Option* const flag =
        play.add_flag("--headless", arguments.isHeadless, "play without pictures, terrain and models");
    play.add_option("--fixed_timestep", headless.stepS, "seconds of a step, with --headless")
        ->check(terminal::between(1e-4, 1.0))
        ->needs(flag);
    play.add_option("--duration", headless.durationS, "seconds to play at most, with --headless")
        ->check(terminal::between(0.0, 1e5))
        ->needs(flag);
    play.add_option("--csv_logger", headless.logFile, "file for a row of each step, with --headless")
        ->needs(flag);
}

void addVariationOptions(CLI::App& play, trainer::VariationRequest& request)
{
    CLI::Option* const number =
        play.add_option("--variation", request.number,
                        "number of the only variation to play, of a file of parameter-value distributions");
    play.add_flag("--list-variations", request.isListed, "print the variations instead of playing them")
        ->excludes(number);
    play.add_option("--seed", request.seed,
                    "of everything that is left to chance, instead of the file's own");
}

void addCompareOptions(CLI::App& command, trainer::CompareRequest& request)
{
    command.add_option("TABLE", request.table, "motion to judge, from --csv_logger")->required();
    command.add_option("REFERENCE", request.reference, "motion to judge it by; may be compressed by gzip")
        ->required();
    command.add_option("--position", request.limits.positionM, "largest difference in metres")
        ->check(terminal::between(0.0, 1e9));
    command.add_option("--heading", request.limits.headingDeg, "largest difference in degrees")
        ->check(terminal::between(0.0, 360.0));
    command.add_option("--json", request.jsonFile, "file for the differences");
}

void addPlayOptions(CLI::App& command, Arguments& arguments)
{
    PlayRequest& request = arguments.request;
    command.add_option("--capture", request.output.captureFolder,
                       "folder for the images, from frame_00000.png on");
    command.add_option(
        "--scenery", request.scenery.description,
        "JSON file that describes the objects on the terrain (docs/reference/scenery-file.md)");
    command.add_option("--objects", request.scenery.modelsFolder,
                       "folder of models to scatter beside the path");
    command.add_option("--stats", request.output.statsFile, "JSON file for the statistics of each frame");
    command.add_option("--report", request.output.reportFile, "HTML file with plots of the statistics");
    command.add_option("--report-sheet", request.output.contactSheet,
                       "image file beside the report, shown in it");
    command.add_option("--report-video", request.output.video, "video file beside the report, shown in it");
    command.add_option("--view", request.frames.viewFile, "XML file that describes one or several channels");
    command.add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels, without a view file");
    command.add_option("--fps", request.frames.perSecond, "frames per second")->check(CLI::Range(1, 240));
    command
        .add_option("--frames", request.frames.count,
                    "number of frames to draw, instead of the whole scenario")
        ->check(CLI::Range(1, kMostFrames));
    command.add_option("--backend", arguments.backend, "osmesa or egl");
    command.add_option("--samples", request.frames.samples, "per pixel: 1 or 4")
        ->check(CLI::IsMember({1, 4}));
    command
        .add_option(
            "--eye", arguments.eye,
            "camera: driver or pilot (own: whichever fits), chase, above, tower, kerb, or free (--eye-at); a "
            "tour with driver or above drives along roads")
        ->check(CLI::IsMember(eyeNames()));
    command.add_option("--eye-entity", request.frames.eyeEntity,
                       "name of the entity that the camera is in or looks at, instead of the first one");
    command
        .add_option("--eye-at", arguments.freeEye,
                    "X,Y,Z,HEADING,PITCH of the free camera: metres in the scene's frame, degrees")
        ->delimiter(',')
        ->expected(5);
    command
        .add_option(
            "--eye-height", request.frames.eyeHeightM,
            "height in metres of the eye above the ground (driver, tower, kerb) or above the car (above)")
        ->check(terminal::between(0.3, 2000.0));
    command.add_option("--tolerance", request.terrain.errorTolerancePx, "error target in pixels")
        ->check(terminal::between(0.01, 1000.0));
    command.add_flag("--show-voids", request.terrain.showsVoids,
                     "colour ground that is filled because the raster has no data there");
    command.add_flag("--morph", request.terrain.morphing,
                     "move vertices gradually when detail changes, with more triangles");
    command.add_option("--patch-exponent", arguments.patchExponent,
                       "2^K triangles for each leaf, K even from 0 to 10; or 'measure': the fastest on "
                       "this machine");
    command.add_option("--max-triangles", request.terrain.maxTriangles, "triangle limit of the terrain")
        ->check(CLI::Range(2u, 100000000u));
    command
        .add_option("--spacing", request.terrain.import.spacingM,
                    "metres between samples of a raster without georeference")
        ->check(terminal::between(0.001, 1e5));
}

CLI::App* addCheck(CLI::App& app, trainer::CheckRequest& request)
{
    CLI::App* check = app.add_subcommand("check", "list everything wrong or not in effect in scenarios");
    CLI::Option* const files =
        check->add_option("SCENARIO", request.scenarios, "OpenSCENARIO XML, one file or several");
    check->add_flag("--strict", request.isStrict, "exit code 1 also for what is not in effect");
    check->add_option("--json", request.jsonFile, "file for the findings and the elements of each file");
    check
        ->add_flag("--coverage", request.printsCoverage,
                   "print what becomes of every element of the standard")
        ->excludes(files);
    return check;
}

CLI::App* addDrive(CLI::App& app, Arguments& arguments)
{
    trainer::DriveRequest& request = arguments.drive;
    CLI::App* drive = app.add_subcommand("drive", "drive a road vehicle by its own physics");
    drive
        ->add_option("WORLD", arguments.request.terrain.file, "OpenDRIVE network, or a .roam file with roads")
        ->required();
    drive->add_flag("--headless", request.isHeadless, "drive without pictures");
    drive->add_option("--vehicle", request.vehicle, "road vehicle file");
    drive->add_option("--duration", request.durationS, "seconds to drive at most")
        ->check(terminal::between(0.1, 1e5));
    drive->add_option("--length", request.lengthM, "metres of lanes to drive")
        ->check(terminal::between(20.0, 1e6));
    drive->add_option("--speed", request.speedMps, "most that the driver wants, m/s")
        ->check(terminal::between(0.5, 100.0));
    drive->add_option("--csv_logger", arguments.request.output.motionFile, "file for a row of each step");
    drive->add_option("--inputs", request.inputs, "inputs file to drive by, in place of the driver");
    drive->add_option("--record-inputs", request.recordInputs, "inputs file to write");
    addPlayOptions(*drive, arguments);
    return drive;
}

foundation::Outcome driveOne(const Arguments& arguments)
{
    trainer::DriveRequest request = arguments.drive;
    request.play = arguments.request;
    return trainer::drive(request);
}

/// `qualify` has a command below it for each kind of vehicle. Returns that of flight and that of drive.
std::pair<CLI::App*, CLI::App*> addQualify(CLI::App& app, Arguments& arguments)
{
    trainer::QualifyRequest& request = arguments.qualify;
    trainer::QualifyDriveRequest& ofDrive = arguments.qualifyDrive;
    CLI::App* qualify = app.add_subcommand("qualify", "hold vehicles against what is known of them");
    qualify->require_subcommand(1);
    CLI::App* flight =
        qualify->add_subcommand("flight", "fly an aircraft against its handbook and recorded flights");
    flight->add_option("--aircraft", request.aircraft, "aircraft file");
    flight->add_option("--json", request.jsonFile, "JSON file for the figures");
    CLI::App* drive = qualify->add_subcommand("drive", "drive road vehicles against figures and models");
    drive->add_option("--vehicle", ofDrive.vehicles, "road vehicle files");
    drive->add_option("--stand", ofDrive.standsS, "seconds to stand on a slope")
        ->check(terminal::between(1.0, 86400.0));
    drive->add_option("--json", ofDrive.jsonFile, "JSON file for the figures");
    return {flight, drive};
}

CLI::App* addFly(CLI::App& app, Arguments& arguments)
{
    trainer::FlyRequest& fly = arguments.fly;
    CLI::App* command = app.add_subcommand("fly", "fly an aircraft by its own physics");
    command->add_option(
        "WORLD", arguments.request.terrain.file,
        "terrain to fly over: a .roam file, a raster or an OpenDRIVE network; without it level ground");
    command->add_flag("--headless", fly.isHeadless, "fly without pictures");
    command->add_option("--duration", fly.durationS, "seconds to fly at most")
        ->check(terminal::between(0.0, 1e5));
    command->add_option("--csv_logger", arguments.request.output.motionFile, "file for a row of each step");
    command->add_option("--aircraft", fly.aircraft, "aircraft file");
    CLI::Option* const inputs = command->add_option("--inputs", fly.inputs, "inputs file to fly by");
    command->add_option("--record-inputs", fly.recordInputs, "inputs file to write");
    command
        ->add_option("--orders", fly.orders,
                     "of the autopilot: takeoff; heading 240; altitude 500; speed 45; wait 30; circuit; land")
        ->excludes(inputs);
    command
        ->add_option("--start", fly.start,
                     "X,Y,H,HEADING,SPEED: metres in the scene's frame, metres above the ground, degrees "
                     "from north, m/s")
        ->delimiter(',')
        ->expected(5);
    command
        ->add_option("--strip", arguments.strip,
                     "X,Y,COURSE,LENGTH of a level strip that is laid: its threshold in the scene's frame, "
                     "degrees from north, metres")
        ->delimiter(',')
        ->expected(4);
    command->add_option("--wind", fly.wind, "FROM,KNOTS: degrees from north, kt")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--gusts", fly.gustsMps, "standard deviation of turbulence, m/s")
        ->check(terminal::between(0.0, 20.0));
    command->add_option("--seed", fly.seed, "of the turbulence");
    addPlayOptions(*command, arguments);
    return command;
}

/// Completes a flight. Errors: a strip without length.
foundation::Outcome flyOne(Arguments& arguments)
{
    trainer::FlyRequest& fly = arguments.fly;
    const std::vector<double>& strip = arguments.strip;
    if (!strip.empty())
    {
        if (!(strip[3] >= 100.0 && strip[3] <= 10'000.0))
            return foundation::Error{"--strip", "its length is not from 100 to 10000 m",
                                     "write X,Y,COURSE,LENGTH"};
        arguments.request.terrain.strip =
            trainer::StripRequest{{strip[0], strip[1]}, strip[2], strip[3], 30.0};
    }
    fly.play = arguments.request;
    return trainer::fly(fly);
}

foundation::Outcome readPatchExponent(const std::string& text, std::optional<int>& exponent)
{
    exponent = std::nullopt;
    if (text == "measure") return foundation::success();
    int value = -1;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d%c", &value, &rest) != 1 || value < 0 || value > 10 || value % 2 != 0)
        return foundation::Error{"--patch-exponent", "'" + text + "' is no even number from 0 to 10",
                                 "write 0, 2, 4, 6, 8 or 10, or measure"};
    exponent = value;
    return foundation::success();
}

/// Takes --eye-at. Errors: it is there without --eye free, or the other way round.
foundation::Outcome placeFreeEye(Arguments& arguments)
{
    trainer::FrameRequest& frames = arguments.request.frames;
    const std::vector<double>& at = arguments.freeEye;
    if (at.empty() != (frames.eye != trainer::EyePoint::free))
        return foundation::Error{"--eye-at", "a free camera needs a place, and no other takes one",
                                 "write --eye free --eye-at X,Y,Z,HEADING,PITCH"};
    if (!at.empty()) frames.freeEye = {{at[0], at[1], at[2]}, at[3], at[4]};
    return foundation::success();
}

foundation::Outcome complete(Arguments& arguments)
{
    char rest = 0;
    PlayRequest& request = arguments.request;
    trainer::FrameRequest& frames = request.frames;
    if (std::sscanf(arguments.size.c_str(), "%dx%d%c", &frames.widthPx, &frames.heightPx, &rest) != 2 ||
        frames.widthPx < 16 || frames.heightPx < 16 || frames.widthPx > 8192 || frames.heightPx > 8192)
        return foundation::Error{"--size", "'" + arguments.size + "' is not a size", "write it as 960x540"};
    const auto backend = osgOffscreen::parseBackend(arguments.backend);
    if (!backend) return backend.error();
    frames.backend = *backend;
    for (const auto& [name, eye] : kEyes)
        if (arguments.eye == name) frames.eye = eye;
    if (const auto placed = placeFreeEye(arguments); !placed) return placed;
    if (frames.isInside() && frames.eyeHeightM.value_or(0.0) > kHighestDriverM)
        return foundation::Error{"--eye-height", "no driver's eye is higher than 10 m",
                                 "write a lower one, or --eye above"};
    return readPatchExponent(arguments.patchExponent, request.terrain.patchExponent);
}

void addTrackOptions(CLI::App& play, trainer::TrackRequest& request)
{
    play.add_option("--start", request.startS, "seconds into a recording at which to begin")
        ->check(terminal::between(0.0, 1e6));
    play.add_option("--save", request.saveFile, "file for the scenario that is made of a recording");
}

/// Plays a recording. Errors: options that belong to scenarios.
foundation::Outcome playRecording(const Arguments& arguments)
{
    if (!arguments.isHeadless) return trainer::playTracks(arguments.request, arguments.tracks);
    return foundation::Error{"--headless", "a recording is played over its terrain",
                             "leave it out; or --save the scenario, and play that headless"};
}

/// Plays a scenario, or the variations of one.
foundation::Outcome playOne(const Arguments& arguments)
{
    if (simulation::isTrackFile(arguments.request.scenario)) return playRecording(arguments);
    const auto play = [&](const trainer::ScenarioPlay& one)
    {
        if (arguments.isHeadless)
        {
            trainer::HeadlessRequest headless = arguments.headless;
            headless.scenario = one.scenario;
            headless.parameters = one.parameters;
            headless.logFile = trainer::withSuffix(headless.logFile, one.suffix);
            return trainer::playHeadless(headless);
        }
        PlayRequest request = arguments.request;
        request.scenario = one.scenario;
        request.parameters = one.parameters;
        trainer::OutputRequest& output = request.output;
        output.captureFolder = trainer::withSuffix(output.captureFolder, one.suffix);
        output.statsFile = trainer::withSuffix(output.statsFile, one.suffix);
        output.reportFile = trainer::withSuffix(output.reportFile, one.suffix);
        return trainer::play(request);
    };
    return trainer::playVariations(arguments.request.scenario, arguments.variations, play);
}

int run(int argc, char** argv)
{
    CLI::App app("Plays driving and flight scenarios over terrain, offscreen, the same way every time.",
                 "trainer");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.footer(
        "Needs OpenGL " + osgOffscreen::kEverythingNeeds.text() +
        " in the compatibility profile, from a driver of the machine (--backend egl) or from Mesa's OSMesa.");
    app.require_subcommand(1);
    Arguments arguments;
    PlayRequest& request = arguments.request;

    CLI::App* play = app.add_subcommand("play", "play an OpenSCENARIO file, or a recorded flight");
    play->add_option("SCENARIO", request.scenario,
                     "OpenSCENARIO XML, or a recording (.igc, .gpx, .kml, .acmi, .csv)")
        ->required();
    play->add_option("--terrain", request.terrain.file,
                     "terrain or scene file instead of the scenario's SceneGraphFile");
    addPlayOptions(*play, arguments);
    addHeadlessOptions(*play, arguments);
    addVariationOptions(*play, arguments.variations);
    addTrackOptions(*play, arguments.tracks);
    CLI::App* tour =
        app.add_subcommand("tour", "fly over an elevation file, or drive through a road network");
    tour->add_option("DEM", request.terrain.file,
                     "any elevation raster, a .roam file, or an OpenDRIVE network (.xodr)")
        ->required();
    tour->add_option("--save", arguments.saveFile, "file for the scenario that is played");
    tour->add_option("--duration", arguments.durationS, "seconds")->check(terminal::between(4.0, 3600.0));
    addPlayOptions(*tour, arguments);
    const CLI::App* check = addCheck(app, arguments.check);
    CLI::App* compare = app.add_subcommand("compare", "compare two tables of motion");
    addCompareOptions(*compare, arguments.compare);
    const CLI::App* fly = addFly(app, arguments);
    const CLI::App* drive = addDrive(app, arguments);
    const auto [qualifyFlight, qualifyDrive] = addQualify(app, arguments);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    if (*check) return trainer::check(arguments.check);
    if (*qualifyFlight) return trainer::qualifyFlight(arguments.qualify);
    if (*qualifyDrive) return trainer::qualifyDrive(arguments.qualifyDrive);
    if (const auto sound = complete(arguments); !sound)
        return terminal::fail("trainer", sound.error()), terminal::kWrongUse;
    const auto outcome = *fly       ? flyOne(arguments)
                         : *drive   ? driveOne(arguments)
                         : *compare ? trainer::compare(arguments.compare)
                         : *tour    ? trainer::tour(request, arguments.saveFile, arguments.durationS)
                                    : playOne(arguments);
    return outcome ? terminal::kDone : terminal::fail("trainer", outcome.error());
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("trainer", [=] { return run(argc, argv); });
}
