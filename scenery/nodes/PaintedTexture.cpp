// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/PaintedTexture.h"

#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

#include <foundation/KeptResults.h>

#include <osg/Image>
#include <osg/observer_ptr>

#include "scenery/models/paint/MipChain.h"
#include "scenery/models/vehicles/VehicleLook.h"
#include "scenery/nodes/KeptPaintings.h"

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

osg::ref_ptr<osg::Texture2D> makeTexture(models::Painting painting, bool isFoliage, float anisotropy,
                                         const models::VehicleLook* look)
{
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(
        imageOf(paintedChain(painting, isFoliage, foundation::KeptResults::ofUser(), look)));
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    const auto wrap = isFoliage ? osg::Texture::CLAMP_TO_EDGE : osg::Texture::REPEAT;
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    texture->setMaxAnisotropy(anisotropy);
    texture->setUseHardwareMipMapGeneration(false);
    return texture;
}

/// A texture that may have gone. Its mutex lets others wait for this one alone while it is made.
struct Shared
{
    std::mutex mutex;
    osg::observer_ptr<osg::Texture2D> texture;
};

Shared& sharedOf(models::Painting painting, bool isFoliage, float anisotropy, const models::VehicleLook* look)
{
    static std::mutex mutex;
    static std::map<std::tuple<models::Painting, bool, float, std::string>, Shared> all;
    const std::lock_guard lock(mutex);
    return all[{painting, isFoliage, anisotropy, look ? look->mark.text() : std::string()}];
}

} // namespace

osg::ref_ptr<osg::Texture2D> paintedTexture(models::Painting painting, bool isFoliage, float anisotropy,
                                            const models::VehicleLook* look)
{
    Shared& shared = sharedOf(painting, isFoliage, anisotropy, look);
    const std::lock_guard lock(shared.mutex);
    osg::ref_ptr<osg::Texture2D> texture;
    if (!shared.texture.lock(texture))
    {
        texture = makeTexture(painting, isFoliage, anisotropy, look);
        shared.texture = texture;
    }
    return texture;
}

} // namespace scenery
