// SPDX-License-Identifier: Apache-2.0
#include <utility>

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
    if (look.farFeatures) name += " far features";
    if (look.openings) name += " openings";
    if (look.cover) name += " cover";
    if (look.sheets > 0) name += " sheets" + std::to_string(look.sheets);
    if (look.fine) name += " fine";
    if (look.season) name += " season";
    if (look.surroundings) name += " surroundings";
    return {name, terrainProgram(look)};
}

constexpr int kMostImagery = osgTerrainROAM::TerrainMaterial::kMaxImagery;
constexpr int kMostSheets = osgTerrainROAM::SheetNormals::kMostMaps;

} // namespace

std::vector<NamedProgram> terrainPrograms()
{
    std::vector<NamedProgram> programs;
    for (const int layers : {0, 1, kMostImagery})
        for (const int sheets : {0, 1, kMostSheets})
            for (unsigned mask = 0; mask < 32; ++mask)
                programs.push_back(programOf({.drape = (mask & 1) != 0,
                                              .layers = layers,
                                              .features = (mask & 2) != 0,
                                              .cover = (mask & 4) != 0,
                                              .sheets = sheets,
                                              .fine = (mask & 8) != 0,
                                              .season = (mask & 16) != 0}));
    // The numbers between: each further layer adds the same text.
    for (int layers = 2; layers < kMostImagery; ++layers)
        programs.push_back(programOf({.layers = layers}));
    for (int sheets = 2; sheets < kMostSheets; ++sheets)
        programs.push_back(programOf({.sheets = sheets}));
    for (const bool season : {false, true})
        programs.push_back(programOf({.season = season, .surroundings = true}));
    for (const bool features : {false, true})
        programs.push_back(programOf({.features = features, .openings = true}));
    for (const bool features : {false, true})
        for (const bool fine : {false, true})
            programs.push_back(
                programOf({.features = features, .farFeatures = true, .openings = true, .fine = fine}));
    return programs;
}

std::vector<NamedProgram> terrainExtremes()
{
    std::vector<NamedProgram> programs;
    for (const TerrainLook& look :
         {TerrainLook{}, TerrainLook{.drape = true}, TerrainLook{.layers = kMostImagery},
          TerrainLook{.features = true}, TerrainLook{.cover = true}, TerrainLook{.sheets = kMostSheets},
          TerrainLook{.fine = true}, TerrainLook{.season = true}, TerrainLook{.surroundings = true},
          TerrainLook{.openings = true}, TerrainLook{.farFeatures = true},
          TerrainLook{.drape = true,
          .layers = kMostImagery,
          .features = true,
          .farFeatures = true,
          .openings = true,
          .cover = true,
          .sheets = kMostSheets,
          .fine = true,
          .season = true}})
        programs.push_back(programOf(look));
    return programs;
}

std::vector<NamedProgram> layerPrograms()
{
    const auto layer = [](unsigned unit, LayerKind kind)
    { return ColourLayer{.kind = kind, .unit = unit, .texture = {}, .s = {}, .t = {}}; };
    std::vector<std::vector<ColourLayer>> all = {{},
                                                 {layer(0, LayerKind::image), layer(1, LayerKind::image)}};
    std::vector<ColourLayer> mixed;
    for (const LayerKind kind : {LayerKind::image, LayerKind::alpha, LayerKind::contour})
    {
        std::vector<ColourLayer> alike;
        for (unsigned unit = 0; unit < osgTerrainROAM::kMostLayers; ++unit)
            alike.push_back(layer(unit, kind));
        all.push_back({alike.front()});
        mixed.push_back(alike[mixed.size()]);
        all.push_back(std::move(alike));
    }
    all.push_back(mixed);

    osgTerrainROAM::LayerPrograms programs;
    std::vector<NamedProgram> named;
    for (const auto& layers : all)
        for (const bool hasHoles : {false, true})
        {
            const osg::ref_ptr<osg::Program> program = programs.program(layers, hasHoles);
            named.push_back({program->getName(), program});
        }
    return named;
}

} // namespace shadercheck
