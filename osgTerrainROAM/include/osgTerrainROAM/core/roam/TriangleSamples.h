// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Calls visit(GridPoint) for every sample of the data in a triangle, its borders included: the raster's, row by row, then
/// those between. Some may be given twice.
template<class Visit>
void forEachSampleIn(const PlacedTile& tile, const GridTriangle& triangle, const Visit& visit)
{
    const int step = 1 << tile.gridExponent();
    triangle.forEachRow(
        tile.dataColumns(), tile.dataRows(),
        [&](int row, int west, int east)
        {
            for (int column = west; column <= east; column += step)
                if (tile.isGround(column, row)) visit(GridPoint{column, row});
        },
        step);
    if (tile.fineSamples().isEmpty()) return;
    tile.fineSamples().forEachIn(triangle.extent(),
                                 [&](int column, int row)
                                 {
                                     if (triangle.holds({column, row})) visit(GridPoint{column, row});
                                 });
}

} // namespace osgTerrainROAM::core
