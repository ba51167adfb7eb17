// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "compare/terrain/drivers/BenchSquare.h"
#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of methods asks for.
struct MethodsRequest
{
    std::vector<std::string> files; ///< elevation rasters
    osgTerrainROAM::core::DemImportOptions import;
    SquareChoice square;
    std::filesystem::path flight; ///< a scenario; empty: BenchmarkFlight
    double errorPx = 2.0;
    int frames = 48;
    int framesBetweenChecks = 12;
    std::vector<std::string> external; ///< NAME=COMMAND: programs that make meshes (ExternalRival.h)
    std::filesystem::path html;        ///< the report; empty: none
    std::filesystem::path markdown;    ///< its tables; empty: none
};

/// Compares all methods of level of detail over the same flight, at equal true error and at equal numbers of
/// triangles.
foundation::Result<terminal::Report> compareMethods(const MethodsRequest& request);

} // namespace terraintool
