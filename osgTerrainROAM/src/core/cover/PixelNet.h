// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

class GDALDataset;

namespace osgTerrainROAM::core
{

/// The pixel coordinates of a raster at the nodes of a tile's geodetic net, interpolated between them. A
/// raster without georeference is stretched over the tile. Pixel coordinates are GDAL's: from the upper left
/// corner, centres at halves.
class PixelNet
{
public:
    /// Errors: the raster has a georeference and the tile has none; coordinate systems that cannot be
    /// related.
    static foundation::Result<PixelNet> make(GDALDataset& dataset, const PlacedTile& tile,
                                             const std::string& name);

    glm::dvec2 pixelAt(double column, double row) const;

private:
    void stretch(GDALDataset& dataset, const PlacedTile& tile);

    int _step = 1;
    int _side = 0;
    std::vector<glm::dvec2> _pixels;
};

} // namespace osgTerrainROAM::core
