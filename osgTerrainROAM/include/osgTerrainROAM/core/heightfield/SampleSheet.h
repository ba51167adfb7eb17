// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgTerrainROAM/core/heightfield/GridRect.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/SampleTable.h>

namespace osgTerrainROAM::core
{

/// A sheet is a rectangle of a tile with denser samples than its raster (a DensePart on the tile's grid). It
/// holds the samples inside its border; on the border its surface is the surface below it, so that both sides
/// agree.
/// Units: grid points; metres.
class SampleSheet
{
public:
    /// `gridExponent`: the grid has 2^gridExponent points along a cell of the field.
    SampleSheet(const DensePart& part, int gridExponent, Storage storage);

    const GridRect& rect() const { return _rect; } ///< borders included
    int step() const { return 1 << _shift; }       ///< grid points from one sample to the next
    GridRect inside() const
    {
        return {_rect.west + step(), _rect.south + step(), _rect.east - step(), _rect.north - step()};
    }

    /// Tells whether it holds a sample at a point.
    bool holds(int column, int row) const
    {
        return ((column | row) & (step() - 1)) == 0 && column > _rect.west && row > _rect.south &&
               column < _rect.east && row < _rect.north;
    }

    /// Index in table() of a sample that it holds.
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
