// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace measurement
{

/// A square of a raster that terrain engines are compared on, with square cells.
struct RasterCrop
{
    const char* file; ///< relative to the folder of the real data
    int firstColumn, firstRowFromNorth, side;
    double cellM;

    osgTerrainROAM::core::HeightField of(const osgTerrainROAM::core::HeightField& all) const
    {
        osgTerrainROAM::core::HeightField field;
        field.name = all.name;
        field.columns = field.rows = side;
        field.spacingEastM = field.spacingNorthM = cellM;
        const int south = all.rows - firstRowFromNorth - side;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                field.heightsM.push_back(all.heightM(firstColumn + column, south + row));
        return field;
    }
};

inline constexpr RasterCrop kWhiteMountains{"dem/N44W072.hgt", 88, 88, 1025, 90.0};
inline constexpr RasterCrop kAconcagua{"dem/S33W071.tif", 88, 88, 1025, 90.0};
inline constexpr RasterCrop kGreenRiver{"dem/greenriver.tif", 700, 300, 513, 1.0}; ///< lidar

} // namespace measurement
