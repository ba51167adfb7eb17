// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

namespace osgTerrainROAM::core
{

/// Tells what the heads of the rasters say against importing them, without reading their samples: a fraction
/// of a second where the import takes many. Errors: those of importDems that do not come from samples,
/// extents and vertical datums.
foundation::Outcome checkDems(std::span<const std::filesystem::path> files,
                              const DemImportOptions& options = {});

} // namespace osgTerrainROAM::core
