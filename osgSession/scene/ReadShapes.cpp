// SPDX-License-Identifier: Apache-2.0
#include "ReadShapes.h"

#include <osg/Notify>

namespace trainer
{

foundation::Result<osgTerrainROAM::core::ShapeSet> readShapes(const std::filesystem::path& source,
                                                              const osgTerrainROAM::core::RoamTile& tile)
{
    auto shapes =
        osgTerrainROAM::core::importShapes(source, tile.tile, foundation::KeptFrom::ofUser(tile.mark()));
    if (shapes)
        for (const std::string& note : shapes->notes)
            OSG_NOTICE << note << '\n';
    return shapes;
}

} // namespace trainer
