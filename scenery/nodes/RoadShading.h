// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osg/Node>
#include <osg/ref_ptr>

#include <osgRoads/core/surface/RoadMesh.h>

namespace scenery
{

/// Makes the node that draws the surface of a road network in the light and the haze of the scene's Atmosphere, whose uniforms belong
/// above it. Frame: the scene's.
osg::ref_ptr<osg::Node> makeRoadNode(std::shared_ptr<const osgRoads::core::RoadMesh> mesh);

} // namespace scenery
