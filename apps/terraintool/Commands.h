// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/method/Method.h>

#include "terminal/Report.h"

namespace terraintool
{

/// The values of the command line.
struct Request
{
    std::vector<std::string> files; ///< .roam files, elevation rasters; to validate also .xosc
    osgTerrainROAM::core::DemImportOptions import;
    int frames = 480; ///< of the tour's 20 seconds: every one at 24 per second
    double tolerancePx = 1.0;
    unsigned maxTriangles = 500000;
    bool morphing = false;                                ///< check what is drawn with morphing
    std::optional<osgTerrainROAM::core::Method> method{}; ///< absent: the terrain's own
    int patchExponent = 0;                                ///< 2^k triangles for each leaf
    std::optional<double> viewMarginDeg{};                ///< absent: the terrain's own
};

using terminal::Report;

/// Tells what is wrong with the heads of all files before the first is loaded. Errors: those of
/// describeTerrain(), checkDems() and checkReadable().
foundation::Outcome checkHeads(const Request& request);

/// Sizes, heights, voids and placement of each file.
foundation::Result<Report> info(const Request& request);

/// Flies the tour over each terrain, and the path of each scenario (.xosc) over the terrain that it names,
/// and checks the mesh of every frame by brute force. A .mt file is checked by validateMt().
foundation::Result<Report> validate(const Request& request);

} // namespace terraintool
