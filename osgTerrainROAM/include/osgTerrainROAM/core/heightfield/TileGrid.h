// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgTerrainROAM/core/heightfield/GridRect.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace osgTerrainROAM::core
{

/// The grid of a tile is a square of 2^N+1 by 2^N+1 points: the vertices that its bintree can have. Points
/// have integer coordinates: column 0 is the westernmost, row 0 the southernmost. The data fill the
/// south-western part. The raster's samples lie on every point, or (exponent) on every 2^exponent-th column
/// and row: edits and dense parts put samples between them.
/// Threads: immutable.
class TileGrid
{
public:
    static constexpr int kMostSide = (1 << 20) + 1; ///< points along a side
    static constexpr int kMostLevels = 2 * 20;      ///< of the bintree

    /// A grid with 2^exponent points from one sample of the field to the next.
    TileGrid(const HeightField& field, int exponent);

    int side() const { return _side; }     ///< points along a side, 2^N+1
    int levels() const { return _levels; } ///< 2N: bintree levels below the two roots that can split
    int dataColumns() const { return _dataColumns; }
    int dataRows() const { return _dataRows; }
    int exponent() const { return _exponent; }
    int cellSide() const { return 1 << _exponent; } ///< points from one sample of the raster to the next
    GridRect dataRect() const { return {0, 0, _dataColumns - 1, _dataRows - 1}; }

    bool isInData(int column, int row) const { return column < _dataColumns && row < _dataRows; }

    /// Tells whether a sample of the raster lies at a point.
    bool isOfRaster(int column, int row) const { return ((column | row) & _betweenSamples) == 0; }

    /// Index of a raster sample that lies at a point of the data: row-major, the southernmost row first.
    std::size_t rasterIndex(int column, int row) const
    {
        return static_cast<std::size_t>(row >> _exponent) * _samplesPerRow +
               static_cast<std::size_t>(column >> _exponent);
    }

private:
    int _exponent;
    int _betweenSamples; ///< bits that are 0 in the coordinates of raster samples
    int _side, _levels;
    int _dataColumns, _dataRows;
    std::size_t _samplesPerRow;
};

} // namespace osgTerrainROAM::core
