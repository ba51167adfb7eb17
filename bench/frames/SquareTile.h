// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace framebench
{

/// A planar square of an elevation raster: SIDE samples, and COLUMN and ROW of its north-western one (absent: the square
/// lies in the middle). Planar, because osgTerrain's height field is, so that all draw the same ground; 2^n+1 samples,
/// so that the full grid is the bintree's finest mesh. Errors: as importDem(); a square that is no part of the raster.
foundation::Result<std::shared_ptr<const osgTerrainROAM::core::RoamTile>>
squareTile(const std::filesystem::path& file, const std::vector<int>& crop);

} // namespace framebench
