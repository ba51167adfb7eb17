// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of drivers asks for.
struct DriversRequest
{
    std::vector<std::string> files; ///< .roam files, elevation rasters
    osgTerrainROAM::core::DemImportOptions import;
    int patchExponent = 0; ///< 2^k triangles for each leaf
    int frames = 240;
    int framesBetweenChecks = 120;    ///< by brute force; 1: every frame is checked, and dumped
    std::vector<std::string> drivers; ///< names; empty: all of them
    std::vector<double> tolerancesPx{2.0, 1.0};
    bool leavesNearby = false;   ///< LeafPlacement::nearby
    bool centrePixels = false;   ///< the tolerance holds in the middle of the picture
    std::vector<int> crop;       ///< side in samples; column and row of its north-west sample
    std::optional<double> cellM; ///< sample distance instead of the file's
    std::filesystem::path dumpFolder;
};

/// Measures every driver on the benchmark paths over a planar square of each terrain.
foundation::Result<terminal::Report> compareDrivers(const DriversRequest& request);

} // namespace terraintool
