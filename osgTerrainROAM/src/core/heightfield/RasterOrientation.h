// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>
#include <gdal.h>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Takes the georeference of a dataset, and turns the samples, which are in file order, so that rows run
/// north and columns east. A picture without georeference begins at the top.
/// Errors: a rotated grid, a georeference that is none.
foundation::Outcome orientRaster(const std::string& name, GDALDatasetH dataset, Raster& raster);

} // namespace osgTerrainROAM::core
