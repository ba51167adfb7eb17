// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrain/Terrain>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace framebench
{

/// Makes the tile as a database of osgTerrain: square tiles of `cells` cells, each a TerrainTile with a
/// HeightFieldLayer and an ImageLayer of as many texels (colours by height), under an osgTerrain::Terrain
/// with default settings (sample ratio 1) and the technique as its prototype. The light is the scene's.
osg::ref_ptr<osgTerrain::Terrain> tiledDatabase(const osgTerrainROAM::core::PlacedTile& tile, int cells,
                                                osgTerrain::TerrainTechnique* technique);

} // namespace framebench
