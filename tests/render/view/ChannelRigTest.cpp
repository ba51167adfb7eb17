// SPDX-License-Identifier: Apache-2.0
#include "view/ChannelRig.h"

#include <gtest/gtest.h>

#include <osgViewer/Viewer>

#include <osgOffscreen/FrameGrabber>
#include <osgOffscreen/ImageComparison>

#include "RenderedDefaultCar.h"
#include "RenderedView.h"

using osgOffscreen::compareImages;
using trainer::ViewSetup;

namespace
{

/// Two halves of one wide picture: off-axis channels that meet in the middle, and one that shows it all.
ViewSetup halves(ViewSetup::Layout layout)
{
    const trainer::FrustumAngles whole = trainer::symmetricFrustumY(40.0, 320, 160);
    ViewSetup setup;
    setup.layout = layout;
    for (const bool isLeft : {true, false})
    {
        trainer::Channel channel;
        channel.name = isLeft ? "left" : "right";
        channel.widthPx = 160;
        channel.heightPx = 160;
        channel.frustum = whole;
        (isLeft ? channel.frustum.rightDeg : channel.frustum.leftDeg) = 0.0;
        setup.channels.push_back(channel);
    }
    return setup;
}

/// How the pixels of a picture are drawn.
struct Drawing
{
    double side = 1.0; ///< the share of them along each side
    int samples = 1;
    bool isSpread = true;
    bool isCheapest = false; ///< pixels may be in place of samples
};

std::vector<osg::ref_ptr<osg::Image>> draw(osg::Node* scene, const ViewSetup& setup, const scenery::Pose& eye,
                                           const Drawing& drawing = {})
{
    std::vector<osg::ref_ptr<osg::GraphicsContext>> contexts;
    std::vector<osg::ref_ptr<osg::Image>> pictures(trainer::picturesOf(setup).size());
    for (const trainer::PictureShape& shape : trainer::picturesOf(setup))
    {
        osgOffscreen::OffscreenSettings settings;
        settings.widthPx = shape.widthPx;
        settings.heightPx = shape.heightPx;
        settings.samples = drawing.samples;
        if (drawing.isCheapest) settings.sampling = osgOffscreen::FrameBuffer::Sampling::cheapest;
        auto made = osgOffscreen::OffscreenContext::create(settings);
        if (!made) ADD_FAILURE() << made.error().message();
        const std::size_t index = contexts.size();
        (*made)->setSwapCallback(new osgOffscreen::FrameGrabber(
            [&pictures, index](const osgOffscreen::GrabbedFrame& frame) { pictures[index] = frame.picture; },
            0));
        contexts.push_back(*made);
    }
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.setSceneData(scene);
    trainer::ChannelRig rig(viewer, setup, contexts);
    rig.setDrawnSide(drawing.side);
    for (unsigned i = 0; !drawing.isSpread && i < viewer.getNumSlaves(); ++i)
        if (viewer.getSlave(i)._camera->getName() == "scaled picture")
            viewer.getSlave(i)._camera->setNodeMask(0);
    rig.setEye(eye);
    viewer.frame(0.0);
    for (const auto& context : contexts)
        context->setSwapCallback(nullptr);
    return pictures;
}

osg::ref_ptr<osg::Image> cut(const osg::Image& picture, unsigned leftPx, unsigned widthPx)
{
    osg::ref_ptr<osg::Image> part = new osg::Image;
    part->allocateImage(static_cast<int>(widthPx), picture.t(), 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    for (unsigned y = 0; y < static_cast<unsigned>(picture.t()); ++y)
        std::copy_n(picture.data(leftPx, y), 3 * widthPx, part->data(0, y));
    return part;
}

struct CarOnGround : rendered::ViewScene
{
    CarOnGround() { root->addChild(car.node()); }
    DefaultCar car;
    const scenery::Pose eye = scenery::poseLookingAt({-6.0, -5.0, 2.5}, {1.3, 0.4, 0.8});
};

} // namespace

TEST(ChannelRig, TiledAndSeparatePicturesAreTheSame)
{
    const CarOnGround scene;
    const auto tiled = draw(scene.root, halves(ViewSetup::Layout::tiled), scene.eye);
    const auto separate = draw(scene.root, halves(ViewSetup::Layout::separate), scene.eye);
    ASSERT_EQ(tiled.size(), 1U);
    ASSERT_EQ(separate.size(), 2U);
    ASSERT_EQ(tiled[0]->s(), 320);
    for (const unsigned i : {0U, 1U})
    {
        const auto difference = compareImages(*cut(*tiled[0], 160 * i, 160), *separate[i]);
        EXPECT_TRUE(difference.identical()) << difference.message();
    }
    EXPECT_FALSE(compareImages(*separate[0], *separate[1]).within(1000, 10)) << "they must not show the same";
}

TEST(ChannelRig, OffAxisHalvesJoinIntoTheWholePicture)
{
    const CarOnGround scene;
    const auto joined = draw(scene.root, halves(ViewSetup::Layout::tiled), scene.eye);
    const auto whole = draw(scene.root, trainer::singleChannel(320, 160, 40.0), scene.eye);
    // Other matrices, so other rounding: edges may move by a pixel here and there.
    const auto difference = compareImages(*joined[0], *whole[0]);
    EXPECT_LT(difference.differingPixels, 320U * 160U / 20) << difference.message();

    ViewSetup wrong = halves(ViewSetup::Layout::tiled);
    wrong.channels[1].yawDeg = 2.0;
    const auto askew = draw(scene.root, wrong, scene.eye);
    EXPECT_GT(compareImages(*askew[0], *whole[0]).differingPixels, 320U * 160U / 20)
        << "the bound sees a bent channel";
}

TEST(ChannelRig, PicturesDoNotDependOnHowFarFromTheOriginTheSceneLies)
{
    CarOnGround near;
    CarOnGround far;
    const glm::dvec3 away(40'000.0, -30'000.0, 1500.0);
    near.root->removeChild(1); // the ground stays where it is
    far.root->removeChild(1);
    simulation::EntityState state;
    state.position = away;
    far.car.setState(state);
    scenery::Pose eye = far.eye;
    eye.positionWorld += away;
    const auto a = draw(near.root, trainer::singleChannel(320, 160), near.eye);
    const auto b = draw(far.root, trainer::singleChannel(320, 160), eye);
    const auto difference = compareImages(*a[0], *b[0]);
    // The rounding of the matrices differs, by up to three levels of a shaded texture; a shift by a pixel
    // would be tens of levels.
    EXPECT_TRUE(difference.within(320U * 160U / 20, 3)) << difference.message();
    eye.positionWorld.y += 0.05;
    const auto shifted = draw(far.root, trainer::singleChannel(320, 160), eye);
    EXPECT_FALSE(compareImages(*a[0], *shifted[0]).within(320U * 160U / 20, 3))
        << "the bound sees five centimetres";
}

namespace
{

double meanLevels(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < 3 * a.s(); ++x)
            sum += std::abs(a.data(0, y)[x] - b.data(0, y)[x]);
    return sum / (3.0 * a.s() * a.t());
}

} // namespace

