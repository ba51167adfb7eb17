// SPDX-License-Identifier: Apache-2.0
#include "BakedState.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <osg/Image>
#include <osg/LightModel>
#include <osg/Material>

#include <shaders/bakedObjects.h>

namespace osgPMObjects
{

namespace
{

constexpr unsigned kColourUnit = 0, kNormalUnit = 1;

template<std::size_t Channels>
osg::ref_ptr<osg::Texture2D> textureOf(const std::vector<std::array<std::uint8_t, Channels>>& texels,
                                       int size, const char* name)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(size, size, 1, Channels == 4 ? GL_RGBA : GL_RGB, GL_UNSIGNED_BYTE);
    std::memcpy(image->data(), texels.data(), texels.size() * Channels);
    image->setName(name);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setName(name);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

/// Returns how often the normal map may be halved: one and a half texels, which filtering reads, have to fit
/// between two charts.
float smallestCopy(int gutterPx)
{
    return std::floor(std::log2(2.0f * static_cast<float>(gutterPx) / 1.5f));
}

/// Makes an image of three channels if the fourth has no content.
osg::ref_ptr<osg::Texture2D> colourTexture(const core::BakedMaps& maps)
{
    if (std::any_of(maps.colours.begin(), maps.colours.end(),
                    [](const core::Rgba& c) { return c[3] != 255; }))
        return textureOf(maps.colours, maps.sizePx, "baked colours");
    std::vector<core::Rgb> opaque;
    opaque.reserve(maps.colours.size());
    for (const core::Rgba& c : maps.colours)
        opaque.push_back({c[0], c[1], c[2]});
    return textureOf(opaque, maps.sizePx, "baked colours");
}

void removeTextures(osg::StateSet& state)
{
    std::vector<std::pair<unsigned, osg::StateAttribute::TypeMemberPair>> attributes;
    for (unsigned unit = 0; unit < state.getTextureAttributeList().size(); ++unit)
        for (const auto& [type, attribute] : state.getTextureAttributeList()[unit])
            attributes.emplace_back(unit, type);
    for (const auto& [unit, type] : attributes)
        state.removeTextureAttribute(unit, type.first);
    std::vector<std::pair<unsigned, GLenum>> modes;
    for (unsigned unit = 0; unit < state.getTextureModeList().size(); ++unit)
        for (const auto& [mode, value] : state.getTextureModeList()[unit])
            modes.emplace_back(unit, mode);
    for (const auto& [unit, mode] : modes)
        state.removeTextureMode(unit, mode);
}

osg::ref_ptr<osg::Material> materialOf(const Finish& finish)
{
    const auto with = [](const glm::vec3& c) { return osg::Vec4(c.r, c.g, c.b, 1.0f); };
    constexpr auto kBoth = osg::Material::FRONT_AND_BACK;
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setColorMode(osg::Material::OFF);
    material->setAmbient(kBoth, with(finish.ambient));
    material->setDiffuse(kBoth, with(finish.diffuse));
    material->setEmission(kBoth, with(finish.emission));
    material->setSpecular(kBoth, with(finish.specular));
    material->setShininess(kBoth, finish.shininess);
    return material;
}

/// Returns whether back faces are lit as back faces. Lets the texture scale gloss like all other light.
bool lightBoth(osg::StateSet& state)
{
    const auto* known =
        dynamic_cast<const osg::LightModel*>(state.getAttribute(osg::StateAttribute::LIGHTMODEL));
    if (!known) return false;
    const osg::ref_ptr<osg::LightModel> model = new osg::LightModel(*known);
    model->setColorControl(osg::LightModel::SINGLE_COLOR);
    state.setAttribute(model);
    return model->getTwoSided();
}

} // namespace

BakedLook::BakedLook(const core::BakedMaps& maps, int gutterPx)
    : _colours(colourTexture(maps)),
      _normals(textureOf(maps.normals, maps.sizePx, "baked normals")),
      _program(new osg::Program)
{
    _normals->setMaxLOD(smallestCopy(gutterPx));
    _program->setName("baked");
    _program->addShader(new osg::Shader(osg::Shader::VERTEX, bakedObjects::shaders::kBakedVert));
    _program->addShader(new osg::Shader(osg::Shader::FRAGMENT, bakedObjects::shaders::kBakedFrag));
}

osg::ref_ptr<osg::StateSet> BakedLook::stateFor(const osg::StateSet& state, const Finish& finish,
                                                bool hasNormals) const
{
    osg::ref_ptr<osg::StateSet> baked = new osg::StateSet(state);
    removeTextures(*baked);
    baked->removeAttribute(osg::StateAttribute::PROGRAM);
    baked->setTextureAttributeAndModes(kColourUnit, _colours);
    if (!finish.isLit) return baked;
    baked->setAttribute(materialOf(finish));
    const bool litFromBothSides = lightBoth(*baked);
    if (!hasNormals) return baked;
    baked->setTextureAttribute(kNormalUnit, _normals); // not enabled: fixed function ignores it
    baked->setAttributeAndModes(_program);
    baked->addUniform(new osg::Uniform("bakedColours", static_cast<int>(kColourUnit)));
    baked->addUniform(new osg::Uniform("bakedNormals", static_cast<int>(kNormalUnit)));
    baked->addUniform(new osg::Uniform("bakedLights", 1));
    baked->addUniform(new osg::Uniform("bakedBothSides", litFromBothSides));
    return baked;
}

} // namespace osgPMObjects
