// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gdal.h>

#include <viewlod/Result.h>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Takes the georeference of a dataset, and turns the samples, which are in file order, so that rows run
/// north and columns east. A picture without georeference begins at the top.
/// Errors: a rotated grid, a georeference that is none.
viewlod::Outcome orientRaster(const std::string& name, GDALDatasetH dataset, Raster& raster);

} // namespace osgTerrainROAM::core
