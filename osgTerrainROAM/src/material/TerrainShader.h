// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Program>

namespace osgTerrainROAM
{

/// What a terrain's program has beside the land that follows from heights and climate. What it lacks costs nothing.
struct TerrainLook
{
    bool drape = false;    ///< imagery (TerrainMaterial::drape)
    int layers = 0;        ///< imagery in several resolutions instead (ImageryShader.h)
    bool features = false; ///< vector features (FeatureTextures.h)
    bool cover = false;    ///< land cover (CoverShader.h)
    bool season = false;   ///< snow of the season (CoverShader.h)
};

/// The terrain's program.
osg::ref_ptr<osg::Program> terrainProgram(const TerrainLook& look);

} // namespace osgTerrainROAM
