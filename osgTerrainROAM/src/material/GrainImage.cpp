// SPDX-License-Identifier: Apache-2.0
#include "GrainImage.h"

#include <algorithm>
#include <cmath>

#include "TileableNoise.h"

namespace osgTerrainROAM
{

namespace
{

constexpr int kSide = 512;

unsigned char byteOf(float value)
{
    return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

} // namespace

osg::ref_ptr<osg::Image> grainImage()
{
    const TileableNoise bumps(kSide, {12, 5, 0.62, 11});
    const TileableNoise speckle(kSide, {24, 4, 0.85, 23});
    const TileableNoise patches(kSide, {10, 5, 0.62, 37});
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kSide, kSide, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(GL_RGBA8);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
        {
            unsigned char* out = image->data(x, y);
            out[0] = byteOf(0.5f + 3.0f * (bumps.at(x + 1, y) - bumps.at(x - 1, y)));
            out[1] = byteOf(0.5f + 3.0f * (bumps.at(x, y + 1) - bumps.at(x, y - 1)));
            out[2] = byteOf(0.5f * (speckle.at(x, y) + bumps.at(x, y)) * 1.4f - 0.2f);
            out[3] = byteOf(patches.at(x, y));
        }
    return image;
}

} // namespace osgTerrainROAM
