// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Program>

namespace osgTerrainROAM
{

/// The terrain's program; `draped`: with an imagery on unit 3.
osg::ref_ptr<osg::Program> terrainProgram(bool draped);

} // namespace osgTerrainROAM
