// SPDX-License-Identifier: Apache-2.0
// frame_bench: measures the time of frames and the popping of the terrain, offscreen.
#include <functional>
#include <iostream>

#include <foundation/WholeFile.h>

#include "Request.h"
#include "SquareTile.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace
{

using namespace framebench;
using Command = std::function<foundation::Result<Report>(const Request&)>;

Report described(const Request& request)
{
    Report report;
    report["dem"] = std::filesystem::path(request.dem).filename().string();
    report["side"] = request.tile->tile.grid().side();
    report["cellM"] = request.tile->tile.field().spacingEastM;
    report["speedMps"] = request.flight.speedMps;
    report["aboveGroundM"] = request.flight.aboveGroundM;
    report["widthPx"] = request.picture.widthPx;
    report["heightPx"] = request.picture.heightPx;
    report["frames"] = request.frames;
    return report;
}

int run(const Command& command, Request& request)
{
    if (const auto writable = foundation::checkWritable(request.jsonFile); !writable)
        return terminal::fail("frame_bench", writable.error());
    const auto tile = squareTile(request.dem, request.crop);
    if (!tile) return terminal::fail("frame_bench", tile.error());
    request.tile = *tile;
    request.material = new osgTerrainROAM::TerrainMaterial(request.tile->tile,
                                                           osgTerrainROAM::climateOf(request.tile->tile, {}));
    const auto measured = command(request);
    if (!measured) return terminal::fail("frame_bench", measured.error());
    Report report = described(request);
    report.update(*measured);
    if (request.jsonFile.empty()) return terminal::kDone;
    const auto written = foundation::writeWholeFile(request.jsonFile, report.dump(1) + "\n");
    return written ? terminal::kDone : terminal::fail("frame_bench", written.error());
}

void addOptions(CLI::App& sub, Request& request)
{
    sub.add_option("DEM", request.dem, "elevation raster")->required();
    sub.add_option("--crop", request.crop,
                   "SIDE [COLUMN ROW]: the square to use, in samples from the north-west")
        ->expected(1, 3);
    sub.add_option("--speed", request.flight.speedMps, "metres a second")->check(terminal::between(0, 1e4));
    sub.add_option("--above", request.flight.aboveGroundM, "metres above the ground")
        ->check(terminal::between(0.5, 1e5));
    sub.add_option("--start", request.flight.startShare, "start of the flight as a share of the side")
        ->check(terminal::between(0, 0.9));
    sub.add_option("--width", request.picture.widthPx)->check(CLI::Range(16, 4096));
    sub.add_option("--height", request.picture.heightPx)->check(CLI::Range(16, 4096));
    sub.add_option("--frames", request.frames, "at 60 a second")->check(CLI::Range(2, 100000));
    sub.add_option("--tolerance", request.tolerancesPx, "error targets in pixels")
        ->check(terminal::between(1e-6, 1000.0));
    sub.add_option("--json", request.jsonFile, "also write the table to this file");
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Measures the terrain in frames drawn offscreen.", "frame_bench");
    app.require_subcommand(1);
    Request request;
    Command command;
    CLI::App* times = app.add_subcommand(
        "times", "milliseconds a frame: ours, the full grid, osgTerrain's GeometryTechnique");
    CLI::App* pop =
        app.add_subcommand("pop", "change between frames of the difference from the image of the full mesh");
    CLI::App* database = app.add_subcommand(
        "database", "milliseconds a frame of a database of osgTerrain tiles: GeometryTechnique and ours");
    for (CLI::App* sub : {times, pop, database})
        addOptions(*sub, request);
    times->callback([&] { command = measureFrames; });
    database->callback([&] { command = measureDatabase; });
    database->add_option("--tile-cells", request.tileCells, "cells along a tile")->check(CLI::Range(2, 4096));
    pop->callback([&] { command = measurePop; });
    pop->add_option("--antialiasing", request.antialiasing, "none, msaa4, ssaa2, ssaa4")
        ->check(CLI::IsMember({"none", "msaa4", "ssaa2", "ssaa4"}));
    pop->add_option("--coarse-frame", request.coarseFrame,
                    "refine this frame ten times coarser, to test the measurement");
    pop->add_option("--pictures", request.pictureFolder, "folder for images of one frame")
        ->check(CLI::ExistingDirectory);
    pop->add_option("--picture-frame", request.pictureFrame, "index of that frame");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return run(command, request);
}
