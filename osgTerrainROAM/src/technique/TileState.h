// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include "LayerShader.h"
#include "TileGround.h"

namespace osgTerrainROAM
{

/// Makes the state of a tile: program, maps and colour layers, with blending where the tile blends. A layer
/// uses the texture unit of its number, as in stock osgTerrain; the maps use the units below.
/// Cost: about 0.2 µs a sample.
osg::ref_ptr<osg::StateSet> tileState(const osgTerrain::TerrainTile& tile, const TileGround& ground,
                                      LayerPrograms& programs);

inline constexpr unsigned int kSurfaceUnit = 14, kHoleUnit = 15;

} // namespace osgTerrainROAM
