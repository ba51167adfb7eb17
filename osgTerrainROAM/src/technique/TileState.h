// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include "LayerShader.h"
#include "TileGround.h"

namespace osgTerrainROAM
{

/// Program, maps and colour layers of a tile, blended where the tile blends. The layers are on the texture units of their
/// numbers, as stock osgTerrain has them, the maps on the units below.
/// Cost: about 0.2 µs a sample.
osg::ref_ptr<osg::StateSet> tileState(const osgTerrain::TerrainTile& tile, const TileGround& ground,
                                      LayerPrograms& programs);

inline constexpr unsigned int kSurfaceUnit = 14, kHoleUnit = 15;

} // namespace osgTerrainROAM
