// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/State>

#include <osgTerrainROAM/core/heightfield/TileFrame.h>

namespace osgTerrainROAM
{

/// Sets the uniforms of shaders/Terrain.vert and TerrainInputs.glsl that follow from the eye, in the program in use.
/// `stepM`: what the positions of the vertices are counted in. Threads: the draw thread.
void setTileUniforms(osg::State& state, const core::TileFrame& frame, double stepM);

} // namespace osgTerrainROAM
