// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/HeightsInScene.h"

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

namespace scenery
{

void putHeightsInScene(Structure& structure, const osgTerrainROAM::core::PlacedTile& tile)
{
    for (std::size_t i = 0; i < structure.heightsM.size(); ++i)
    {
        const auto ground = osgTerrainROAM::core::groundAt(tile, structure.line[i].x, structure.line[i].y);
        if (!ground) return structure.heightsM.clear();
        structure.heightsM[i] += ground->position.z - tile.frame().heightOf(ground->position);
    }
}

} // namespace scenery
