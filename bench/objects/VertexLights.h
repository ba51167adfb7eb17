// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/BoundingSphere>
#include <osg/StateSet>

namespace objectbench
{

/// Lights each vertex by lamps around a ball, diffuse and specular, as the fixed-function pipeline does.
osg::ref_ptr<osg::StateSet> vertexLights(int lights, const osg::BoundingSphere& ball);

} // namespace objectbench
