// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgTerrainROAM
{

/// GLSL of what paints vector features, in three parts, to stand in this order behind the head of the terrain's fragment shader and its grain:
///   Paint terrainPaint(vec2 place)          what lies at a place, filtered by the pixel's footprint; `place` as the eye's
///                                           is wrapped (TerrainShader)
///   vec4 fieldAlbedo(vec4 ground, Paint, Grain)    ground colour and share of wood, with the fields laid over
///   vec3 pavedAlbedo(vec3 albedo, Paint, Grain)    roads, runways and their markings over everything
///   float openShare(Paint)                          share of the ground that none of river, road and runway takes
///   vec3 paintLight(Paint)                          radiance of lamps
/// Uniforms: FeatureTextures.h; terrainEyeWraps (ViewPart).
/// Source: Nehab and Hoppe, Random-access rendering of general vector graphics (2008): lists in cells, evaluated in the fragment;
/// Quilez, distance functions of segments. Filters are exact integrals of bands and dashes over the footprint's width
/// along their normal, so that a line thinner than a pixel becomes its share of it.
const char* featureCellsGlsl(); ///< lists, filters, areas
const char* featureLinesGlsl(); ///< lines and strokes
const char* featurePaintGlsl(); ///< a pixel of them, and how it looks

} // namespace osgTerrainROAM
