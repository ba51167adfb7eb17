// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include <osgTerrainROAM/core/cover/CoverTable.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Land cover over a tile: one kind a texel, first and last texel centres on the first and last samples of the data.
struct CoverMap
{
    int width = 0, height = 0;
    std::vector<GroundKind> kinds; ///< row-major, southernmost row first
    std::map<int, std::size_t>
        unknownCodes; ///< texels of codes that the table does not know; 32 codes at most

    GroundKind at(int x, int y) const { return kinds[static_cast<std::size_t>(y) * width + x]; }
};

/// Lays a raster of classes (any that GDAL opens, its first band) over a tile, in the raster's own resolution but no more than
/// 8192 texels a side; the nearest class, never a mean. NoData and what lies beyond the raster is unknown.
/// Errors: not a raster, no georeference that can be related to the tile's, nothing of the tile covered by a known class.
/// Memory: a byte a texel, twice while it is made. Threads: any.
foundation::Result<CoverMap> importCover(const std::filesystem::path& file, const CoverTable& table,
                                         const PlacedTile& tile);

} // namespace osgTerrainROAM::core
