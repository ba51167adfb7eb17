// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osg/Image>
#include <osg/Material>
#include <osg/Texture>

#include <osgPMObjects/MaterialLooks>

namespace osgPMObjects
{

namespace
{

float luminanceOf(const osg::Vec4& colour)
{
    return 0.2126f * colour.r() + 0.7152f * colour.g() + 0.0722f * colour.b();
}

/// Texels a side; finer textures show nothing more in small images.
constexpr int kMostTexels = 256;

void addTexels(core::MaterialLook& look, const osg::Image& picture)
{
    if (picture.s() < 1 || picture.t() < 1 || !picture.data()) return;
    const int wide = std::min(picture.s(), kMostTexels), high = std::min(picture.t(), kMostTexels);
    look.texelsWide = static_cast<std::uint32_t>(wide);
    look.texelsHigh = static_cast<std::uint32_t>(high);
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x)
        {
            const osg::Vec4 colour = picture.getColor(static_cast<unsigned>(x * picture.s() / wide),
                                                      static_cast<unsigned>(y * picture.t() / high));
            const float luminance = std::clamp(luminanceOf(colour), 0.0f, 1.0f);
            look.texels.push_back(static_cast<std::uint8_t>(std::lround(255.0f * luminance)));
        }
}

core::MaterialLook lookOf(const osg::StateSet& state)
{
    core::MaterialLook look;
    const auto* material =
        dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    if (material) look.luminance = luminanceOf(material->getDiffuse(osg::Material::FRONT));
    const auto* texture =
        dynamic_cast<const osg::Texture*>(state.getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    if (texture && texture->getNumImages() > 0 && texture->getImage(0))
        addTexels(look, *texture->getImage(0));
    return look;
}

} // namespace

std::vector<core::MaterialLook> materialLooks(const core::Mesh& mesh,
                                              std::span<const osg::ref_ptr<osg::StateSet>> states)
{
    std::vector<core::MaterialLook> looks;
    for (const core::Material& material : mesh.materials)
    {
        const bool hasState = material.state < states.size() && states[material.state];
        looks.push_back(hasState ? lookOf(*states[material.state]) : core::MaterialLook{});
    }
    return looks;
}

} // namespace osgPMObjects
