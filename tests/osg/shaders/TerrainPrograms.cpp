// SPDX-License-Identifier: Apache-2.0
#include <material/SheetNormals.h>
#include <material/TerrainShader.h>
#include <technique/LayerShader.h>

#include <osgTerrainROAM/TerrainMaterial>

#include "Compositions.h"

namespace shadercheck
{

namespace
{

using osgTerrainROAM::ColourLayer;
using osgTerrainROAM::LayerKind;
using osgTerrainROAM::TerrainLook;

NamedProgram programOf(const TerrainLook& look)
{
    std::string name = "terrain";
    if (look.drape) name += " drape";
    if (look.layers > 0) name += " layers" + std::to_string(look.layers);
    if (look.features) name += " features";
    if (look.cover) name += " cover";
    if (look.sheets > 0) name += " sheets" + std::to_string(look.sheets);
    if (look.fine) name += " fine";
    if (look.season) name += " season";
    return {name, terrainProgram(look)};
}

/// None, one, and as many as there can be: the text of each further one is alike.
std::vector<int> numbersUpTo(std::size_t most)
{
    return {0, 1, static_cast<int>(most)};
}

const std::vector<int> kLayerNumbers = numbersUpTo(osgTerrainROAM::TerrainMaterial::kMaxImagery);
const std::vector<int> kSheetNumbers = numbersUpTo(osgTerrainROAM::SheetNormals::kMostMaps);

NamedProgram programOf(osgTerrainROAM::LayerPrograms& programs, const std::vector<ColourLayer>& layers,
                       bool hasHoles)
{
    const osg::ref_ptr<osg::Program> program = programs.program(layers, hasHoles);
    return {program->getName(), program};
}

} // namespace

std::vector<NamedProgram> terrainPrograms()
{
    std::vector<NamedProgram> programs;
    for (const int layers : kLayerNumbers)
        for (const int sheets : kSheetNumbers)
            for (unsigned mask = 0; mask < 32; ++mask)
                programs.push_back(programOf({.drape = (mask & 1) != 0,
                                              .layers = layers,
                                              .features = (mask & 2) != 0,
                                              .cover = (mask & 4) != 0,
                                              .sheets = sheets,
                                              .fine = (mask & 8) != 0,
                                              .season = (mask & 16) != 0}));
    return programs;
}

std::vector<NamedProgram> terrainExtremes()
{
    std::vector<NamedProgram> programs;
    for (const TerrainLook& look :
         {TerrainLook{}, TerrainLook{.drape = true}, TerrainLook{.layers = kLayerNumbers.back()},
          TerrainLook{.features = true}, TerrainLook{.cover = true},
          TerrainLook{.sheets = kSheetNumbers.back()}, TerrainLook{.fine = true}, TerrainLook{.season = true},
          TerrainLook{true, kLayerNumbers.back(), true, true, kSheetNumbers.back(), true, true}})
        programs.push_back(programOf(look));
    return programs;
}

std::vector<NamedProgram> layerPrograms()
{
    std::vector<ColourLayer> many;
    for (unsigned unit = 0; unit < osgTerrainROAM::kMostLayers; ++unit)
        many.push_back({.kind = LayerKind::image, .unit = unit, .texture = {}, .s = {}, .t = {}});
    many[1].kind = LayerKind::alpha;
    many[7].kind = LayerKind::contour;

    osgTerrainROAM::LayerPrograms programs;
    std::vector<NamedProgram> all;
    for (const bool hasHoles : {false, true})
    {
        for (const std::vector<ColourLayer>& layers :
             {std::vector<ColourLayer>{}, {many[0]}, {many[1]}, {many[7]}, {many[0], many[7]}, many})
            all.push_back(programOf(programs, layers, hasHoles));
    }
    return all;
}

} // namespace shadercheck
