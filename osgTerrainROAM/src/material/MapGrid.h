// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM
{

/// The raster of the surface maps: one texel per sample of the raster, or per several where that would exceed what graphics
/// cards take.
struct MapGrid
{
    static constexpr int kMaxSide = 8192;

    int step = 1; ///< places of the tile's grid to a texel
    int width = 0;
    int height = 0;

    explicit MapGrid(const core::PlacedTile& tile)
    {
        step = 1 << tile.gridExponent();
        while ((std::max(tile.dataColumns(), tile.dataRows()) - 1) / step + 1 > kMaxSide)
            step *= 2;
        width = (tile.dataColumns() - 1) / step + 1;
        height = (tile.dataRows() - 1) / step + 1;
    }
};

} // namespace osgTerrainROAM
