// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/LightModel>
#include <osg/Material>
#include <osg/Texture2D>
#include <osg/ValueObject>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ReadModel>

#include "../pm/ImageFiles.h"

namespace osgPMObjects
{

namespace
{

osg::ref_ptr<osg::Texture2D> textureOf(const core::GltfImage& from)
{
    constexpr GLenum kFormats[] = {GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};
    if (from.channels == 0) return nullptr;
    const GLenum format = kFormats[from.channels - 1];
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(from.widthPx, from.heightPx, 1, format, GL_UNSIGNED_BYTE, 1);
    std::copy(from.bytes.begin(), from.bytes.end(),
              image->data()); // the top row first, as in glTF
    image->setFileName(from.uri);
    if (!from.file.empty()) image->setUserValue(kImageFileValue, from.file);
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    return texture;
}

/// Returns the shininess that looks like a roughness. Source: Walter et al., "Microfacet models for
/// refraction", 2007: the exponent 2/α² - 2 of a Beckmann lobe, with α = roughness² (glTF 2.0, appendix B).
float shininess(double roughness)
{
    const double alpha = std::max(roughness * roughness, 0.1);
    return static_cast<float>(std::clamp(2.0 / (alpha * alpha) - 2.0, 0.0, 128.0));
}

osg::ref_ptr<osg::StateSet> stateOf(const core::GltfMaterial& from,
                                    const osg::ref_ptr<osg::Texture2D>& texture)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setName(from.name);
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    const osg::Vec4 base(from.baseColour.r, from.baseColour.g, from.baseColour.b, from.baseColour.a);
    material->setName(from.name);
    material->setAmbient(osg::Material::FRONT_AND_BACK, base);
    material->setDiffuse(osg::Material::FRONT_AND_BACK, base);
    material->setEmission(osg::Material::FRONT_AND_BACK,
                          {from.emission.r, from.emission.g, from.emission.b, 1.0f});
    material->setSpecular(osg::Material::FRONT_AND_BACK,
                          {0.04f, 0.04f, 0.04f, 1.0f}); // of dielectrics, glTF 2.0, appendix B
    material->setShininess(osg::Material::FRONT_AND_BACK, shininess(from.roughness));
    state->setAttributeAndModes(material);
    if (texture) state->setTextureAttributeAndModes(from.texCoordSet == 1 ? 1 : 0, texture);
    if (from.isBlended)
    {
        state->setAttributeAndModes(new osg::BlendFunc);
        state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
    if (from.alphaCutoff >= 0.0)
        state->setAttributeAndModes(
            new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, static_cast<float>(from.alphaCutoff)));
    if (from.isTwoSided)
    {
        const osg::ref_ptr<osg::LightModel> lighting = new osg::LightModel;
        lighting->setTwoSided(true);
        state->setAttributeAndModes(lighting);
    }
    else
        state->setAttributeAndModes(new osg::CullFace);
    return state;
}

} // namespace

osg::ref_ptr<osg::Group> nodeOf(const core::GltfModel& model)
{
    std::vector<osg::ref_ptr<osg::Texture2D>> textures;
    for (const core::GltfImage& image : model.images)
        textures.push_back(textureOf(image));
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    for (const core::GltfMaterial& material : model.materials)
    {
        const bool hasTexture =
            material.image >= 0 && static_cast<std::size_t>(material.image) < textures.size();
        states.push_back(
            stateOf(material, hasTexture ? textures[static_cast<std::size_t>(material.image)] : nullptr));
    }
    const osg::ref_ptr<osg::Group> root = exportNode(model.mesh, states);
    const auto note = [&](std::size_t count, const char* what)
    {
        if (count > 0) root->addDescription(std::to_string(count) + ' ' + what);
    };
    note(model.report.refusedFaces, "faces refused: an index or a coordinate that is none");
    note(model.report.pointsAndLines, "primitives left out: points and lines");
    note(model.report.unreadImages, "images not read");
    note(model.report.droppedAttributes, "attribute arrays left out");
    note(model.report.animations, "animations, skins and morph targets left out");
    for (const std::string& name : model.report.leftOutExtensions)
        root->addDescription("the extension " + name + " is left out");
    for (const std::string& name : model.report.missingImages)
        root->addDescription(missingImageNote(name));
    return root;
}

} // namespace osgPMObjects
