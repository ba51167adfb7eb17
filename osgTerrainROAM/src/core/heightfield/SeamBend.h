// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgTerrainROAM/core/heightfield/GridRect.h>

namespace osgTerrainROAM::core
{

/// Heights over a part of a grid, row-major, NaN where there are none.
struct HeightSheet
{
    GridRect rect; ///< of the grid
    std::vector<float> heightsM;

    int columns() const { return rect.east - rect.west + 1; }
    int rows() const { return rect.north - rect.south + 1; }
    bool holds(int column, int row) const { return rect.holds(column, row); }
    float& at(int column, int row) { return heightsM[index(column, row)]; }
    float at(int column, int row) const { return heightsM[index(column, row)]; }

private:
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row - rect.south) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(column - rect.west);
    }
};

/// The report of reconciling.
struct SeamReport
{
    std::size_t bent = 0;  ///< points of the coarser data that were moved
    double largestM = 0.0; ///< largest disagreement of the data along the seams
};

/// Bends `ground` within `reach` grid steps of the outline of `sheet`, which will lie over it, so that both
/// have the same height there. The difference on the outline fades out as the spline in tension that also
/// fills voids: smoothly and within its own range. The sheet stays as measured. Where `ground` ends at the
/// outline, it is extrapolated linearly.
SeamReport bendTowards(HeightSheet& ground, const HeightSheet& sheet, int reach);

} // namespace osgTerrainROAM::core
