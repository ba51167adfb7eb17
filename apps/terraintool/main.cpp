// SPDX-License-Identifier: Apache-2.0
// terraintool: inspects elevation files and checks the terrain that the ROAM engine draws from them.
#include <string_view>

#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terraintool/RunCommand.h"
#include "terraintool/compare/AddCompareCommand.h"
#include "terraintool/compare/MeshPainter.h"
#include "terraintool/mt/AddMtCommands.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Inspects elevation files and validates the terrain drawn from them.", "terraintool");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    terraintool::Request request;
    std::filesystem::path jsonFile;
    terraintool::Command command;
    const auto add = [&](const char* name, const char* what, const terraintool::Command& action)
    {
        CLI::App* sub = app.add_subcommand(name, what);
        sub->add_option("FILE", request.files, ".roam files or elevation rasters")->required();
        sub->add_option("--json", jsonFile, "also write the table to this file");
        sub->add_option("--spacing", request.import.spacingM,
                        "metres between samples of a raster without georeference")
            ->check(terminal::between(0.001, 1e5));
        sub->callback([&command, action] { command = action; });
        return sub;
    };
    add("info", "size, heights, voids and placement", terraintool::info);
    CLI::App* validate =
        add("validate", "fly the tour, or a scenario (.xosc), and check every mesh by brute force",
            terraintool::validate);
    validate->add_option("--frames", request.frames, "frames of the flight")->check(CLI::Range(1, 1'000'000));
    validate->add_option("--tolerance", request.tolerancePx, "error target in pixels")
        ->check(terminal::between(0.01, 1000.0));
    validate->add_option("--max-triangles", request.maxTriangles, "triangle limit")
        ->check(CLI::Range(2u, 100000000u));
    validate
        ->add_option("--method", request.method,
                     "method of level of detail, instead of the terrain's own: " +
                         osgTerrainROAM::core::methodNames())
        ->transform(terminal::named(osgTerrainROAM::core::methodsByName()));
    validate->add_flag("--morph", request.morphing, "check the terrain drawn with morphing");
    const auto addPatches = [&](CLI::App* sub)
    {
        sub->add_option("--patch-exponent", request.patchExponent, "2^K triangles for each leaf")
            ->check(CLI::IsMember({0, 2, 4, 6, 8, 10}));
    };
    addPatches(validate);
    CLI::App* bench =
        add("bench", "measure the drivers on the benchmark paths over a planar square of the terrain",
            terraintool::bench);
    addPatches(bench);
    bench->add_option("--tolerance", request.tolerancesPx, "error targets in pixels")
        ->check(terminal::between(0.01, 1000.0));
    bench->add_flag("--nearby", request.leavesNearby,
                    "put leaves into free slots, not in the order of the bintree");
    bench->add_flag("--centre", request.centrePixels, "hold the target in the middle of the image only");
    bench
        ->add_option("--crop", request.crop,
                     "SIDE [COLUMN ROW]: the square to use, in samples from the north-west")
        ->expected(1, 3)
        ->check(CLI::Range(0, 65536));
    bench->add_option("--cell", request.cellM, "metres between samples, instead of the file's")
        ->check(terminal::between(0.001, 1e5));
    bench->add_option("--dump", request.dumpFolder, "folder for camera, matrix and triangles of some frames");
    bench->add_option("--frames", request.benchFrames, "frames of each path (240)")
        ->check(CLI::Range(1, 100000));
    bench
        ->add_option("--check-every", request.framesBetweenChecks,
                     "check every Nth frame by brute force (120); 1: all")
        ->check(CLI::Range(1, 100000));
    bench->add_option("--drivers", request.drivers, "only these drivers: wheel, walk, queue, scratch")
        ->check(CLI::IsMember({"wheel", "walk", "queue", "scratch"}));
    terraintool::addCompare(app, jsonFile, command);
    terraintool::addMtBuild(app, jsonFile, command);
    terraintool::addMtJobs(app, jsonFile, command);
    terraintool::addMtBench(app, jsonFile, command);
    terraintool::addMtFly(app, jsonFile, command);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terraintool::run(command, request, jsonFile);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc > 1 && std::string_view(argv[1]) == "compare") terraintool::becomeProgramWithPainter(argv);
    return terminal::guarded("terraintool", [=] { return run(argc, argv); });
}
