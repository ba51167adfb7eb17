// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace measurement
{

/// A square of a raster that terrain engines are compared on, with square cells.
struct RasterCrop
{
    const char* file; ///< relative to the folder of the real data
    int firstColumn, firstRowFromNorth, side;
    double cellM;

    bool isPartOf(const osgTerrainROAM::core::HeightField& all) const
    {
        return firstColumn >= 0 && firstRowFromNorth >= 0 && firstColumn + side <= all.columns &&
               firstRowFromNorth + side <= all.rows;
    }

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

/// Returns the side of the cells of such a square: cells of whole seconds of arc count as squares of 30 m a
/// second, as in all figures on these terrains.
inline double nominalCellM(double spacingM)
{
    const double seconds = std::round(spacingM / 30.0);
    return seconds >= 1.0 && std::abs(spacingM - 30.0 * seconds) < 0.04 * spacingM ? 30.0 * seconds
                                                                                   : spacingM;
}

/// Returns the square that `crop` names (side, then the first column and row from the north), in the middle
/// where that tells no place, the largest of 2^n+1 samples where it is empty. It may not lie within the
/// raster.
inline RasterCrop rasterCrop(const osgTerrainROAM::core::HeightField& all, const std::vector<int>& crop)
{
    int cells = 2;
    while (2 * cells < std::min(all.columns, all.rows))
        cells *= 2;
    const int side = crop.empty() ? cells + 1 : crop[0];
    const bool hasPlace = crop.size() == 3;
    return {"", hasPlace ? crop[1] : (all.columns - side) / 2, hasPlace ? crop[2] : (all.rows - side) / 2,
            side, nominalCellM(all.spacingNorthM)};
}

inline constexpr RasterCrop kWhiteMountains{"dem/N44W072.hgt", 88, 88, 1025, 90.0};
inline constexpr RasterCrop kAconcagua{"dem/S33W071.tif", 88, 88, 1025, 90.0};
inline constexpr RasterCrop kGreenRiver{"dem/greenriver.tif", 700, 300, 513, 1.0}; ///< lidar

} // namespace measurement
