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

/// The pixel of a raster under each node of a tile's geodetic net; between nodes it is interpolated. A raster without
/// georeference is stretched over the tile. Pixels as GDAL counts them: from the upper left corner, centres at halves.
class PixelNet
{
public:
    /// Errors: the raster has a place and the tile has none; coordinate systems that cannot be related.
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
