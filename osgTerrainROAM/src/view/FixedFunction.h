// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/State>

namespace osgTerrainROAM
{

/// What a shader cannot ask OpenGL's fixed functions about: which lights are on, a bit each; -1: lighting is off.
int lightsOf(const osg::State& state);

/// 0: no fog; 1 linear, 2 exp, 3 exp2.
int fogModeOf(const osg::State& state);

/// White is the current colour, which a material may follow. Through OSG, so that nothing here is linked to OpenGL.
void setColourWhite(osg::State& state);

} // namespace osgTerrainROAM
