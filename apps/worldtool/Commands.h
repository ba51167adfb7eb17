// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "terminal/Places.h"
#include "terminal/Report.h"

namespace worldtool
{

/// The values of the command line.
struct Request
{
    std::vector<std::filesystem::path> dems; ///< elevation rasters, one or more
    std::vector<std::filesystem::path> maps; ///< files, folders and archives of a map; empty: one is made up
    std::uint64_t seed = 1;                  ///< of what is made up
    std::optional<double> aridity;           ///< of what is made up: 0 wet … 1 desert; absent: of the place
    std::filesystem::path
        landCover; ///< a raster of land cover, for what the map says nothing of; empty: none
    std::filesystem::path landCoverClasses = "worldcover"; ///< as readCoverTable() takes it
    int jobs = 0;                                          ///< processors to use at most; 0: all
    std::filesystem::path runways;                         ///< a table of OurAirports; empty: none
    std::filesystem::path world;                           ///< the folder to write
    std::string version;                                   ///< of the program: another one makes a world anew
    std::vector<double> bounds; ///< west, south, east, north in degrees; empty: the whole map
};

using terminal::Report;

/// Names the map of a request, for messages.
std::string mapNameOf(const Request& request);

/// What a build reads and writes.
terminal::Places placesOf(const Request& request);

/// Makes a world of elevation data and a map, or of one that is made up: WORLD/roads.xodr, buildings.gpkg,
/// ground.gpkg, landcover.tif, trees.gpkg, world.roam, and a report of what was used. The folder is made
/// where there is none; of its files those alone are replaced, each as a whole. What is wrong with the heads
/// of the inputs is told before any work.
/// Errors: those of importDems(), mapSourcesOf(), joinOsm(), readOsm(), readLand() and buildStreets(); bounds
/// that are none; files that cannot be written.
foundation::Result<Report> build(const Request& request);

/// Looks by brute force for what stands wrong in a world: a folder with world.roam, or a .roam file. The
/// report is not sound where anything does. Errors: those of readRoamFile(), loadRoadTile(), importShapes()
/// and importFeatures().
foundation::Result<Report> check(const std::filesystem::path& world);

} // namespace worldtool
