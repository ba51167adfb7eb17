// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osg/Node>
#include <osg/ref_ptr>

#include <osgRoads/core/surface/PagedRoadMesh.h>

#include <osgTerrainROAM/RoamTerrain>

namespace scenery
{

/// Makes the node that draws the surface of a road network in the light and the haze of the scene's
/// Atmosphere, whose uniforms belong above it. Verges and lanes of grass look as the ground of `terrain` does
/// where they lie; null: they are plain green.
/// Frame: the scene's, which is the terrain's.
osg::ref_ptr<osg::Node> makeRoadNode(std::shared_ptr<const osgRoads::core::PagedRoadMesh> mesh,
                                     osgTerrainROAM::RoamTerrain* terrain = nullptr);
osg::ref_ptr<osg::Node> makeRoadNode(std::shared_ptr<const osgRoads::core::RoadMesh> mesh,
                                     osgTerrainROAM::RoamTerrain* terrain = nullptr);

} // namespace scenery
