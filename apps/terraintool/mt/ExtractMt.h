// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/output/QuantizedMeshTile.h>
#include <osgMultiTriangulation/core/zone/ExtractFromFile.h>

#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of mt-extract asks for.
struct MtExtractRequest
{
    std::filesystem::path file, output;
    bool inReference = false; ///< coordinates are those of the reference system, not of the plan
    std::optional<osgMultiTriangulation::core::EarthTile> tile{}; ///< of a .terrain file
    osgMultiTriangulation::core::ExtractRequest what;
};

/// Writes one triangulation of a .mt file as a file of triangles, .obj, .ply or .terrain.
foundation::Result<terminal::Report> extractMt(const MtExtractRequest& request);

/// What the head and the directory of a .mt file tell, as a row of the table of `info`.
nlohmann::ordered_json describeMt(const osgMultiTriangulation::core::MtFile& file);

} // namespace terraintool
