// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/blocks/BlockRim.h>

namespace osgTerrainROAM::core
{

GridRect rectOf(const TileGrid& tile, const BlockGrid& grid, std::uint32_t block)
{
    const GridPoint origin = grid.origin(block);
    return GridRect{origin.column, origin.row, origin.column + grid.side(), origin.row + grid.side()}.cutTo(
        tile.dataRect());
}

BlockRim::BlockRim(const TileGrid& tile, const BlockGrid& grid, std::uint32_t block)
    : _rect(rectOf(tile, grid, block))
{
    for (int side = 0; side < kSides; ++side)
        _hasNeighbour[static_cast<std::size_t>(side)] = grid.neighbour(block, side) != kNone;
}

bool BlockRim::isOn(GridPoint p, int side) const
{
    switch (side)
    {
    case south:
        return p.row == _rect.south;
    case east:
        return p.column == _rect.east;
    case north:
        return p.row == _rect.north;
    default:
        return p.column == _rect.west;
    }
}

GridPoint BlockRim::outer(GridPoint border) const
{
    const auto beyond = [&](int side)
    { return _hasNeighbour[static_cast<std::size_t>(side)] && isOn(border, side) ? 1 : 0; };
    return {border.column + beyond(east) - beyond(west), border.row + beyond(north) - beyond(south)};
}

std::vector<GridPoint> BlockRim::outerPlaces() const
{
    std::vector<GridPoint> places;
    for (int column = _rect.west; column < _rect.east; ++column)
        places.push_back(outer({column, _rect.south}));
    for (int row = _rect.south; row < _rect.north; ++row)
        places.push_back(outer({_rect.east, row}));
    for (int column = _rect.east; column > _rect.west; --column)
        places.push_back(outer({column, _rect.north}));
    for (int row = _rect.north; row > _rect.south; --row)
        places.push_back(outer({_rect.west, row}));
    return places;
}

std::uint32_t BlockRim::outerOf(GridPoint border) const
{
    const int columns = _rect.east - _rect.west, rows = _rect.north - _rect.south;
    int number = 2 * columns + rows + _rect.north - border.row;
    if (border.row == _rect.south)
        number = border.column - _rect.west;
    else if (border.column == _rect.east)
        number = columns + border.row - _rect.south;
    else if (border.row == _rect.north)
        number = columns + rows + _rect.east - border.column;
    return static_cast<std::uint32_t>(number);
}

bool BlockRim::isBeyond(GridPoint a, GridPoint b) const
{
    for (int side = 0; side < kSides; ++side)
        if (_hasNeighbour[static_cast<std::size_t>(side)] && isOn(a, side) && isOn(b, side)) return true;
    return false;
}

} // namespace osgTerrainROAM::core
