// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/zone/ExtractFromFile.h>

#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of mt-extract asks for.
struct MtExtractRequest
{
    std::filesystem::path file, output;
    bool inReference = false; ///< coordinates are those of the reference system, not of the plan
    osgMultiTriangulation::core::ExtractRequest what;
};

/// Writes one triangulation of a .mt file as a file of triangles, .obj or .ply.
foundation::Result<terminal::Report> extractMt(const MtExtractRequest& request);

/// What the head and the directory of a .mt file tell, as a row of the table of `info`.
nlohmann::ordered_json describeMt(const osgMultiTriangulation::core::MtFile& file);

} // namespace terraintool
