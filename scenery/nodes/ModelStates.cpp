// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ModelStates.h"

#include <algorithm>
#include <cstring>

#include <foundation/KeptResults.h>

#include <osg/AlphaFunc>
#include <osg/CullFace>
#include <osg/Image>

#include <osgPMObjects/ExportNode>

#include "scenery/models/paint/MipChain.h"
#include "scenery/nodes/KeptPaintings.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

osg::ref_ptr<osg::Image> imageOf(const std::vector<models::Picture>& chain)
{
    std::size_t bytes = 0;
    osg::Image::MipmapDataType offsets;
    for (const models::Picture& level : chain)
    {
        if (bytes > 0) offsets.push_back(static_cast<unsigned>(bytes));
        bytes += level.rgba.size();
    }
    auto* data = new unsigned char[bytes]; // the image's from here on
    unsigned char* out = data;
    for (const models::Picture& level : chain)
    {
        std::memcpy(out, level.rgba.data(), level.rgba.size());
        out += level.rgba.size();
    }
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(chain.front().widthPx, chain.front().heightPx, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE,
                    data, osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

Finish finishOf(models::Coat coat)
{
    switch (coat)
    {
    case models::Coat::lacquered:
        return Finish::lacquered;
    case models::Coat::foliage:
        return Finish::foliage;
    case models::Coat::matt:
        break;
    }
    return Finish::matt;
}

} // namespace

osg::ref_ptr<osg::Texture2D> ModelStates::textureOf(models::Painting painting, bool isFoliage)
{
    osg::ref_ptr<osg::Texture2D>& texture = _textures[static_cast<std::size_t>(painting)];
    if (texture) return texture;
    texture =
        new osg::Texture2D(imageOf(paintedChain(painting, isFoliage, foundation::KeptResults::ofUser())));
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    const auto wrap = isFoliage ? osg::Texture::CLAMP_TO_EDGE : osg::Texture::REPEAT;
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    texture->setMaxAnisotropy(4.0F);
    texture->setUseHardwareMipMapGeneration(false);
    return texture;
}

osg::ref_ptr<osg::StateSet> ModelStates::stateOf(const models::Surface& surface)
{
    osg::ref_ptr<osg::StateSet>& state = _states[{surface.painting, surface.coat}];
    if (state) return state;
    const bool isFoliage = surface.coat == models::Coat::foliage;
    const osg::ref_ptr<osg::Group> carrier = new osg::Group;
    setObjectShading(*carrier, finishOf(surface.coat));
    state = carrier->getOrCreateStateSet();
    state->setTextureAttributeAndModes(0, textureOf(surface.painting, isFoliage));
    if (isFoliage)
        state->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GREATER,
                                                       static_cast<float>(models::kAlphaThreshold) / 255.0F));
    else
    {
        state->getUniform("objectTintMask")->set(1.0F);
        state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    }
    return state;
}

std::vector<osg::ref_ptr<osg::StateSet>> ModelStates::statesOf(const models::Model& model)
{
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    for (const models::Surface& surface : model.surfaces)
        states.push_back(stateOf(surface));
    return states;
}

osg::ref_ptr<osg::Group> makeModelNode(const models::Model& model, ModelStates& states)
{
    return osgPMObjects::exportNode(model.mesh, states.statesOf(model));
}

} // namespace scenery
