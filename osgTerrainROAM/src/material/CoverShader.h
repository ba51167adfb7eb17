// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgTerrainROAM
{

/// GLSL of land cover, to stand behind the head of the terrain's fragment shader:
///   Cover terrainCover(vec2 grid, Grain)                    what covers a grid place, blended with its neighbours
///   vec4 coveredGround(vec4 ground, Cover, Grain)           ground colour and share of wood
///   vec3 townLight(Cover, vec2 place, vec2 x, vec2 y)       radiance of a town's lamps at night; `place` as the eye's is wrapped
/// Borders of classes are bent by the grain, so that they show no steps of the raster.
const char* coverGlsl();

/// GLSL of the seasons' snow: float seasonSnow(float earlySummers, vec3 place, float steep, Grain)
const char* seasonGlsl();

} // namespace osgTerrainROAM
