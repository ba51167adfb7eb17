// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// Describes the terrain of a file: a .roam text is read, a folder stands for the world.roam in it; any other
/// file counts as the elevation raster itself, with `import` and defaults for the rest. Errors: those of
/// readRoamFile. A missing raster is an error of loadTile.
foundation::Result<RoamFile> describeTerrain(const std::filesystem::path& file,
                                             const DemImportOptions& import = {});

/// Computes the grid exponent (PlacedTileOptions) that brings grid points to `spacingM` (metres) from each
/// other or less, with 1 % tolerance; or the largest possible exponent where that is less.
int gridExponentFor(const HeightField& field, double spacingM);

/// Imports and places the terrain of a description. Errors: those of importDem.
foundation::Result<PlacedTile> loadTile(const RoamFile& description);

/// The same with the bounds of its vertices and the edits that the description names. Without edits, the
/// ground is shaped by its earthworks.
/// `kept`: as RoamTile's. Errors: those of loadTile(), readEdits() and shapeGround().
foundation::Result<std::shared_ptr<RoamTile>> loadRoamTile(const RoamFile& description,
                                                           const foundation::KeptResults* kept = nullptr);

/// The mark of what the edits of a description are made from: the bytes of its roads' file, and how these are
/// placed. Errors: a file that cannot be read.
foundation::Result<std::uint64_t> editSourceOf(const RoamFile& description);

} // namespace osgTerrainROAM::core
