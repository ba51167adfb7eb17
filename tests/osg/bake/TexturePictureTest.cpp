// SPDX-License-Identifier: Apache-2.0
#include "bake/TexturePicture.h"

#include <limits>

#include <gtest/gtest.h>

#include <osg/Image>
#include <osg/Texture2D>

namespace
{

using osgPMObjects::TexturePicture;

/// A texture of four texels: red and green below, blue and white above.
osg::ref_ptr<osg::Texture2D> fourTexels(osg::Texture::WrapMode wrap, osg::Texture::FilterMode filter)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
    const unsigned char texels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
    for (int i = 0; i < 4; ++i)
        std::copy_n(texels + 3 * i, 3, image->data(i % 2, i / 2));
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    texture->setFilter(osg::Texture::MAG_FILTER, filter);
    return texture;
}

const glm::vec4 kRed(1, 0, 0, 1), kGreen(0, 1, 0, 1), kBlue(0, 0, 1, 1);

TEST(TexturePicture, RepeatsMirrorsAndClampsAsItsTexture)
{
    const auto nearest = osg::Texture::NEAREST;
    const TexturePicture repeated(*fourTexels(osg::Texture::REPEAT, nearest));
    EXPECT_EQ(repeated.at({0.25, 0.25}), kRed);
    EXPECT_EQ(repeated.at({0.75, 0.25}), kGreen);
    EXPECT_EQ(repeated.at({0.25, 0.75}), kBlue);
    EXPECT_EQ(repeated.at({5.25, -2.75}), kRed);
    EXPECT_EQ(repeated.at({-0.25, 0.25}), kGreen);
    const TexturePicture mirrored(*fourTexels(osg::Texture::MIRROR, nearest));
    EXPECT_EQ(mirrored.at({1.25, 0.25}), kGreen);
    EXPECT_EQ(mirrored.at({-0.25, 0.25}), kRed);
    EXPECT_EQ(mirrored.at({2.25, 0.25}), kRed);
    const TexturePicture clamped(*fourTexels(osg::Texture::CLAMP_TO_EDGE, nearest));
    EXPECT_EQ(clamped.at({7.0, 0.25}), kGreen);
    EXPECT_EQ(clamped.at({-7.0, 0.25}), kRed);
}

TEST(TexturePicture, LooksBetweenTexelsAsOpenGlDoes)
{
    const TexturePicture clamped(*fourTexels(osg::Texture::CLAMP_TO_EDGE, osg::Texture::LINEAR));
    EXPECT_EQ(clamped.at({0.5, 0.25}), glm::vec4(0.5f, 0.5f, 0.0f, 1.0f));
    EXPECT_EQ(clamped.at({0.5, 0.5}), glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
    EXPECT_EQ(clamped.at({0.1, 0.1}), kRed);
    const TexturePicture repeated(*fourTexels(osg::Texture::REPEAT, osg::Texture::LINEAR));
    EXPECT_EQ(repeated.at({0.0, 0.25}), glm::vec4(0.5f, 0.5f, 0.0f, 1.0f));
}

TEST(TexturePicture, OfWhatCannotBeReadIsWhite)
{
    osg::ref_ptr<osg::Texture2D> empty = new osg::Texture2D;
    EXPECT_FALSE(TexturePicture(*empty).isRead());
    EXPECT_EQ(TexturePicture(*empty).at({0.5, 0.5}), glm::vec4(1.0f));
    osg::ref_ptr<osg::Image> compressed = new osg::Image;
    compressed->allocateImage(4, 4, 1, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_UNSIGNED_BYTE);
    const osg::ref_ptr<osg::Texture2D> packed = new osg::Texture2D(compressed);
    EXPECT_FALSE(TexturePicture(*packed).isRead());
}

TEST(TexturePicture, TextureCoordinatesBeyondAllCountingAreHarmless)
{
    const TexturePicture picture(*fourTexels(osg::Texture::REPEAT, osg::Texture::LINEAR));
    for (const double x : {1e300, -1e300, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_TRUE(std::isfinite(picture.at({x, x}).r));
}

} // namespace
