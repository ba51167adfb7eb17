// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>

#include <foundation/Result.h>
#include <gdal.h>

#include "GdalSession.h"

namespace osgTerrainROAM::core
{

struct RasterCloser
{
    void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
using RasterDataset = std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, RasterCloser>;

/// An open raster: GDAL's handles, and its path for GDAL.
struct RasterSource
{
    std::string name; ///< for messages
    std::string gdalPath;
    RasterDataset dataset;

    GDALRasterBandH band() const { return GDALGetRasterBand(dataset.get(), 1); }
};

/// Opens a raster, inside zip and gzip archives too. Errors: missing, a folder, not a raster GDAL knows.
foundation::Result<RasterSource> openSource(const std::filesystem::path& file, GdalSession& gdal);

/// Tells a raster of heights from others. Errors: not one band of plain numbers, too few or too many samples,
/// truncated.
foundation::Outcome checkShape(const RasterSource& source);

bool isDriver(const RasterSource& source, const char* name);

/// The coordinate reference system as text; empty: none.
std::string crsWktOf(const RasterSource& source);

} // namespace osgTerrainROAM::core
