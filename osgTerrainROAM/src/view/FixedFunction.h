// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/State>

namespace osgTerrainROAM
{

/// What a shader cannot ask OpenGL's fixed functions about: which lights are on, a bit each; -1: lighting is off.
int lightsOf(const osg::State& state);

/// Of a colour at depth d, clamp(x + y·d, 0, 1) · 2^−d(z + w·d) comes through the fog: all of it where there is none.
osg::Vec4f fogOf(const osg::State& state);

/// White is the current colour, which a material may follow. Through OSG, so that nothing here is linked to OpenGL.
void setColourWhite(osg::State& state);

} // namespace osgTerrainROAM
