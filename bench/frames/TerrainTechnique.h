// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "Look.h"

namespace framebench
{

/// Makes the tile as osgTerrain draws it: an osgTerrain::Terrain with default settings (sample ratio 1) over
/// one TerrainTile with a HeightFieldLayer and osgTerrain::GeometryTechnique. It has the fragment shader of
/// the look; without a material it keeps the fixed-function light of OSG on the normals of the technique.
osg::ref_ptr<osg::Node> terrainTechnique(const osgTerrainROAM::core::PlacedTile& tile,
                                         const osgTerrainROAM::TerrainMaterial* material, Look look);

} // namespace framebench
