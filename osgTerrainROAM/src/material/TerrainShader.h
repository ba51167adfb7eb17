// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Program>

namespace osgTerrainROAM
{

/// Takes the vertices that RoamDrawable draws: gives a fragment shader `in vec3 fromEye` (metres, tile's frame) and
/// `in vec2 grid` (samples), and clips at the uniform terrainLastSample.
osg::ref_ptr<osg::Shader> terrainVertexShader();

/// What a terrain's program has beside the land that follows from heights and climate. What it lacks costs nothing.
struct TerrainLook
{
    bool drape = false;    ///< imagery (TerrainMaterial::drape)
    int layers = 0;        ///< imagery in several resolutions instead (ImageryShader.h)
    bool features = false; ///< vector features (FeatureTextures.h)
    bool cover = false;    ///< land cover (CoverShader.h)
    int sheets = 0;        ///< normal maps of denser parts (SheetNormals.h)
    bool fine = false;     ///< normals between the samples (FineNormals.h)
    bool season = false;   ///< snow of the season (CoverShader.h)
};

/// The terrain's program.
osg::ref_ptr<osg::Program> terrainProgram(const TerrainLook& look);

} // namespace osgTerrainROAM
