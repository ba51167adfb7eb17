// SPDX-License-Identifier: Apache-2.0
#include "GrainTexture.h"

#include <cmath>
#include <cstdint>

#include <foundation/Random.h>
#include <glm/common.hpp>

#include <osg/Image>

namespace osgRoads
{

namespace
{

constexpr int kSide = 256;

/// A number in [0, 1) for each node of a grid.
double nodeValue(int x, int y, int cells, std::uint64_t seed)
{
    const auto wrapped = [cells](int i) { return static_cast<std::uint64_t>((i % cells + cells) % cells); };
    const std::uint64_t bits = foundation::mixedBits((wrapped(x) * foundation::SplitMix64::kStep) ^
                                                     (wrapped(y) * 0xd1b54a32d192ed03ULL) ^ seed);
    return static_cast<double>(bits >> 40U) / 16777216.0;
}

/// Value noise of so many cells along each side, smooth between the nodes.
double noiseAt(int column, int row, int cells, std::uint64_t seed)
{
    const double x = static_cast<double>(column) * cells / kSide,
                 y = static_cast<double>(row) * cells / kSide;
    const int left = static_cast<int>(std::floor(x)), low = static_cast<int>(std::floor(y));
    const double u = glm::smoothstep(0.0, 1.0, x - left), v = glm::smoothstep(0.0, 1.0, y - low);
    const auto at = [&](int i, int j) { return nodeValue(i, j, cells, seed); };
    return (1.0 - v) * ((1.0 - u) * at(left, low) + u * at(left + 1, low)) +
           v * ((1.0 - u) * at(left, low + 1) + u * at(left + 1, low + 1));
}

unsigned char byteOf(double value)
{
    return static_cast<unsigned char>(std::lround(255.0 * value));
}

} // namespace

osg::ref_ptr<osg::Texture2D> makeGrainTexture()
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kSide, kSide, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
        {
            unsigned char* texel = image->data(column, row);
            texel[0] = byteOf(noiseAt(column, row, kSide, 1));
            texel[1] = byteOf(0.65 * noiseAt(column, row, 16, 2) + 0.35 * noiseAt(column, row, 37, 3));
            texel[2] = byteOf(0.6 * noiseAt(column, row, 4, 4) + 0.4 * noiseAt(column, row, 9, 5));
            texel[3] = 255;
        }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    return texture;
}

} // namespace osgRoads
