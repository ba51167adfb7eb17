// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

#include "GdalSession.h"

namespace osgTerrainROAM::core
{

/// The locations of a raster's samples in its own coordinate reference system. A sample is the centre of
/// GDAL's pixel, for area and point rasters alike (GDAL itself shifts the latter by half a pixel).
struct GridFrame
{
    double firstX, firstY; ///< of the south-western sample
    double stepX, stepY;   ///< from one sample to the next, eastwards and northwards, both positive
};

/// The samples of an elevation raster as read: row 0 the southernmost, column 0 the westernmost, voids NaN.
struct Raster
{
    int columns = 0;
    int rows = 0;
    std::vector<float> heightsM;
    std::size_t implausible = 0;         ///< samples taken for voids: no point on Earth is so high or deep
    std::optional<GridFrame> frame;      ///< absent: no georeference
    std::string crsWkt;                  ///< empty: none given
    std::vector<std::uint8_t> isOutside; ///< 1 at points that no raster reaches (DemMosaic); empty: none
    std::vector<DensePart> parts;        ///< of a mosaic
};

/// Opens and reads a single-band raster through GDAL, inside zip and gzip archives too.
/// Errors: missing, a folder, not a raster GDAL knows, damaged, truncated, not one band of plain numbers,
/// rotated, fewer than 2×2 or more than 32769×32769 samples.
foundation::Result<Raster> readRaster(const std::filesystem::path& file, GdalSession& gdal);

/// The same without the samples, whose errors are not found.
foundation::Result<Raster> readHead(const std::filesystem::path& file, GdalSession& gdal);

} // namespace osgTerrainROAM::core
