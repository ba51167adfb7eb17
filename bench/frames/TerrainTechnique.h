// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "Look.h"

namespace framebench
{

/// The tile as osgTerrain draws it: an osgTerrain::Terrain in its defaults (sample ratio 1) over one TerrainTile with a
/// HeightFieldLayer and osgTerrain::GeometryTechnique. It is dressed with the look's own fragment shader; without a
/// material it keeps what it has by default: OSG's fixed-function light on the normals that the technique computes.
osg::ref_ptr<osg::Node> terrainTechnique(const osgTerrainROAM::core::PlacedTile& tile,
                                         const osgTerrainROAM::TerrainMaterial* material, Look look);

} // namespace framebench
