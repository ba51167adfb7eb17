// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// What a terrain file says: a .roam text is read, any other file is taken for the elevation raster itself, with
/// `import` and everything else at its default. Errors: as readRoamFile; a missing raster shows in loadTile.
foundation::Result<RoamFile> describeTerrain(const std::filesystem::path& file,
                                             const DemImportOptions& import = {});

/// How much finer than the raster a grid has to be for places that are `spacingM` apart or less, to 1 % (PlacedTileOptions); as fine
/// as it can be where that is not enough. Units: metres.
int gridExponentFor(const HeightField& field, double spacingM);

/// Imports and places the samples that a description names. Errors: as importDem.
foundation::Result<PlacedTile> loadTile(const RoamFile& description);

} // namespace osgTerrainROAM::core
