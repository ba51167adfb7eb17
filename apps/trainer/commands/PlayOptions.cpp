// SPDX-License-Identifier: Apache-2.0
#include "commands/PlayOptions.h"

#include <array>
#include <cstdio>
#include <map>
#include <utility>

#include "actions/OpeningProgress.h"
#include "actions/PlayPlaces.h"
#include "simulation/parser/Metar.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace trainer
{

namespace
{

constexpr int kMostFrames = 1'000'000; ///< 11 hours at 24 a second
constexpr double kHighestDriverM = 10.0;

constexpr std::array<std::pair<const char*, EyePoint>, 9> kEyes = {{{"own", EyePoint::own},
                                                                    {"driver", EyePoint::driver},
                                                                    {"pilot", EyePoint::pilot},
                                                                    {"chase", EyePoint::chase},
                                                                    {"above", EyePoint::above},
                                                                    {"tower", EyePoint::tower},
                                                                    {"kerb", EyePoint::kerb},
                                                                    {"free", EyePoint::free},
                                                                    {"map", EyePoint::map}}};

std::vector<std::string> eyeNames()
{
    std::vector<std::string> names;
    for (const auto& [name, eye] : kEyes)
        names.emplace_back(name);
    return names;
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

} // namespace

void PlayOptions::addTo(CLI::App& command)
{
    _command = &command;
    addOutputOptions(command);
    addFrameOptions(command);
    addEyeOptions(command);
    addTerrainOptions(command);
    addWindowOptions(command);
    request.terrain.opening->watchBy(showOpening);
}

void PlayOptions::addWindowOptions(CLI::App& command)
{
    WindowRequest& window = request.window;
    _window = command
                  .add_option(
                      "--window", _windowPlace,
                      "shows it in a window, in real time; X Y WIDTH HEIGHT of it in pixels, or none of them")
                  ->expected(0, 4);
    command.add_flag("--fullscreen", window.isFullscreen, "the same on the whole screen");
    command.add_option("--screen", window.screen, "screen of the window, from 0")->check(CLI::Range(0, 63));
    command.add_option("--units", window.units, "of the figures in the picture: usual, metric or imperial")
        ->transform(terminal::named<HudUnits>(
            {{"usual", HudUnits::usual}, {"metric", HudUnits::metric}, {"imperial", HudUnits::imperial}}));
    command.add_option("--pictures", window.picturesFolder, "folder for the pictures that F12 writes");
    command.add_option("--devices", window.devicesFile,
                       "devices file: what joysticks, pedals and wheels do (docs/reference/devices-file.md)");
    command.add_option("--keys", window.keysFile,
                       "key script that is played in the window (docs/reference/key-script.md)");
    command.add_flag("--by-keys", window.byKeys,
                     "a test aid: the autopilot or driver presses the keys that a person would");
    command
        .add_option("--picture-time", window.pictureS,
                    "seconds that each picture of the window counts as, instead of the clock's")
        ->check(terminal::between(1e-3, 1.0));
}

/// Errors: a number of values that is none of --window's, what a window excludes.
foundation::Outcome PlayOptions::placeWindow()
{
    WindowRequest& window = request.window;
    window.isWanted =
        _window->count() > 0 || window.isFullscreen || !window.keysFile.empty() || window.byKeys;
    auto& place = window.place;
    for (const std::string& cell : _windowPlace)
    {
        int value = 0;
        char rest = 0;
        if (_windowPlace.size() == 1 && (cell.empty() || cell == "{}" || cell == "true")) continue; // none
        if (std::sscanf(cell.c_str(), "%d%c", &value, &rest) != 1)
            return foundation::Error{"--window", "'" + cell + "' is no number of pixels",
                                     "write X Y WIDTH HEIGHT, or --window behind the other arguments"};
        place.push_back(value);
    }
    if (!place.empty() && place.size() != 4)
        return foundation::Error{"--window", "it has " + std::to_string(place.size()) + " values",
                                 "write none, or X Y WIDTH HEIGHT"};
    if (!place.empty() && (place[2] < 16 || place[3] < 16 || place[2] > 8192 || place[3] > 8192))
        return foundation::Error{"--window", "that is no size", "write a WIDTH and HEIGHT from 16 to 8192"};
    if (window.isWanted && !request.frames.viewFile.empty())
        return foundation::Error{"--view", "a window has one channel", "leave it or the window out"};
    if (window.isWanted && !request.sound.file.empty())
        return foundation::Error{"--sound", "a window plays what is heard", "leave it or the window out"};
    if (!request.output.partsFile.empty() && (window.isWanted || !request.output.captureFolder.empty()))
        return foundation::Error{"--parts", "its pictures lack parts and are not for looking at",
                                 "leave --window and --capture out"};
    if (window.isWanted && (!request.output.statsFile.empty() || !request.output.reportFile.empty()))
        return foundation::Error{"--window", "--stats and --report are of offscreen pictures",
                                 "leave them or the window out"};
    return foundation::success();
}

void PlayOptions::addOutputOptions(CLI::App& command)
{
    command.add_option("--capture", request.output.captureFolder,
                       "folder for the images, from frame_00000.png on");
    command.add_option(
        "--scenery", request.scenery.description,
        "JSON file that describes the objects on the terrain (docs/reference/scenery-file.md)");
    command.add_option("--objects", request.scenery.modelsFolder,
                       "folder of models to scatter beside the path");
    command
        .add_option("--sound", request.sound.file,
                    "WAVE file of what is heard where the eye is, with offscreen pictures")
        ->check(terminal::extension(".wav"));
    command.add_flag("--mute", request.sound.isMuted, "nothing is heard");
    command.add_option("--stats", request.output.statsFile, "JSON file for the statistics of each frame");
    command.add_option(
        "--parts", request.output.partsFile,
        "JSON file for what the parts of a picture cost: pictures leave out one after another");
    command.add_option("--report", request.output.reportFile, "HTML file with plots of the statistics");
    command.add_option("--report-sheet", request.output.contactSheet,
                       "image file beside the report, shown in it");
    command.add_option("--report-video", request.output.video, "video file beside the report, shown in it");
}

void PlayOptions::addFrameOptions(CLI::App& command)
{
    command.add_option("--view", request.frames.viewFile, "XML file that describes one or several channels");
    command.add_option("--size", _size, "WIDTHxHEIGHT in pixels, without a view file");
    command.add_option("--fps", request.frames.perSecond, "frames per second")->check(CLI::Range(1, 240));
    command
        .add_option("--frames", request.frames.count,
                    "number of frames to draw, instead of the whole scenario")
        ->check(CLI::Range(1, kMostFrames));
    command.add_option("--backend", _backend, "osmesa or egl");
    _samples = command.add_option("--samples", request.frames.samples, "per pixel: 1 or 4")
                   ->check(CLI::IsMember({1, 4}));
    _quality = command
                   .add_option("--quality", request.frames.quality,
                               "low, medium, high or reference: what pictures leave out to be quick "
                               "(docs/reference/quality.md)")
                   ->transform(terminal::named<Quality>({{"low", Quality::low},
                                                         {"medium", Quality::medium},
                                                         {"high", Quality::high},
                                                         {"reference", Quality::reference}}));
    command.add_option("--clouds", _clouds,
                       "layers of clouds, OKTAS KIND BASE TOP as in '4 cumulus 1200 2000', parted by ';', or "
                       "none; instead of the scenario's and the world's");
    command.add_option(
        "--ground", _ground,
        "what lies on the ground at the begin: dry, moist, wet, puddles, water MM, ice, snow CM, "
        "cleared (roads have no snow), parted by ';', as in 'snow 5; cleared'");
    command.add_option(
        "--metar", _metar,
        "a weather report, as in 'LOWI 241150Z 25012KT 9999 FEW040 SCT080 18/09 Q1018': its clouds, "
        "visibility, rain or snow, temperature and pressure, and the wind");
    command
        .add_option("--shadows", _shadows,
                    "on or off: shadows of the sun on everything (the usual), or below entities alone")
        ->check(CLI::IsMember({"on", "off"}));
    command.add_option("--lights", _lights,
                       "steps 0 to 5 of lamps, such as approach=5,papi=3 or all=0: runway, centreLine, "
                       "touchdownZone, approach, papi, taxiway, beacon, obstacle, street, all");
}

void PlayOptions::addEyeOptions(CLI::App& command)
{
    command
        .add_option("--eye", _eye,
                    "camera: driver or pilot (own: whichever fits), chase, above, tower, kerb, map, or free "
                    "(--eye-at); a "
                    "tour with driver or above drives along roads")
        ->check(CLI::IsMember(eyeNames()));
    command
        .add_option(
            "--interior", _interior,
            "on or off: cockpit or car around the eye; usual with --eye driver or pilot and in a window")
        ->check(CLI::IsMember({"on", "off"}));
    command.add_option(
        "--eye-entity", request.frames.eyeEntity,
        "name of the entity that the camera is in or looks at, instead of ego or the first vehicle");
    command
        .add_option("--eye-at", _freeEye,
                    "X,Y,Z,HEADING,PITCH of the free camera: metres in the scene's frame, degrees")
        ->delimiter(',')
        ->expected(5);
    command
        .add_option(
            "--eye-height", request.frames.eyeHeightM,
            "height in metres of the eye above the ground (driver, tower, kerb) or above the car (above)")
        ->check(terminal::between(0.3, 2000.0));
}

void PlayOptions::addTerrainOptions(CLI::App& command)
{
    _tolerance =
        command.add_option("--tolerance", request.terrain.errorTolerancePx, "error target in pixels")
            ->check(terminal::between(0.01, 1000.0));
    command.add_flag("--show-voids", request.terrain.showsVoids,
                     "colour ground that is filled because the raster has no data there");
    command.add_flag("--morph", request.terrain.morphing,
                     "move vertices gradually when detail changes, with more triangles");
    command
        .add_option("--method", request.terrain.method,
                    "method of level of detail, instead of the terrain's own: " +
                        osgTerrainROAM::core::methodNames())
        ->transform(terminal::named(osgTerrainROAM::core::methodsByName()));
    command
        .add_option("--view-margin", request.terrain.viewMarginDeg,
                    "refine only what is seen and so many degrees beside it, not all around")
        ->check(terminal::between(0.0, 90.0));
    command
        .add_option("--adapt-time", request.terrain.adaptTimeUs,
                    "microseconds that a frame may adapt the terrain; the next ones do the rest")
        ->check(terminal::between(1.0, 1e6));
    command.add_option("--patch-exponent", _patchExponent,
                       "2^K triangles for each leaf, K even from 0 to 10; or 'measure': the fastest on "
                       "this machine");
    command.add_option("--max-triangles", request.terrain.maxTriangles, "triangle limit of the terrain")
        ->check(CLI::Range(2u, 100000000u));
    command
        .add_option("--spacing", request.terrain.import.spacingM,
                    "metres between samples of a raster without georeference")
        ->check(terminal::between(0.001, 1e5));
}

/// Takes --eye-at. Errors: it is there without --eye free, or the other way round.
foundation::Outcome PlayOptions::placeFreeEye()
{
    FrameRequest& frames = request.frames;
    const std::vector<double>& at = _freeEye;
    if (at.empty() != (frames.eye != EyePoint::free))
        return foundation::Error{"--eye-at", "a free camera needs a place, and no other takes one",
                                 "write --eye free --eye-at X,Y,Z,HEADING,PITCH"};
    if (!at.empty()) frames.freeEye = {{at[0], at[1], at[2]}, at[3], at[4]};
    return foundation::success();
}

/// Errors: an option that has no effect beside --headless.
foundation::Outcome PlayOptions::checkHeadless() const
{
    const CLI::Option* const headless = _command->get_option_no_throw("--headless");
    if (!headless || headless->count() == 0) return foundation::success();
    for (const char* name : {"--window", "--fullscreen", "--keys", "--by-keys", "--devices", "--pictures",
                             "--screen", "--picture-time", "--sound", "--capture", "--stats", "--report",
                             "--report-sheet", "--report-video", "--parts", "--view"})
        if (const CLI::Option* const option = _command->get_option_no_throw(name);
            option && option->count() > 0)
            return foundation::Error{name, "has no effect with --headless, which draws and plays nothing",
                                     "leave one of the two out"};
    return foundation::success();
}

foundation::Outcome PlayOptions::complete()
{
    if (const auto headless = checkHeadless(); !headless) return headless;
    char rest = 0;
    FrameRequest& frames = request.frames;
    if (std::sscanf(_size.c_str(), "%dx%d%c", &frames.widthPx, &frames.heightPx, &rest) != 2 ||
        frames.widthPx < 16 || frames.heightPx < 16 || frames.widthPx > 8192 || frames.heightPx > 8192)
        return foundation::Error{"--size", "'" + _size + "' is not a size", "write it as 960x540"};
    const auto backend = osgOffscreen::parseBackend(_backend);
    if (!backend) return backend.error();
    frames.backend = *backend;
    for (const auto& [name, eye] : kEyes)
        if (_eye == name) frames.eye = eye;
    frames.hasShadows = _shadows == "on";
    const auto steps = scenery::lightStepsOf(_lights);
    if (!steps) return foundation::Error{"--lights " + _lights, steps.error().what, steps.error().remedy};
    frames.lightSteps = *steps;
    if (!_metar.empty())
    {
        auto report = simulation::readMetar(_metar, "--metar");
        if (!report) return report.error();
        request.clouds = std::move(report->clouds);
        request.weather = std::move(report->weather);
    }
    if (!_ground.empty())
    {
        const auto ground = simulation::readSurfaceWeather(_ground, "--ground");
        if (!ground) return ground.error();
        request.ground = *ground;
    }
    if (!_clouds.empty())
    {
        auto clouds = simulation::readCloudLayers(_clouds, "--clouds");
        if (!clouds) return clouds.error();
        request.clouds = *std::move(clouds);
    }
    if (!_interior.empty()) frames.interior = _interior == "on";
    if (const auto placed = placeFreeEye(); !placed) return placed;
    if (const auto placed = placeWindow(); !placed) return placed;
    request.window.choosesSamples = _samples->count() == 0;
    // Captured pictures are the same bytes in every run, so the clock has no say in them.
    const bool isCaptured = !request.output.captureFolder.empty();
    request.window.choosesQuality = _quality->count() == 0 && !isCaptured;
    request.window.choosesTolerance = _tolerance->count() == 0 && !isCaptured;
    const bool isLive = request.window.isWanted && !isCaptured;
    request.terrain.adaptClock = isLive ? viewlod::Budget::Clock::thread : viewlod::Budget::Clock::modelled;
    if (_tolerance->count() == 0) request.terrain.errorTolerancePx = rulesOf(frames.quality).tolerancePx;
    if (frames.isInside() && frames.eyeHeightM.value_or(0.0) > kHighestDriverM)
        return foundation::Error{"--eye-height", "no driver's eye is higher than 10 m",
                                 "write a lower one, or --eye above"};
    return readPatchExponent(_patchExponent, request.terrain.patchExponent);
}

std::function<int()> PlayOptions::running(std::function<foundation::Outcome()> work)
{
    return [this, work = std::move(work)]
    {
        if (const auto sound = complete(); !sound)
            return terminal::fail("trainer", sound.error()), int{terminal::kWrongUse};
        const auto usable = checkBeforePlay(request);
        return exitCodeOf(usable ? work() : usable);
    };
}

int exitCodeOf(const foundation::Outcome& outcome)
{
    return outcome ? int{terminal::kDone} : terminal::fail("trainer", outcome.error());
}

} // namespace trainer
