// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of mt-build asks for.
struct MtBuildRequest
{
    std::vector<std::filesystem::path> inputs;
    std::filesystem::path output;
    osgTerrainROAM::core::DemImportOptions import;
    osgMultiTriangulation::core::ForestOptions options;
    double memoryMb = 0.0; ///< 0: no limit
};

/// What the command line of mt-bench asks for.
struct MtBenchRequest
{
    std::vector<std::size_t> points{10'000, 50'000, 100'000, 250'000, 500'000};
    std::filesystem::path folder; ///< for the files, which are removed again
    osgMultiTriangulation::core::ForestOptions options;
};

/// What the command line of mt-fly asks for.
struct MtFlyRequest
{
    std::filesystem::path file;
    double speedMps = 100.0, aboveM = 100.0, seconds = 60.0;
    double memoryMb = 64.0;      ///< that trees may take
    double megabytesPerS = 50.0; ///< reading is slowed down to this; 0: it is not
    double tolerancePx = 2.0;
    int widthPx = 1280; ///< of the picture, which is 60 degrees wide
};

/// Flies over a .mt file in real time, 60 frames a second, without drawing: measures how long frames wait, and checks surfaces for holes.
foundation::Result<terminal::Report> flyMt(const MtFlyRequest& request);

/// Builds made-up points of four distributions, and fits how time and borders grow with their number.
foundation::Result<terminal::Report> benchMt(const MtBenchRequest& request);

/// Builds a split multi-triangulation from elevation rasters, from files of points (.csv, .xyz, .txt), or from a file of triangles (.obj, .ply,
/// .terrain).
foundation::Result<terminal::Report> buildMt(const MtBuildRequest& request);

/// Checks a .mt file: every tree by itself, how they hang together, and a flight over all that is whole.
/// Adds a row of a table to `report`, and prints it.
void validateMt(const std::filesystem::path& file, int frames, terminal::Report& report);

} // namespace terraintool
