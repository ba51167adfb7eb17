// SPDX-License-Identifier: Apache-2.0
#include "terraintool/mt/AddMtCommands.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <foundation/Threads.h>

#include "terminal/CommandLine.h"
#include "terraintool/mt/ExtractMt.h"

namespace terraintool
{

namespace
{

using osgPMObjects::core::DiagonalRule;

const std::map<std::string, DiagonalRule> kDiagonals{
    {"heights", DiagonalRule::nearestHeights},
    {"height-difference", DiagonalRule::largestHeightDifference},
    {"angle", DiagonalRule::largestNormalAngle},
    {"areas", DiagonalRule::nearestAreas}};

/// Declares what a build is made of: inputs, memory, rectangles.
void addSurfaceOptions(CLI::App& app, MtBuildRequest& request)
{
    app.add_option("INPUT", request.inputs, "rasters, files of points, or a TIN")->required();
    app.add_option("--memory", request.memoryMb, "MB that the build may take")
        ->check(terminal::between(1.0, 1e7));
    app.add_option("--trees", request.options.treeCount, "rectangles; without it: balanced")
        ->check(CLI::Range(1u, 1'000'000u));
    app.add_flag_callback(
        "--median", [&request] { request.options.where = osgMultiTriangulation::core::SplitAt::median; },
        "halve rectangles at the median");
    app.add_option("--spacing", request.import.spacingM, "metres between samples without georeference")
        ->check(terminal::between(0.001, 1e5));
    app.add_option("--quad-diagonal", request.diagonal,
                   "diagonal along which cells of rasters are cut: between corners of the nearest heights "
                   "(heights), or of the most different; angle: largest angle between the triangles; areas: "
                   "most similar areas")
        ->transform(terminal::named(kDiagonals));
}

} // namespace

void addMtBuildOptions(CLI::App& app, MtBuildRequest& request, std::filesystem::path& jsonFile)
{
    addSurfaceOptions(app, request);
    app.add_option("-o,--output", request.output, "the file to write")
        ->required()
        ->check(terminal::extension(".mt"));
    app.add_option("--json", jsonFile, "also write the table to this file");
}

void addMtBuild(CLI::App& app, std::filesystem::path& jsonFile, Command& command)
{
    CLI::App* sub = app.add_subcommand("mt-build", "build a multi-triangulation, a .mt file");
    const auto request = std::make_shared<MtBuildRequest>();
    request->options.jobs = static_cast<unsigned>(foundation::processors());
    addMtBuildOptions(*sub, *request, jsonFile);
    sub->add_option("--jobs", request->options.jobs, "threads")->check(CLI::Range(1u, 1024u));
    sub->callback([request, &command] { command = [request](const Request&) { return buildMt(*request); }; });
}

void addMtJobs(CLI::App& app, std::filesystem::path& jsonFile, Command& command)
{
    CLI::App* plan = app.add_subcommand("mt-plan", "cut a build into jobs, for many processes");
    const auto build = std::make_shared<MtBuildRequest>();
    addSurfaceOptions(*plan, *build);
    plan->add_option("-o,--output", build->output, "the folder of the jobs")->required();
    plan->add_option("--json", jsonFile, "also write the table to this file");
    plan->callback([build, &command] { command = [build](const Request&) { return planMt(*build); }; });

    CLI::App* job = app.add_subcommand("mt-job", "do jobs of a plan");
    const auto request = std::make_shared<MtJobRequest>();
    job->add_option("FOLDER", request->folder, "of mt-plan")->required()->check(CLI::ExistingDirectory);
    job->add_option("JOB", request->jobs, "numbers of jobs")->required();
    job->callback([request, &command]
                  { command = [request](const Request&) { return doMtJobs(*request); }; });

    CLI::App* join = app.add_subcommand("mt-join", "write the .mt file of a plan whose jobs are done");
    join->add_option("FOLDER", request->folder, "of mt-plan")->required()->check(CLI::ExistingDirectory);
    join->add_option("-o,--output", request->output, "the file to write")
        ->required()
        ->check(terminal::extension(".mt"));
    join->add_option("--json", jsonFile, "also write the table to this file");
    join->callback([request, &command] { command = [request](const Request&) { return joinMt(*request); }; });
}

void addMtExtract(CLI::App& app, std::filesystem::path& jsonFile, Command& command)
{
    CLI::App* sub = app.add_subcommand("mt-extract", "write one triangulation of a .mt file");
    const auto request = std::make_shared<MtExtractRequest>();
    const auto region = std::make_shared<std::vector<double>>();
    sub->add_option("FILE", request->file, "the .mt file")->required()->check(CLI::ExistingFile);
    sub->add_option("-o,--output", request->output, "the file to write")
        ->required()
        ->check(terminal::extension(".obj") | terminal::extension(".ply") | terminal::extension(".terrain"));
    const auto tile = std::make_shared<std::string>();
    sub->add_option("--tile", *tile, "LEVEL/COLUMN/ROW of a .terrain file");
    sub->add_option("--error", request->what.errorM, "metres along the vertical; without it: all points")
        ->check(terminal::between(0.0, 1e5));
    sub->add_option("--triangles", request->what.mostTriangles, "no more than so many")
        ->check(CLI::Range(2u, 2'000'000'000u));
    sub->add_option("--region", *region, "west, south, east, north: fine there alone")
        ->expected(4)
        ->delimiter(',');
    const auto places = std::make_shared<std::string>("plan");
    sub->add_option("--places", *places, "coordinates in metres of the plan, or those of its georeference")
        ->check(CLI::IsMember({"plan", "georeference"}));
    sub->add_option("--json", jsonFile, "also write the table to this file");
    sub->callback(
        [request, region, places, tile, &command]
        {
            if (!tile->empty())
            {
                const auto named = osgMultiTriangulation::core::earthTileOf(*tile);
                if (!named) throw CLI::ValidationError("--tile", named.error().message());
                request->tile = *named;
            }
            request->inReference = *places == "georeference";
            if (region->size() == 4)
                request->what.region = {(*region)[0], (*region)[1], (*region)[2], (*region)[3]};
            command = [request](const Request&) { return extractMt(*request); };
        });
}

void addMtFly(CLI::App& app, std::filesystem::path& jsonFile, Command& command)
{
    CLI::App* sub = app.add_subcommand("mt-fly", "fly over a .mt file without drawing, in real time");
    const auto request = std::make_shared<MtFlyRequest>();
    sub->add_option("FILE", request->file, "the .mt file")->required()->check(CLI::ExistingFile);
    sub->add_option("--speed", request->speedMps, "m/s (100)")->check(terminal::between(0.0, 10000.0));
    sub->add_option("--above", request->aboveM, "metres above ground (100)")
        ->check(terminal::between(1.0, 1e5));
    sub->add_option("--seconds", request->seconds, "length (60)")->check(terminal::between(1.0, 36000.0));
    sub->add_option("--memory", request->memoryMb, "MB for trees (64)")->check(terminal::between(1.0, 1e7));
    sub->add_option("--rate", request->megabytesPerS, "MB/s of the disk (50)")
        ->check(terminal::between(0.0, 1e5));
    sub->add_option("--tolerance", request->tolerancePx, "pixels (2)")
        ->check(terminal::between(0.01, 1000.0));
    sub->add_option("--json", jsonFile, "also write the table to this file");
    sub->callback([request, &command] { command = [request](const Request&) { return flyMt(*request); }; });
}

} // namespace terraintool
