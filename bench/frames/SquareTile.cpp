// SPDX-License-Identifier: Apache-2.0
#include "SquareTile.h"

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "measurement/flights/RasterCrop.h"

namespace framebench
{

using namespace osgTerrainROAM::core;

namespace
{

bool isTileSide(int side)
{
    const int cells = side - 1;
    return cells >= 2 && (cells & (cells - 1)) == 0;
}

} // namespace

foundation::Result<std::shared_ptr<const RoamTile>> squareTile(const std::filesystem::path& file,
                                                               const std::vector<int>& crop)
{
    const auto all = importDem(file);
    if (!all) return all.error();
    const measurement::RasterCrop square = measurement::rasterCrop(*all, crop);
    if (!isTileSide(square.side) || !square.isPartOf(*all))
        return foundation::Error{file.string(),
                                 "the square is no part of the raster, or has not 2^n+1 samples",
                                 "choose another one"};
    return std::make_shared<const RoamTile>(PlacedTile(square.of(*all), Placement::planar));
}

} // namespace framebench
