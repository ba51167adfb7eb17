// SPDX-License-Identifier: Apache-2.0
#include "RasterOrientation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;

constexpr double kRotationSlack = 1e-6; ///< of a pixel per pixel: a grid this straight is not rotated

void flipRows(Raster& raster)
{
    const auto columns = static_cast<std::ptrdiff_t>(raster.columns);
    for (int low = 0, high = raster.rows - 1; low < high; ++low, --high)
        std::swap_ranges(raster.heightsM.begin() + low * columns,
                         raster.heightsM.begin() + (low + 1) * columns,
                         raster.heightsM.begin() + high * columns);
}

void flipColumns(Raster& raster)
{
    const auto columns = static_cast<std::ptrdiff_t>(raster.columns);
    for (int r = 0; r < raster.rows; ++r)
        std::reverse(raster.heightsM.begin() + r * columns, raster.heightsM.begin() + (r + 1) * columns);
}

} // namespace

foundation::Result<RasterTurn> readOrientation(const std::string& name, GDALDatasetH dataset, Raster& raster)
{
    double t[6];
    if (GDALGetGeoTransform(dataset, t) != CE_None)
    {
        if (GDALGetGCPCount(dataset) > 0)
            return Error{name, "is placed by control points, not as a grid", "straighten it with gdalwarp"};
        return RasterTurn{true, false}; // images begin at the top
    }
    const double size = std::max({std::abs(t[1]), std::abs(t[2]), std::abs(t[4]), std::abs(t[5])});
    if (!std::isfinite(size) || !std::isfinite(t[0]) || !std::isfinite(t[3]))
        return Error{name, "has a georeference that is no number", "assign one with gdal_translate -a_ullr"};
    if (std::max(std::abs(t[2]), std::abs(t[4])) > kRotationSlack * size)
        return Error{name, "is a rotated grid", "straighten it with gdalwarp"};
    if (t[1] == 0.0 || t[5] == 0.0)
        return Error{name, "has pixels of no size", "assign a georeference with gdal_translate -a_ullr"};

    raster.frame = GridFrame{t[0] + 0.5 * t[1], t[3] + 0.5 * t[5], t[1], t[5]};
    GridFrame& frame = *raster.frame;
    const RasterTurn turn{frame.stepY < 0.0, frame.stepX < 0.0};
    if (turn.flipsColumns)
    {
        frame.firstX += frame.stepX * (raster.columns - 1);
        frame.stepX = -frame.stepX;
    }
    if (turn.flipsRows)
    {
        frame.firstY += frame.stepY * (raster.rows - 1);
        frame.stepY = -frame.stepY;
    }
    return turn;
}

Outcome orientRaster(const std::string& name, GDALDatasetH dataset, Raster& raster)
{
    const auto turn = readOrientation(name, dataset, raster);
    if (!turn) return turn.error();
    if (turn->flipsColumns) flipColumns(raster);
    if (turn->flipsRows) flipRows(raster);
    return foundation::success();
}

void noteSouthUp(GDALDatasetH dataset, GdalSession& gdal)
{
    double t[6];
    const bool isGeoTiff = std::string_view(GDALGetDriverShortName(GDALGetDatasetDriver(dataset))) == "GTiff";
    if (isGeoTiff && GDALGetGeoTransform(dataset, t) == CE_None && t[5] > 0.0)
        gdal.note("its rows run from south to north, as its georeference says");
}

} // namespace osgTerrainROAM::core
