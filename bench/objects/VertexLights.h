// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/BoundingSphere>
#include <osg/StateSet>

namespace objectbench
{

/// Lights each vertex by so many lamps around a ball, diffuse and specular with the eye at its place, as fixed function lights.
osg::ref_ptr<osg::StateSet> vertexLights(int lights, const osg::BoundingSphere& ball);

} // namespace objectbench
