// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgTerrainROAM/core/heightfield/GridRect.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/SampleTable.h>

namespace osgTerrainROAM::core
{

/// A rectangle of a tile where samples lie closer together than those of its raster (DensePart), on the tile's grid. Held are those
/// inside; along the border the surface is that of what lies below, so that both sides have the same.
/// Units: grid places; metres.
class SampleSheet
{
public:
    /// `gridExponent`: the grid has 2^gridExponent places to a cell of the field.
    SampleSheet(const DensePart& part, int gridExponent, Storage storage);

    const GridRect& rect() const { return _rect; } ///< borders included
    int step() const { return 1 << _shift; }
    GridRect inside() const
    {
        return {_rect.west + step(), _rect.south + step(), _rect.east - step(), _rect.north - step()};
    }

    /// Whether a sample of it lies at a place.
    bool holds(int column, int row) const
    {
        return ((column | row) & (step() - 1)) == 0 && column > _rect.west && row > _rect.south &&
               column < _rect.east && row < _rect.north;
    }

    /// Of a sample that it holds, in table().
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>((row - _rect.south) >> _shift) * static_cast<std::size_t>(_columns) +
               static_cast<std::size_t>((column - _rect.west) >> _shift);
    }

    const SampleTable& table() const { return _table; }
    SampleTable& table() { return _table; }

private:
    GridRect _rect;
    int _shift;
    int _columns;
    SampleTable _table;
};

} // namespace osgTerrainROAM::core
