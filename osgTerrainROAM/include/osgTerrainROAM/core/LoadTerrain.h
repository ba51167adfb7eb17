// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Describes the terrain of a file: a .roam text is read; any other file counts as the elevation raster itself, with `import` and
/// defaults for the rest. Errors: those of readRoamFile. A missing raster is an error of loadTile.
foundation::Result<RoamFile> describeTerrain(const std::filesystem::path& file,
                                             const DemImportOptions& import = {});

/// Computes the grid exponent (PlacedTileOptions) that brings grid points to `spacingM` (metres) from each other or less, with 1 %
/// tolerance; or the largest possible exponent where that is less.
int gridExponentFor(const HeightField& field, double spacingM);

/// Imports and places the terrain of a description. Errors: those of importDem.
foundation::Result<PlacedTile> loadTile(const RoamFile& description);

} // namespace osgTerrainROAM::core
