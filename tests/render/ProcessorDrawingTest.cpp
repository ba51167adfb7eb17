// SPDX-License-Identifier: Apache-2.0
// Anisotropic filtering is left out where a driver draws on the processor: a frame of a town took minutes
// with it.
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Texture2D>

#include <osgOffscreen/ImageComparison>
#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/ProcessorDrawing>

#include "RenderedPicture.h"

using osgOffscreen::OffscreenSettings;

namespace
{

osg::ref_ptr<osg::Image> chequers(int sidePx)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(sidePx, sidePx, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    for (int y = 0; y < sidePx; ++y)
        for (int x = 0; x < sidePx; ++x)
            *image->data(x, y) = ((x / 4 + y / 4) & 1) != 0 ? 255 : 0;
    return image;
}

/// A chequered floor up to the horizon, seen from 2 m above it.
osg::ref_ptr<osg::Node> floorWith(float anisotropy)
{
    osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(
        {-500.0F, -20.0F, 0.0F}, {1000.0F, 0.0F, 0.0F}, {0.0F, 1000.0F, 0.0F}, 0.0F, 0.0F, 500.0F, 500.0F);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(chequers(64));
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    texture->setMaxAnisotropy(anisotropy);
    quad->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    quad->getStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(quad);
    return geode;
}

/// The floor; `filtersAnyway` takes back what the context left out.
osg::ref_ptr<osg::Image> pictureOfFloor(float anisotropy, bool filtersAnyway = false)
{
    OffscreenSettings settings;
    settings.widthPx = 160;
    settings.heightPx = 90;
    const auto viewer = rendered::viewerOf(floorWith(anisotropy), settings);
    if (!viewer) return nullptr;
    if (!osgOffscreen::drawsOnProcessor(viewer->context().rendererName())) return nullptr;
    if (filtersAnyway)
        osg::GLExtensions::Get(viewer->context().getState()->getContextID(), true)
            ->isTextureFilterAnisotropicSupported = true;
    return viewer->picture();
}

} // namespace

TEST(ProcessorDrawing, KnowsMesasDriversWithoutAGpu)
{
    EXPECT_TRUE(osgOffscreen::drawsOnProcessor("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_TRUE(osgOffscreen::drawsOnProcessor("softpipe"));
    EXPECT_FALSE(osgOffscreen::drawsOnProcessor("NVIDIA GeForce RTX 3060/PCIe/SSE2"));
    EXPECT_FALSE(osgOffscreen::drawsOnProcessor("Mesa Intel(R) UHD Graphics 630 (CFL GT2)"));
}

TEST(ProcessorDrawing, SparesTheProcessorAnisotropicFilters)
{
    const auto plain = pictureOfFloor(1.0F);
    const auto spared = pictureOfFloor(16.0F);
    if (!plain) GTEST_SKIP() << "this machine draws with a GPU";
    ASSERT_TRUE(spared);
    EXPECT_TRUE(osgOffscreen::compareImages(*plain, *spared).identical());
    const auto filtered = pictureOfFloor(16.0F, true);
    ASSERT_TRUE(filtered);
    EXPECT_FALSE(osgOffscreen::compareImages(*plain, *filtered).identical()) << "the control drew the same";
}
