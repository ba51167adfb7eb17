// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include <osgOffscreen/ImageComparison>
#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/ProcessorDrawing>

#include "RenderedPicture.h"

using osgOffscreen::Backend;
using osgOffscreen::compareImages;
using osgOffscreen::OffscreenContext;
using osgOffscreen::OffscreenSettings;
using rendered::backends;
using rendered::pictureOf;

namespace
{

OffscreenSettings oddSettings(Backend backend, int samples = 0)
{
    OffscreenSettings settings;
    settings.backend = backend;
    settings.widthPx = 317; // odd, to detect padded rows
    settings.heightPx = 203;
    settings.samples = samples;
    return settings;
}

std::size_t coloursIn(const osg::Image& picture)
{
    std::set<unsigned> colours;
    for (unsigned i = 0; i + 2 < picture.getTotalSizeInBytes(); i += 3)
        colours.insert(picture.data()[i] * 65536U + picture.data()[i + 1] * 256U + picture.data()[i + 2]);
    return colours.size();
}

} // namespace

TEST(OffscreenContext, DrawsAScene)
{
    for (const Backend backend : backends())
    {
        const auto picture = pictureOf({}, oddSettings(backend));
        ASSERT_NE(picture, nullptr);
        EXPECT_EQ(picture->s(), 317);
        EXPECT_EQ(picture->t(), 203);
        EXPECT_GT(coloursIn(*picture), 1000U) << "nothing much was drawn by " << backendName(backend);
    }
}

TEST(OffscreenContext, BackendsDrawTheSameBytes)
{
    if (backends().size() < 2) GTEST_SKIP() << "this build has one backend only";
    for (const int samples : {0, 4})
    {
        const auto a = pictureOf({}, oddSettings(Backend::osmesa, samples));
        const auto b = pictureOf({}, oddSettings(Backend::egl, samples));
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(compareImages(*a, *b).identical())
            << compareImages(*a, *b).message() << " with " << samples << " samples";
    }
}

TEST(OffscreenContext, TwoRunsDrawTheSameBytes)
{
    for (const Backend backend : backends())
    {
        const auto a = pictureOf({}, oddSettings(backend));
        const auto b = pictureOf({}, oddSettings(backend));
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(compareImages(*a, *b).identical()) << compareImages(*a, *b).message();
    }
}

TEST(OffscreenContext, SeededBugsAreSeenByTheComparison)
{
    const OffscreenSettings settings = oddSettings(osgOffscreen::defaultBackend());
    const auto right = pictureOf({}, settings);
    ASSERT_NE(right, nullptr);
    rendered::SceneOptions moved;
    moved.triangleShiftM = 0.02F;
    rendered::SceneOptions foggy;
    foggy.fogFactor = 1.2F;
    rendered::SceneOptions missing;
    missing.withSphere = false;
    for (const rendered::SceneOptions& bug : {moved, foggy, missing})
    {
        const auto wrong = pictureOf(bug, settings);
        ASSERT_NE(wrong, nullptr);
        const auto difference = compareImages(*right, *wrong);
        EXPECT_FALSE(difference.within(16, 1)) << difference.message();
        EXPECT_GT(difference.differingPixels, 16U);
    }
}

TEST(OffscreenContext, MultisamplingSmoothsEdges)
{
    const auto plain = pictureOf({}, oddSettings(osgOffscreen::defaultBackend()));
    const auto smooth = pictureOf({}, oddSettings(osgOffscreen::defaultBackend(), 4));
    ASSERT_TRUE(plain && smooth);
    const auto difference = compareImages(*plain, *smooth);
    EXPECT_GT(difference.differingPixels, 100U);
    EXPECT_LT(difference.differingPixels, 317U * 203U / 4) << "only edges may change";
}

