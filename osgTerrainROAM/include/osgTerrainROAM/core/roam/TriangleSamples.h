// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Calls visit(GridPoint) for every sample of a tile's sheets in a triangle (GridTriangle or PlanTriangle),
/// its borders included, row by row.
template<class Triangle, class Visit>
void forEachSheetSampleIn(const PlacedTile& tile, const Triangle& triangle, const Visit& visit)
{
    for (const SampleSheet& sheet : tile.samples().sheets())
    {
        const GridRect inside = sheet.inside();
        if (inside.cutTo(triangle.extent()).isEmpty()) continue;
        const int step = sheet.step();
        triangle.forEachRow(
            inside.east + 1, inside.north + 1,
            [&](int row, int west, int east)
            {
                if (row < inside.south) return;
                for (int column = std::max(west, inside.west); column <= east; column += step)
                    if (tile.samples().isGround(column, row)) visit(GridPoint{column, row});
            },
            step);
    }
}

/// Does the same for every sample of the data: the raster's, the sheets', then those between. Some may be
/// visited twice.
template<class Triangle, class Visit>
void forEachSampleIn(const PlacedTile& tile, const Triangle& triangle, const Visit& visit)
{
    const int step = tile.grid().cellSide();
    triangle.forEachRow(
        tile.grid().dataColumns(), tile.grid().dataRows(),
        [&](int row, int west, int east)
        {
            for (int column = west; column <= east; column += step)
                if (tile.samples().isGround(column, row)) visit(GridPoint{column, row});
        },
        step);
    forEachSheetSampleIn(tile, triangle, visit);
    if (tile.samples().fineSamples().isEmpty()) return;
    tile.samples().fineSamples().forEachIn(triangle.extent(),
                                           [&](int column, int row)
                                           {
                                               if (triangle.holds({column, row}))
                                                   visit(GridPoint{column, row});
                                           });
}

} // namespace osgTerrainROAM::core
