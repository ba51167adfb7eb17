// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/blocks/BlockGrid.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// The blocks that hold points of rectangles, their borders included.
inline std::vector<std::uint32_t> blocksOf(const BlockGrid& grid, std::span<const GridRect> rects)
{
    std::vector<std::uint32_t> blocks;
    for (std::uint32_t block = 0; block < grid.count(); ++block)
    {
        const GridPoint origin = grid.origin(block);
        const GridRect around{origin.column, origin.row, origin.column + grid.side(),
                              origin.row + grid.side()};
        if (std::any_of(rects.begin(), rects.end(),
                        [&](const GridRect& r) { return !r.cutTo(around).isEmpty(); }))
            blocks.push_back(block);
    }
    return blocks;
}

/// The rectangles in which points of a tile have moved since a revision.
inline std::vector<GridRect> movedSince(const RoamTile& tile, std::uint64_t revision)
{
    std::vector<GridRect> rects;
    const auto changes = tile.changesSince(revision);
    if (!changes) rects.push_back({0, 0, tile.tile.grid().side() - 1, tile.tile.grid().side() - 1});
    for (const TileChange* change : changes.value_or(std::vector<const TileChange*>()))
        rects.insert(rects.end(), change->moved.begin(), change->moved.end());
    return rects;
}

} // namespace osgTerrainROAM::core
