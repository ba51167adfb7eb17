// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osg/Image>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include <osgTerrainROAM/ImageryLayer>

namespace osgTerrainROAM
{

/// Resamples an image that GDAL opens bilinearly onto the tile's data grid (one band: grey; three: RGB; four:
/// with coverage; a palette). Texels per sample are chosen so that the image keeps its resolution, up to 8192
/// texels a side. Alpha is the coverage of the terrain. Both rasters need a georeference; an image without
/// one is stretched over the data.
/// Errors: missing file, unreadable, no georeference on the terrain's side, nothing in common.
foundation::Result<osg::ref_ptr<osg::Image>> imageryDrape(const std::filesystem::path& file,
                                                          const core::PlacedTile& tile);

/// The same for the part of the tile alone that the image covers, so that a small image keeps a fine
/// resolution.
foundation::Result<ImageryLayer> imageryLayer(const std::filesystem::path& file,
                                              const core::PlacedTile& tile);

} // namespace osgTerrainROAM
