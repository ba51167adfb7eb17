// SPDX-License-Identifier: Apache-2.0
#include "RowTexture.h"

#include <algorithm>
#include <cstring>

#include <osg/Image>

namespace osgRoads
{

namespace
{

constexpr int kRowsInLine = 256, kTexelsOfRow = 4, kMostLines = 16384;
static_assert(sizeof(FloatRow) == kTexelsOfRow * 4 * sizeof(float));

} // namespace

osg::ref_ptr<osg::Texture2D> makeRowTexture(const std::vector<FloatRow>& rows)
{
    const std::size_t most = static_cast<std::size_t>(kRowsInLine) * kMostLines;
    const std::size_t count = std::min(rows.size(), most);
    const int lines = std::max(1, static_cast<int>((count + kRowsInLine - 1) / kRowsInLine));
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kRowsInLine * kTexelsOfRow, lines, 1, GL_RGBA, GL_FLOAT);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    if (count > 0) std::memcpy(image->data(), rows.data(), count * sizeof(FloatRow));
    image->setInternalTextureFormat(GL_RGBA32F_ARB);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setInternalFormat(GL_RGBA32F_ARB);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

} // namespace osgRoads
