// SPDX-License-Identifier: Apache-2.0
#include "ImageBytes.h"

#include <array>
#include <cstdint>
#include <cstring>

#include <foundation/PlainBytes.h>
#include <foundation/ZeroRuns.h>

namespace osgTerrainROAM
{

namespace
{

/// Width, height, depth, internal format, format and type of texels.
using ImageShape = std::array<std::int32_t, 6>;

constexpr std::int32_t kMostSide = 16384;
constexpr std::uint64_t kMostImageBits = std::uint64_t{1} << 33; ///< OSG counts bytes by 32 bits

bool isShape(const ImageShape& shape)
{
    std::uint64_t texels = 1;
    for (std::size_t i = 0; i < 3; ++i)
    {
        if (shape[i] < 1 || shape[i] > kMostSide) return false;
        texels *= static_cast<std::uint64_t>(shape[i]);
    }
    const unsigned int bits =
        osg::Image::computePixelSizeInBits(static_cast<GLenum>(shape[4]), static_cast<GLenum>(shape[5]));
    return bits > 0 && texels <= kMostImageBits / bits;
}

} // namespace

std::string bytesOf(const osg::Image& image)
{
    std::string bytes;
    foundation::appendValue(bytes,
                            ImageShape{image.s(), image.t(), image.r(), image.getInternalTextureFormat(),
                                       static_cast<std::int32_t>(image.getPixelFormat()),
                                       static_cast<std::int32_t>(image.getDataType())});
    foundation::appendZeroRuns(bytes, {reinterpret_cast<const char*>(image.data()),
                                       image.getTotalSizeInBytes()}); // maps of features are mostly 0
    return bytes;
}

std::optional<osg::ref_ptr<osg::Image>> imageIn(std::string_view bytes)
{
    ImageShape shape{};
    if (!foundation::ValueTaker(bytes).take(shape) || !isShape(shape)) return std::nullopt;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(shape[0], shape[1], shape[2], static_cast<GLenum>(shape[4]),
                         static_cast<GLenum>(shape[5]));
    if (!image->data()) return std::nullopt;
    image->setInternalTextureFormat(shape[3]);
    if (!foundation::readZeroRuns(bytes.substr(sizeof shape), reinterpret_cast<char*>(image->data()),
                                  image->getTotalSizeInBytes()))
        return std::nullopt;
    return image;
}

} // namespace osgTerrainROAM