TEST(ChannelRig, FewerPixelsAreSpreadOverTheWholePicture)
{
    const CarOnGround scene;
    for (const int samples : {1, 4})
    {
        const ViewSetup setup = trainer::singleChannel(320, 160);
        const auto whole = draw(scene.root, setup, scene.eye, {.samples = samples});
        const auto fewer = draw(scene.root, setup, scene.eye, {.side = 0.75, .samples = samples});
        EXPECT_FALSE(compareImages(*whole[0], *fewer[0]).identical());
        EXPECT_LT(meanLevels(*whole[0], *fewer[0]), 2.0) << samples;
        const auto part = draw(scene.root, setup, scene.eye, {0.75, samples, false});
        EXPECT_GT(meanLevels(*whole[0], *part[0]), 6.0) << "the bound sees a picture that is not spread";
    }
}

TEST(ChannelRig, EachOfTiledPicturesIsSpreadInItsPlace)
{
    const CarOnGround scene;
    const auto tiled = draw(scene.root, halves(ViewSetup::Layout::tiled), scene.eye, {.side = 0.75});
    const auto separate = draw(scene.root, halves(ViewSetup::Layout::separate), scene.eye, {.side = 0.75});
    for (const unsigned i : {0U, 1U})
    {
        const auto difference = compareImages(*cut(*tiled[0], 160 * i, 160), *separate[i]);
        EXPECT_TRUE(difference.identical()) << difference.message();
    }
}

namespace
{

/// The means of squares of 2 x 2 pixels.
osg::ref_ptr<osg::Image> halved(const osg::Image& picture)
{
    osg::ref_ptr<osg::Image> half = new osg::Image;
    half->allocateImage(picture.s() / 2, picture.t() / 2, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    for (int y = 0; y < half->t(); ++y)
        for (int x = 0; x < 3 * half->s(); ++x)
        {
            int sum = 2; // rounds
            for (const int row : {2 * y, 2 * y + 1})
                for (const int column : {2 * (x / 3), 2 * (x / 3) + 1})
                    sum += picture.data(0, row)[3 * column + x % 3];
            half->data(0, y)[x] = static_cast<unsigned char>(sum / 4);
        }
    return half;
}

} // namespace

TEST(ChannelRig, FourPixelsInPlaceOfSamplesAreShownAsTheirMean)
{
    const CarOnGround scene;
    const auto large = draw(scene.root, trainer::singleChannel(320, 160), scene.eye);
    const Drawing drawing{.side = 2.0, .samples = 4, .isCheapest = true};
    const auto shown = draw(scene.root, trainer::singleChannel(160, 80), scene.eye, drawing);
    ASSERT_EQ(shown[0]->s(), 160);
    const auto difference = compareImages(*halved(*large[0]), *shown[0]);
    EXPECT_TRUE(difference.within(160U * 80U, 1)) << difference.message();
    const auto plain = draw(scene.root, trainer::singleChannel(160, 80), scene.eye);
    EXPECT_FALSE(compareImages(*halved(*large[0]), *plain[0]).within(160U * 80U, 1))
        << "the bound sees edges";
}

TEST(ChannelRig, EachOfTiledPicturesHasItsOwnPixelsInPlaceOfSamples)
{
    const CarOnGround scene;
    const Drawing drawing{.side = 2.0, .samples = 4, .isCheapest = true};
    const auto tiled = draw(scene.root, halves(ViewSetup::Layout::tiled), scene.eye, drawing);
    const auto separate = draw(scene.root, halves(ViewSetup::Layout::separate), scene.eye, drawing);
    for (const unsigned i : {0U, 1U})
    {
        const auto difference = compareImages(*cut(*tiled[0], 160 * i, 160), *separate[i]);
        EXPECT_TRUE(difference.identical()) << difference.message();
    }
}
