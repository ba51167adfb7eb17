// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/State>

namespace osgTerrainROAM
{

/// Tells which fixed-function lights are on, a bit each, because a shader cannot read that; -1: lighting is
/// off.
int lightsOf(const osg::State& state);

/// Returns the fog's coefficients: at depth d, the share clamp(x + y·d, 0, 1) · 2^−d(z + w·d) of a colour
/// passes it; all without fog.
osg::Vec4f fogOf(const osg::State& state);

/// Sets the current colour, which a material may follow, to white. It calls OSG, so that nothing is linked to
/// OpenGL.
void setColourWhite(osg::State& state);

} // namespace osgTerrainROAM
