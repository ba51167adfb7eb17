// SPDX-License-Identifier: Apache-2.0
#include "TerrainShader.h"

#include <string>

#include <osgSky/Atmosphere>

#include <shaders/osgTerrainROAM.h>

#include "RepeatedLayers.h"

namespace osgTerrainROAM
{

namespace
{

/// The defines that shaders/*.glsl test.
std::string definesOf(const TerrainLook& look)
{
    std::string text;
    if (look.drape) text += "#define TERRAIN_DRAPE\n";
    if (look.layers > 0) text += "#define TERRAIN_LAYERS\n";
    if (look.features || look.farFeatures) text += "#define TERRAIN_FEATURES\n";
    if (look.features) text += "#define TERRAIN_LISTED_FEATURES\n";
    if (look.farFeatures) text += "#define TERRAIN_FAR_FEATURES\n";
    if (look.openings) text += "#define TERRAIN_OPENINGS\n";
    if (look.cover) text += "#define TERRAIN_COVER\n";
    if (look.season) text += "#define TERRAIN_SEASON\n";
    if (look.sheets > 0) text += "#define TERRAIN_SHEETS\n";
    if (look.fine) text += "#define TERRAIN_FINE\n";
    if (look.lentNames) text += "#define TERRAIN_LENT\n" + *look.lentNames;
    if (look.surroundings) text += "#define TERRAIN_SURROUNDINGS\n";
    return text;
}

std::string featureFunctions(bool listed, bool far)
{
    std::string text = shaders::kFeatureFilters;
    if (listed)
        for (const char* part : {shaders::kFeatureMaps, shaders::kFeatureAreas, shaders::kFeatureLines,
                                 shaders::kFeatureStrokes, shaders::kFeaturePaint})
            text += part;
    if (far) text += shaders::kFarFeatures;
    return text + shaders::kFeatureColours;
}

} // namespace

// Each part follows those whose functions it calls.
std::string groundText(const TerrainLook& look)
{
    std::string text = "#version 330 compatibility\n" + definesOf(look);
    text += osgSky::Atmosphere::glslFunctions();
    text += shaders::kTerrainInputs;
    text += shaders::kGrain;
    if (look.sheets > 0) text += sheetNormalsText(look.sheets);
    if (look.fine) text += shaders::kFineNormals;
    if (look.surroundings) text += shaders::kOuterMaps;
    text += shaders::kGroundDetail;
    text += shaders::kGroundColour;
    text += shaders::kWaterColour;
    if (look.features || look.farFeatures) text += featureFunctions(look.features, look.farFeatures);
    if (look.openings) text += shaders::kGroundOpenings;
    if (look.layers > 0) text += imageryText(look.layers);
    if (look.cover) text += shaders::kLandCover;
    if (look.season) text += shaders::kSeasonSnow;
    return text + shaders::kGroundRadiance;
}

osg::ref_ptr<osg::Shader> terrainVertexShader()
{
    return new osg::Shader(osg::Shader::VERTEX, shaders::kTerrainVert);
}

std::string terrainFragmentText(const TerrainLook& look)
{
    return groundText(look) + shaders::kTerrainMain;
}

osg::ref_ptr<osg::Program> terrainProgram(const TerrainLook& look)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("terrain");
    program->addShader(terrainVertexShader());
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, terrainFragmentText(look)));
    return program;
}

} // namespace osgTerrainROAM
