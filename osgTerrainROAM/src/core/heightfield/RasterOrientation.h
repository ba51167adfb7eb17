// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>
#include <gdal.h>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Reads the georeference of a dataset and reorders the samples from file order so that rows run north and columns east. An image
/// without georeference begins at the top.
/// Errors: a rotated grid, an invalid georeference.
foundation::Outcome orientRaster(const std::string& name, GDALDatasetH dataset, Raster& raster);

} // namespace osgTerrainROAM::core
