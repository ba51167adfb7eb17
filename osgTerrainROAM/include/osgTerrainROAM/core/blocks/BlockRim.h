// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/blocks/BlockGrid.h>
#include <osgTerrainROAM/core/heightfield/GridRect.h>

namespace osgTerrainROAM::core
{

/// The part of the data that a block covers, its border included.
GridRect rectOf(const TileGrid& tile, const BlockGrid& grid, std::uint32_t block);

/// The rim of a block: a strip of one cell around it, over the blocks beside it. It begins at the block's
/// border as it is drawn, and its outer edge hangs lower than anything that those blocks can draw. So the
/// surface that is uppermost at each place is continuous across the border, whatever the levels on both sides
/// are, and the rim is never above its block's border. There is none at the edge of the data. Frame: the
/// grid.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 4.2 (overlapping
/// blocks: the border of each lies under its neighbour).
class BlockRim
{
public:
    BlockRim(const TileGrid& tile, const BlockGrid& grid, std::uint32_t block);

    /// The places of the outer edge: one for each sample of the border, counter-clockwise from the
    /// south-western corner. Beyond a corner between two neighbours it is that on the diagonal. At the edge
    /// of the data it is the sample itself, and not used.
    std::vector<GridPoint> outerPlaces() const;

    /// The number of the outer place beyond a sample of the border.
    std::uint32_t outerOf(GridPoint border) const;

    /// Whether an edge of the block has a part of the rim beyond it. Precondition: both ends are points of
    /// the block.
    bool isBeyond(GridPoint a, GridPoint b) const;

    /// The two triangles beyond an edge a, b of the block's border, which has the block to its left. Corners
    /// 0 and 1 are a and b, 2 and 3 the outer places beyond them. The dividing diagonal goes up from the
    /// lower end, so that no point of them is above the edge.
    static std::array<std::array<std::uint8_t, 3>, 2> trianglesBeyond(double heightA, double heightB)
    {
        if (heightA <= heightB) return {{{0, 2, 3}, {0, 3, 1}}};
        return {{{0, 2, 1}, {1, 2, 3}}};
    }

private:
    bool isOn(GridPoint p, int side) const;
    GridPoint outer(GridPoint border) const;

    GridRect _rect;
    std::array<bool, kSides> _hasNeighbour{};
};

} // namespace osgTerrainROAM::core
