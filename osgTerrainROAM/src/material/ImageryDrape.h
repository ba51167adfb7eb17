// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osg/Image>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include <osgTerrainROAM/ImageryLayer>

namespace osgTerrainROAM
{

/// Any raster GDAL opens (one band: grey; three: RGB; four: with coverage; a palette), resampled bilinearly onto the
/// tile's data grid, texel for sample times a factor that keeps the imagery's own resolution up to 8192 texels a side.
/// Alpha tells where the imagery covers the terrain. Both rasters need a georeference; an imagery without one is
/// stretched over the data.
/// Errors: missing file, unreadable, no georeference on the terrain's side, nothing in common.
foundation::Result<osg::ref_ptr<osg::Image>> imageryDrape(const std::filesystem::path& file,
                                                          const core::PlacedTile& tile);

/// The same over no more of the tile than the imagery reaches, so that a small one keeps a fine resolution.
foundation::Result<ImageryLayer> imageryLayer(const std::filesystem::path& file,
                                              const core::PlacedTile& tile);

} // namespace osgTerrainROAM
