// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "FrameTransform.h"
#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// One of the rasters that a terrain is joined from.
struct MosaicSource
{
    std::string name;      ///< for messages
    Raster raster;         ///< has a frame
    double spacingM = 0.0; ///< northwards on the ground, in its middle

    GridReference reference() const { return {*raster.frame, raster.crsWkt}; }
};

/// Gives a raster whose coordinates look like degrees WGS84 as its reference system (CellSizeReference.h).
void settleReference(Raster& raster);

/// Errors: the raster has no georeference.
foundation::Outcome checkPlaced(const std::filesystem::path& file, const Raster& raster);

/// Reads all sources. Errors: those of readRaster; no georeference; different vertical datums.
foundation::Result<std::vector<MosaicSource>> readSources(std::span<const std::filesystem::path> files,
                                                          const DemImportOptions& options, GdalSession& gdal);

} // namespace osgTerrainROAM::core
