// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <osgTerrainROAM/core/heightfield/TileGrid.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The sides of a block, counter-clockwise.
enum Side
{
    south,
    east,
    north,
    west
};
inline constexpr int kSides = 4;

/// The division of a tile's grid into square blocks of M × M cells, M = 2^exponent. Neighbouring blocks share
/// the points of their border. Only blocks with data exist; those at the north and east edge may reach beyond
/// it.
/// Threads: immutable.
class BlockGrid
{
public:
    /// 32 × 32 cells of the raster, or the whole tile where that is smaller.
    static constexpr int kDefaultExponent = 5;

    explicit BlockGrid(const TileGrid& grid, int cellExponent = kDefaultExponent)
        : _exponent(std::min(cellExponent + grid.exponent(), grid.levels() / 2)),
          _columns((grid.dataColumns() - 2) / side() + 1),
          _rows((grid.dataRows() - 2) / side() + 1)
    {
    }

    int exponent() const { return _exponent; }
    int side() const { return 1 << _exponent; } ///< M, cells
    int columns() const { return _columns; }
    int rows() const { return _rows; }
    std::uint32_t count() const
    {
        return static_cast<std::uint32_t>(_columns) * static_cast<std::uint32_t>(_rows);
    }

    /// The south-western corner of a block.
    GridPoint origin(std::uint32_t block) const
    {
        const int index = static_cast<int>(block);
        return {index % _columns * side(), index / _columns * side()};
    }
    std::uint32_t blockAt(int column, int row) const
    {
        return static_cast<std::uint32_t>(row * _columns + column);
    }

    /// The block beyond a side; kNone at the edge of the data.
    std::uint32_t neighbour(std::uint32_t block, int side) const
    {
        const int column = static_cast<int>(block) % _columns, row = static_cast<int>(block) / _columns;
        switch (side)
        {
        case south:
            return row > 0 ? block - static_cast<std::uint32_t>(_columns) : kNone;
        case east:
            return column + 1 < _columns ? block + 1 : kNone;
        case north:
            return row + 1 < _rows ? block + static_cast<std::uint32_t>(_columns) : kNone;
        default:
            return column > 0 ? block - 1 : kNone;
        }
    }

private:
    int _exponent, _columns, _rows;
};

} // namespace osgTerrainROAM::core
