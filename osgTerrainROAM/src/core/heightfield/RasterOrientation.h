// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>
#include <gdal.h>

#include "GdalSession.h"
#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// How samples in file order have to be turned so that rows run north and columns east.
struct RasterTurn
{
    bool flipsRows = false, flipsColumns = false;
};

/// Reads the georeference of a dataset into raster.frame, without touching samples. `raster`: columns and
/// rows are known.
/// Errors: a rotated grid, one placed by control points, an invalid georeference.
foundation::Result<RasterTurn> readOrientation(const std::string& name, GDALDatasetH dataset, Raster& raster);

/// Reads the georeference of a dataset and reorders the samples from file order so that rows run north and
/// columns east. An image without georeference begins at the top.
/// Errors: a rotated grid, an invalid georeference.
foundation::Outcome orientRaster(const std::string& name, GDALDatasetH dataset, Raster& raster);

/// Tells of a GeoTIFF whose rows run from south to north: few do, and some of these by a mistake of their
/// writer.
void noteSouthUp(GDALDatasetH dataset, GdalSession& gdal);

} // namespace osgTerrainROAM::core
