// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/blocks/BlockErrors.h>

#include "../RoundedUp.h"
#include "BlocksOfRects.h"
#include "SurfaceError.h"

namespace osgTerrainROAM::core
{

namespace
{

PlanTriangle inGrid(const BlockTriangle& t, GridPoint origin)
{
    const auto at = [&](GridPoint p) { return GridPoint{origin.column + p.column, origin.row + p.row}; };
    return {{at(t[0]), at(t[1]), at(t[2])}};
}

/// A side of a block whose vertices that the next level lacks are drawn in the middle between their
/// neighbours.
struct MorphedSide
{
    GridPoint origin;
    int last;
    int side = -1; ///< -1: none
    int level = 0;

    /// Where a point of the block is drawn.
    template<class PositionAt>
    glm::dvec3 drawn(GridPoint local, const PositionAt& position) const
    {
        const GridPoint p{origin.column + local.column, origin.row + local.row};
        const bool isRow = side == south || side == north;
        const int along = isRow ? local.column : local.row, across = isRow ? local.row : local.column;
        const int line = side == east || side == north ? last : 0;
        if (side < 0 || across != line || (along >> level) % 2 == 0) return position(p);
        const int columns = isRow ? 1 << level : 0, rows = isRow ? 0 : 1 << level;
        return (position({p.column - columns, p.row - rows}) + position({p.column + columns, p.row + rows})) *
               0.5;
    }
};

} // namespace

BlockBox boundBlock(const PlacedTile& tile, const BlockGrid& grid, std::uint32_t block)
{
    BlockBox box;
    const GridPoint origin = grid.origin(block);
    for (int row = origin.row; row <= origin.row + grid.side(); ++row)
        for (int column = origin.column; column <= origin.column + grid.side(); ++column)
            box.include(tile.position(column, row));
    return box;
}

BlockErrors::BlockErrors(std::shared_ptr<const RoamTile> tile, const BlockGrid& grid)
    : _tile(std::move(tile)), _grid(grid), _levels(grid.exponent() + 1), _revision(_tile->revision())
{
    const std::size_t count = grid.count(), levels = static_cast<std::size_t>(_levels);
    _blocksM.resize(count * levels);
    _morphedM.resize(count * levels);
    _stripsM.resize(count * levels * kSides * levels);
    _boxes.resize(count);
    for (std::uint32_t block = 0; block < grid.count(); ++block)
        measure(block);
}

void BlockErrors::measure(std::uint32_t block)
{
    const int exponent = _grid.exponent();
    const GridPoint origin = _grid.origin(block);
    const PlacedTile& tile = _tile->tile;
    _boxes[block] = boundBlock(tile, _grid, block);
    const SurfaceError surface(
        tile, {origin.column, origin.row, origin.column + _grid.side(), origin.row + _grid.side()});
    const auto position = [&](GridPoint p) { return tile.position(p.column, p.row); };
    // `morphed`: of a side, where it is drawn as a border that has reached the next level.
    const auto errorM = [&](const std::vector<BlockTriangle>& triangles, const MorphedSide& morphed)
    {
        double largestM = 0.0;
        for (const BlockTriangle& t : triangles)
            largestM =
                std::max(largestM, surface.largestM(inGrid(t, origin), {morphed.drawn(t[0], position),
                                                                        morphed.drawn(t[1], position),
                                                                        morphed.drawn(t[2], position)}));
        return largestM;
    };
    double nestedM = 0.0, nestedMorphedM = 0.0;
    for (int level = 0; level < _levels; ++level)
    {
        const double roundingM = level == 0 ? 0.0 : tile.frame().vertexStepM();
        const MorphedSide none{origin, _grid.side()};
        const double insideM = errorM(innerTriangles(exponent, level, origin), none);
        nestedM = std::max(nestedM, insideM + roundingM);
        double morphedM = insideM;
        for (int side = 0; side < kSides && level < exponent; ++side)
            for (int border = level; border <= exponent; ++border)
            {
                const auto strip = borderTriangles(exponent, level, side, border);
                const double stripM = errorM(strip, none);
                if (border == level) nestedM = std::max(nestedM, stripM + roundingM);
                if (border <= level + 1) morphedM = std::max(morphedM, stripM);
                if (border == level + 1 && border < exponent)
                    morphedM = std::max(morphedM, errorM(strip, {origin, _grid.side(), side, border}));
                _stripsM[stripIndex(block, level, side, border)] = roundedUp(stripM + roundingM);
            }
        nestedMorphedM = std::max(nestedMorphedM, morphedM + tile.frame().vertexStepM());
        _blocksM[index(block, level)] = roundedUp(nestedM);
        _morphedM[index(block, level)] = roundedUp(nestedMorphedM);
    }
}

void BlockErrors::remeasure(std::span<const GridRect> rects)
{
    _revision = _tile->revision();
    for (const std::uint32_t block : blocksOf(_grid, rects))
        measure(block);
}

std::size_t BlockErrors::memoryBytes() const
{
    return (_blocksM.capacity() + _stripsM.capacity() + _morphedM.capacity()) * sizeof(float) +
           _boxes.capacity() * sizeof(BlockBox);
}

} // namespace osgTerrainROAM::core
