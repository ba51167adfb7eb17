// SPDX-License-Identifier: Apache-2.0
#include "LayerShader.h"

#include <shaders/osgTerrainROAM.h>

#include "../material/RepeatedLayers.h"
#include "../material/TerrainShader.h"

namespace osgTerrainROAM
{

namespace
{

std::string samplerOf(const ColourLayer& layer)
{
    return std::string("uniform ") + (layer.kind == LayerKind::contour ? "sampler1D" : "sampler2D") +
           " terrainLayer" + std::to_string(layer.unit) + ";\n";
}

std::string lookUpOf(const ColourLayer& layer)
{
    const std::string n = std::to_string(layer.unit);
    const std::string s = "terrainLayerS[" + n + "]", t = "terrainLayerT[" + n + "]";
    if (layer.kind == LayerKind::contour)
        return "    colour *= texture(terrainLayer" + n + ", " + s + ".x + " + s +
               ".y * (terrainLayerHeights.x + terrainLayerHeights.y * surface.a));\n";
    return std::string("    colour") + (layer.kind == LayerKind::alpha ? ".a" : "") +
           " *= texture(terrainLayer" + n + ", vec2(dot(" + s + ", weights), dot(" + t + ", weights)))" +
           (layer.kind == LayerKind::alpha ? ".a" : "") + ";\n";
}

std::string fragmentShader(const std::vector<ColourLayer>& layers, bool hasHoles)
{
    std::string samplers, lookUps;
    for (const ColourLayer& layer : layers)
    {
        samplers += samplerOf(layer);
        lookUps += lookUpOf(layer);
    }
    if (hasHoles) lookUps += "    if (isHole()) discard;\n"; // last: mip levels come from neighbours
    std::string text = std::string("#version 330 compatibility\n") + shaders::kLayerInputs + samplers +
                       shaders::kFixedFunctionLight;
    if (hasHoles) text += shaders::kLayerHoles;
    return text + shaders::kLayerSurface + withLines(shaders::kLayerMain, "layers", lookUps);
}

std::string keyOf(const std::vector<ColourLayer>& layers, bool hasHoles)
{
    std::string key = hasHoles ? "h" : "";
    for (const ColourLayer& layer : layers)
        key += std::to_string(layer.unit) + static_cast<char>(layer.kind);
    return key;
}

} // namespace

osg::ref_ptr<osg::Program> LayerPrograms::program(const std::vector<ColourLayer>& layers, bool hasHoles)
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<osg::Program>& program = _programs[keyOf(layers, hasHoles)];
    if (!program)
    {
        program = new osg::Program;
        program->setName("terrain layers " + keyOf(layers, hasHoles));
        program->addShader(terrainVertexShader());
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragmentShader(layers, hasHoles)));
    }
    return program;
}

} // namespace osgTerrainROAM
