// SPDX-License-Identifier: Apache-2.0
#include "ReadShapes.h"

namespace trainer
{

foundation::Result<osgTerrainROAM::core::ShapeSet> readShapes(const std::filesystem::path& source,
                                                              const osgTerrainROAM::core::RoamTile& tile)
{
    return osgTerrainROAM::core::importShapes(source, tile.tile, foundation::KeptFrom::ofUser(tile.mark()));
}

} // namespace trainer
