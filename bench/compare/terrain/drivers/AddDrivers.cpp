// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/drivers/AddDrivers.h"

#include <memory>

#include "compare/terrain/drivers/DriversRequest.h"
#include "terminal/CommandLine.h"

namespace terraintool
{

void addDrivers(CLI::App& app, Chosen& chosen)
{
    CLI::App* sub = app.add_subcommand(
        "drivers", "measure the drivers on the benchmark paths over a planar square of the terrain");
    const auto request = std::make_shared<DriversRequest>();
    sub->add_option("FILE", request->files, ".roam files or elevation rasters")->required();
    sub->add_option("--json", chosen.jsonFile, "also write the table to this file");
    sub->add_option("--spacing", request->import.spacingM,
                    "metres between samples of a raster without georeference")
        ->check(terminal::between(0.001, 1e5));
    sub->add_option("--patch-exponent", request->patchExponent, "2^K triangles for each leaf")
        ->check(CLI::IsMember({0, 2, 4, 6, 8, 10}));
    sub->add_option("--tolerance", request->tolerancesPx, "error targets in pixels")
        ->check(terminal::between(0.01, 1000.0));
    sub->add_flag("--nearby", request->leavesNearby,
                  "put leaves into free slots, not in the order of the bintree");
    sub->add_flag("--centre", request->centrePixels, "hold the target in the middle of the image only");
    sub->add_option("--crop", request->crop,
                    "SIDE [COLUMN ROW]: the square to use, in samples from the north-west")
        ->expected(1, 3)
        ->check(CLI::Range(0, 65536));
    sub->add_option("--cell", request->cellM, "metres between samples, instead of the file's")
        ->check(terminal::between(0.001, 1e5));
    sub->add_option("--dump", request->dumpFolder, "folder for camera, matrix and triangles of some frames");
    sub->add_option("--frames", request->frames, "frames of each path (240)")->check(CLI::Range(1, 100000));
    sub->add_option("--check-every", request->framesBetweenChecks,
                    "check every Nth frame by brute force (120); 1: all")
        ->check(CLI::Range(1, 100000));
    sub->add_option("--drivers", request->drivers, "only these drivers: wheel, walk, queue, scratch")
        ->check(CLI::IsMember({"wheel", "walk", "queue", "scratch"}));
    sub->callback([request, &chosen] { chosen.work = [request] { return compareDrivers(*request); }; });
}

} // namespace terraintool
