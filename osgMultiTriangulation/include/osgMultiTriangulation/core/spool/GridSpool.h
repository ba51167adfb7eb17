// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>

namespace osgMultiTriangulation::core
{

/// Turns a grid of heights into a surface row by row: the points and triangles of gridSurface(), in its
/// order. Samples that are not numbers are holes; of a cell that lacks one corner the other three are a
/// triangle.
/// Memory: 60 B a column.
class GridSpool
{
public:
    GridSpool(SurfaceSpool& spool, int columns, const CellCut& cut = {});

    /// Adds a row of heights, metres; the southernmost first.
    void addRow(std::span<const float> heights);

    /// After the last row.
    void finish();

    std::uint64_t holes() const { return _holes; } ///< samples that were no numbers

private:
    struct Corner
    {
        int column;
        bool isUpper; ///< of the row above
    };
    using Cell = std::array<Corner, 3>;

    void cutCells(std::span<const float> upper);
    void numberRow();

    SurfaceSpool& _spool;
    CellCut _cut;
    int _columns, _row = 0;      ///< of the last row that was added, from 1 on
    std::vector<float> _heights; ///< of that row
    std::vector<bool> _isUsed, _isUsedAbove;
    std::vector<std::uint32_t> _numbersBelow, _numbers;
    std::vector<Cell> _waiting, _cells; ///< triangles below that row; below the one that is coming
    std::uint32_t _points = 0;
    std::uint64_t _holes = 0;
};

} // namespace osgMultiTriangulation::core
