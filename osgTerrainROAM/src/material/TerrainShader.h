// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <osg/Program>

namespace osgTerrainROAM
{

/// The vertex shader for the vertices of RoamDrawable (shaders/Terrain.vert): outputs fromEye (metres, tile's
/// frame) and grid (samples).
osg::ref_ptr<osg::Shader> terrainVertexShader();

/// What a terrain has beside the land that follows from heights and climate. What it lacks costs nothing.
struct TerrainLook
{
    bool drape = false;        ///< imagery (TerrainMaterial::drape)
    int layers = 0;            ///< number of imagery layers in several resolutions, instead of drape
    bool features = false;     ///< vector features (FeatureTextures.h)
    bool farFeatures = false;  ///< those that stand for meshes near the eye
    bool openings = false;     ///< places without ground (OpeningTexture.h)
    bool cover = false;        ///< land cover (CoverTexture.h)
    int sheets = 0;            ///< number of normal maps of denser sheets (SheetNormals.h)
    bool fine = false;         ///< normals between the samples (FineNormals.h)
    bool season = false;       ///< snow of the season (GroundPalette.h)
    bool surroundings = false; ///< the ground beyond the data (Surroundings.h), with a season at most
    std::optional<std::string> lentNames =
        std::nullopt; ///< for another surface (TerrainMaterial::BorrowedLook)
};

/// The text of the look's fragment shader without main(): vec3 groundRadiance(vec3 directionWorld) and what
/// it needs.
std::string groundText(const TerrainLook& look);

/// The text of the fragment shader of the terrain's own ground.
std::string terrainFragmentText(const TerrainLook& look);

/// The terrain's program, composed of the parts in shaders/ that the look needs.
osg::ref_ptr<osg::Program> terrainProgram(const TerrainLook& look);

} // namespace osgTerrainROAM
