// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Reads several rasters and joins them on the grid of the finest, extended over all; where that would be too
/// large, on a coarser grid with dense parts around the finer rasters (MosaicPlan). Samples on that grid stay
/// as they are; coarser ones, and those in other coordinates, are interpolated (RasterSampler). Where rasters
/// overlap the finest counts, among equals the one named first; the others are bent towards it (SeamBend).
/// Gaps between rasters whose pixels meet are voids to be filled; points that no raster reaches are marked in
/// Raster::isOutside.
/// Errors: those of readRaster; a raster without georeference; a planar raster among georeferenced ones;
/// different vertical datums; a grid that is too large.
foundation::Result<Raster> readMosaic(std::span<const std::filesystem::path> files,
                                      const DemImportOptions& options, GdalSession& gdal,
                                      MosaicReport& report);

} // namespace osgTerrainROAM::core
