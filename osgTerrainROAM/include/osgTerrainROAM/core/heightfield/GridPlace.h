// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

namespace osgTerrainROAM::core
{

/// Where the samples of a raster lie in its own reference system. Units: those of the system; metres where
/// there is none.
struct GridPlace
{
    std::string system;                ///< as well-known text; empty: a plane without a relation to the Earth
    double firstX = 0.0, firstY = 0.0; ///< of the south-western sample
    double stepX = 1.0, stepY = 1.0;   ///< from one sample to the next, eastwards and northwards, above 0
};

/// importDems(), which tells where the grid lies, too. `place`: nothing where there is no georeference.
foundation::Result<HeightField> importDems(std::span<const std::filesystem::path> files,
                                           const DemImportOptions& options, std::optional<GridPlace>& place);

} // namespace osgTerrainROAM::core
