// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/edit/Earthworks.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>

namespace osgTerrainROAM::core
{

/// Earthworks of a vector source.
struct EarthworkSet
{
    std::vector<Earthwork> works;
    std::vector<std::string> notes{}; ///< what GDAL warned of, one line each
};

/// Reads earthworks of a vector source that GDAL's OGR opens: lines and polygons whose points have a third
/// coordinate, the height in the datum of the tile's samples. Attributes: width, crossfall, strip,
/// strip_fall, slope, rise (those of Earthwork).
/// Errors: as importFeatures(); a shape without heights.
/// Frame: the tile's.
foundation::Result<EarthworkSet> importEarthworks(const std::filesystem::path& source,
                                                  const PlacedTile& tile);

/// Cuts and fills the ground of a tile to earthworks: first samples of the raster within areas, then every
/// grid point near edges and lines. The steps cannot be undone. What GDAL warns of becomes notes of the tile.
/// Errors: those of importEarthworks(), changesBy() and TileEditor::apply().
foundation::Result<EditReport> shapeGround(std::span<const std::filesystem::path> sources,
                                           const std::shared_ptr<RoamTile>& tile);

/// The same by earthworks in the tile's frame.
foundation::Result<EditReport> shapeGround(const std::vector<Earthwork>& works,
                                           const std::shared_ptr<RoamTile>& tile);

} // namespace osgTerrainROAM::core
