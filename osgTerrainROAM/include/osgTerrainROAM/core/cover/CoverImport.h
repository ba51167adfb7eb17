// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <foundation/KeptFrom.h>

#include <osgTerrainROAM/core/cover/CoverTable.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Land cover over a tile: one kind a texel. The centres of the first and last texels lie on the first and
/// last samples of the data.
struct CoverMap
{
    int width = 0, height = 0;
    std::vector<GroundKind> kinds; ///< row-major, southernmost row first
    std::map<int, std::size_t>
        unknownCodes;                 ///< number of texels by code that is not in the table; 32 codes at most
    std::vector<std::string> notes{}; ///< what GDAL warned of, one line each

    GroundKind at(int x, int y) const { return kinds[static_cast<std::size_t>(y) * width + x]; }
};

/// Resamples the first band of a raster of classes (any that GDAL opens) over a tile, at the raster's own
/// resolution but no more than 8192 texels a side. Takes the nearest class, never a mean. NoData, and texels
/// beyond the raster, are unknown.
/// Errors: not a raster, no georeference that can be related to the tile's, no known class on the tile.
/// `kept`: what follows from the tile (RoamTile::mark()); what a GeoTIFF gave is found there the second time.
/// Memory: 1 B a texel, 2 B during the import. Threads: any.
foundation::Result<CoverMap> importCover(const std::filesystem::path& file, const CoverTable& table,
                                         const PlacedTile& tile, const foundation::KeptFrom& kept = {});

} // namespace osgTerrainROAM::core
