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

/// Builds made-up points of four distributions, and fits how time and borders grow with their number.
foundation::Result<terminal::Report> benchMt(const MtBenchRequest& request);

/// Builds a split multi-triangulation from elevation rasters, or from files of points (.csv, .xyz, .txt).
foundation::Result<terminal::Report> buildMt(const MtBuildRequest& request);

/// Checks a .mt file: every tree by itself, how they hang together, and a flight over all that is whole.
/// Adds a row of a table to `report`, and prints it.
void validateMt(const std::filesystem::path& file, int frames, terminal::Report& report);

} // namespace terraintool