TEST(OffscreenContext, ThreadingModelsDrawTheSameBytes)
{
    for (const Backend backend : backends())
    {
        const auto expected = pictureOf({}, oddSettings(backend));
        for (const auto model :
             {osgViewer::Viewer::CullDrawThreadPerContext, osgViewer::Viewer::DrawThreadPerContext,
              osgViewer::Viewer::CullThreadPerCameraDrawThreadPerContext})
        {
            const auto viewer = rendered::viewerOf(rendered::smallScene(), oddSettings(backend));
            ASSERT_NE(viewer, nullptr);
            std::vector<osg::ref_ptr<osg::Image>> pictures;
            const osg::ref_ptr<osgOffscreen::FrameGrabber> grabber = new osgOffscreen::FrameGrabber(
                [&](const osgOffscreen::GrabbedFrame& frame) { pictures.push_back(frame.picture); });
            viewer->context().setSwapCallback(grabber);
            viewer->viewer().setThreadingModel(model);
            for (int i = 0; i < 6; ++i) // the last may be dropped
                viewer->frame(i);
            viewer->viewer().stopThreading();
            viewer->context().setSwapCallback(nullptr);
            grabber->drain(&viewer->context());
            ASSERT_GE(pictures.size(), 5U) << "threading model " << model;
            for (const auto& picture : pictures)
                EXPECT_TRUE(compareImages(*expected, *picture).identical()) << "threading model " << model;
        }
    }
}

TEST(OffscreenContext, CamerasShareOnePictureByTheirViewports)
{
    const auto viewer =
        rendered::viewerOf(rendered::smallScene(), oddSettings(osgOffscreen::defaultBackend()));
    ASSERT_NE(viewer, nullptr);
    viewer->camera().setViewport(0, 0, 158, 203);
    const osg::ref_ptr<osg::Camera> right = new osg::Camera;
    right->setGraphicsContext(&viewer->context());
    right->setViewport(159, 0, 158, 203);
    right->setClearColor({1.0F, 0.0F, 0.0F, 1.0F});
    viewer->viewer().addSlave(right, osg::Matrixd(), osg::Matrixd::rotate(osg::PI, 0.0, 1.0, 0.0));
    const auto picture = viewer->picture();
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(picture->data(316, 202)[1], 0)
        << "the right camera looks away from the scene: its own clear colour";
    EXPECT_GT(picture->data(0, 202)[1], 100) << "the left camera's sky";
}

TEST(OffscreenContext, ImpossibleRequestsAreErrors)
{
    for (const Backend backend : backends())
    {
        OffscreenSettings wide = oddSettings(backend);
        wide.widthPx = 10'000'000;
        const auto tooWide = OffscreenContext::create(wide);
        ASSERT_FALSE(tooWide);
        EXPECT_NE(tooWide.error().what.find("10000000"), std::string::npos);
        OffscreenSettings fine = oddSettings(backend, 4096);
        EXPECT_FALSE(OffscreenContext::create(fine));
        OffscreenSettings empty = oddSettings(backend);
        empty.heightPx = 0;
        EXPECT_FALSE(OffscreenContext::create(empty));
    }
}

TEST(Backend, IsNamedAndParsed)
{
    for (const Backend backend : backends())
    {
        const auto parsed = osgOffscreen::parseBackend(backendName(backend));
        ASSERT_TRUE(parsed);
        EXPECT_EQ(*parsed, backend);
    }
    const auto wrong = osgOffscreen::parseBackend("glx");
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message().find("glx"), std::string::npos);
}

TEST(OffscreenContext, HasPixelsInPlaceOfSamplesWhereTheProcessorDrawsAndSomebodyAsks)
{
    for (const Backend backend : backends())
    {
        OffscreenSettings settings = oddSettings(backend, 4);
        const auto sideOf = [&]
        {
            const auto made = OffscreenContext::create(settings);
            if (!made) ADD_FAILURE() << made.error().message();
            return made ? (*made)->drawnSide() : 0;
        };
        EXPECT_EQ(sideOf(), 1) << "nobody asked";
        settings.sampling = osgOffscreen::FrameBuffer::Sampling::cheapest;
        const auto made = OffscreenContext::create(settings);
        ASSERT_TRUE(made);
        const bool isProcessor = osgOffscreen::drawsOnProcessor((*made)->rendererName());
        EXPECT_EQ((*made)->drawnSide(), isProcessor ? 2 : 1) << (*made)->rendererName();
        settings.samples = 1;
        EXPECT_EQ(sideOf(), 1) << "one sample";
    }
    EXPECT_EQ(osgOffscreen::pixelsInPlaceOf(4, "NVIDIA H200"), 1);
}
