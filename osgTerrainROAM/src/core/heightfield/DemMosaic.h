// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Reads several rasters and joins them on the grid of the finest of them, continued over all; where that would get too large, on
/// a coarser one, with denser parts around the finer rasters (MosaicPlan). Its samples, and those of others
/// on the same grid, stay as they are; coarser ones, and those in other coordinates, are interpolated (RasterSampler). Where
/// rasters overlap the finest counts, among equals the one named first; the others are bent towards it (SeamBend). Between
/// rasters whose pixels meet nothing is missing: voids to be filled; what no raster reaches is marked in Raster::isOutside.
/// Errors: as readRaster; a raster without georeference, on a plane among those on the Earth, with heights counted from
/// something else, or a grid that gets too large.
foundation::Result<Raster> readMosaic(std::span<const std::filesystem::path> files,
                                      const DemImportOptions& options, GdalSession& gdal,
                                      MosaicReport& report);

} // namespace osgTerrainROAM::core
