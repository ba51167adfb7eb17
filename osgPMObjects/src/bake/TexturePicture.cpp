// SPDX-License-Identifier: Apache-2.0
#include "TexturePicture.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include <osg/Image>

namespace osgPMObjects
{

TexturePicture::TexturePicture(const osg::Texture& texture)
    : _wrapS(wrapOf(texture.getWrap(osg::Texture::WRAP_S))),
      _wrapT(wrapOf(texture.getWrap(osg::Texture::WRAP_T))),
      _isNearest(texture.getFilter(osg::Texture::MAG_FILTER) == osg::Texture::NEAREST)
{
    const osg::Image* image = texture.getNumImages() > 0 ? texture.getImage(0) : nullptr;
    if (!image || !image->data() || image->isCompressed() || image->s() < 1 || image->t() < 1) return;
    _width = image->s();
    _height = image->t();
    _texels.reserve(static_cast<std::size_t>(_width) * static_cast<std::size_t>(_height));
    for (int t = 0; t < _height; ++t)
        for (int s = 0; s < _width; ++s)
        {
            const osg::Vec4 colour = image->getColor(static_cast<unsigned>(s), static_cast<unsigned>(t));
            auto& texel = _texels.emplace_back();
            for (unsigned c = 0; c < 4; ++c)
                texel[c] = static_cast<std::uint8_t>(
                    std::lround(255.0f * std::clamp(colour[static_cast<int>(c)], 0.0f, 1.0f)));
        }
}

TexturePicture::Wrap TexturePicture::wrapOf(osg::Texture::WrapMode mode)
{
    if (mode == osg::Texture::REPEAT) return Wrap::repeat;
    return mode == osg::Texture::MIRROR ? Wrap::mirror : Wrap::clamp;
}

int TexturePicture::wrapped(int texel, int count, Wrap wrap)
{
    if (wrap == Wrap::clamp) return std::clamp(texel, 0, count - 1);
    const int period = wrap == Wrap::mirror ? 2 * count : count;
    const int within = (texel % period + period) % period;
    return within < count ? within : period - 1 - within;
}

glm::vec4 TexturePicture::texel(int s, int t) const
{
    const auto& c =
        _texels[static_cast<std::size_t>(wrapped(t, _height, _wrapT)) * static_cast<std::size_t>(_width) +
                static_cast<std::size_t>(wrapped(s, _width, _wrapS))];
    return glm::vec4(c[0], c[1], c[2], c[3]) / 255.0f;
}

glm::vec4 TexturePicture::at(const glm::dvec2& place) const
{
    if (!isRead()) return glm::vec4(1.0f);
    // A broken texture coordinate, too large to count, reads the first texel.
    constexpr double kFarthest = 1e9; // texels
    const bool isSane = std::abs(place.x) * _width < kFarthest && std::abs(place.y) * _height < kFarthest;
    const glm::dvec2 p = isSane ? place * glm::dvec2(_width, _height) : glm::dvec2(0.0);
    if (_isNearest) return texel(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)));
    const glm::dvec2 low = glm::floor(p - 0.5);
    const glm::vec2 part(p - 0.5 - low);
    const int s = static_cast<int>(low.x), t = static_cast<int>(low.y);
    return glm::mix(glm::mix(texel(s, t), texel(s + 1, t), part.x),
                    glm::mix(texel(s, t + 1), texel(s + 1, t + 1), part.x), part.y);
}

} // namespace osgPMObjects
