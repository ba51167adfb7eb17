// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM
{

/// The raster of a surface map: one texel per sample of a tile's raster or of one of its sheets, or per
/// several samples where the map would be larger than graphics cards allow.
struct MapGrid
{
    static constexpr int kMaxSide = 8192;

    int step = 1; ///< grid positions of the tile per texel
    int width = 0;
    int height = 0;
    int west = 0, south = 0; ///< grid position of the first texel
    bool isOfRaster = true;

    explicit MapGrid(const core::PlacedTile& tile)
        : MapGrid({0, 0, tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1}, tile.grid().cellSide())
    {
    }
    explicit MapGrid(const core::SampleSheet& sheet) : MapGrid(sheet.rect(), sheet.step())
    {
        isOfRaster = false;
    }

    /// The distance between neighbouring texels, the mean of both directions.
    double spacingM(const core::PlacedTile& tile) const
    {
        return 0.5 * (tile.field().spacingEastM + tile.field().spacingNorthM) * step / tile.grid().cellSide();
    }

    /// The position of a texel, or of the nearest one inside the map.
    glm::dvec3 position(const core::PlacedTile& tile, int x, int y) const
    {
        const int column = west + std::clamp(x, 0, width - 1) * step,
                  row = south + std::clamp(y, 0, height - 1) * step;
        return isOfRaster ? tile.rasterPosition(column, row) : tile.position(column, row);
    }

private:
    MapGrid(const core::GridRect& rect, int leastStep) : step(leastStep), west(rect.west), south(rect.south)
    {
        while (std::max(rect.east - rect.west, rect.north - rect.south) / step + 1 > kMaxSide)
            step *= 2;
        width = (rect.east - rect.west) / step + 1;
        height = (rect.north - rect.south) / step + 1;
    }
};

} // namespace osgTerrainROAM
