// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace framebench
{

/// Reads a planar square of an elevation raster: SIDE samples, and COLUMN and ROW of its north-western sample
/// (absent: the middle). It is planar as the height field of osgTerrain is, so that all draw the same ground;
/// 2^n+1 samples, so that the full grid is the finest mesh of the bintree. Errors: as importDem(); a square
/// outside the raster.
foundation::Result<std::shared_ptr<const osgTerrainROAM::core::RoamTile>>
squareTile(const std::filesystem::path& file, const std::vector<int>& crop);

} // namespace framebench
