// SPDX-License-Identifier: Apache-2.0
// terraintool: inspects elevation files and checks the terrain that the ROAM engine draws from them.
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terminal/MovedCommand.h"
#include "terraintool/RunCommand.h"
#include "terraintool/mt/AddMtCommands.h"

namespace
{

constexpr terminal::MovedCommand kMoved[] = {
    {"compare", "compare_terrain methods"}, {"bench", "compare_terrain drivers"}, {"mt-bench", "mt_bench"}};

int run(int argc, char** argv)
{
    if (const auto ends = terminal::answerMoved("terraintool", kMoved, argc, argv)) return *ends;
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
    add("info", "size, heights, voids and placement; of a .mt file its trees", terraintool::info);
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
    validate->add_option("--patch-exponent", request.patchExponent, "2^K triangles for each leaf")
        ->check(CLI::IsMember({0, 2, 4, 6, 8, 10}));
    validate
        ->add_option("--view-margin", request.viewMarginDeg,
                     "refine only what is seen and so many degrees beside it")
        ->check(terminal::between(0.0, 90.0));
    terraintool::addMtBuild(app, jsonFile, command);
    terraintool::addMtJobs(app, jsonFile, command);
    terraintool::addMtExtract(app, jsonFile, command);
    terraintool::addMtFly(app, jsonFile, command);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terraintool::run(command, request, jsonFile);
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("terraintool", [=] { return run(argc, argv); });
}
