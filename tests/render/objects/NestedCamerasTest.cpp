// SPDX-License-Identifier: Apache-2.0
// Cameras below the main one, while the object they see is blended from one level to another.
#include <osg/LightSource>

#include <osgOffscreen/ImageComparison>

#include "SwitchedAmongOthers.h"

namespace
{

using namespace switched;
using core::SwitchMethod;

constexpr int kWidthPx = 320, kHeightPx = 240, kFrames = 33;
const osg::Vec4 kSky{0.35F, 0.45F, 0.6F, 1.0F};
const osg::Vec3d kOtherSide{-0.8, -0.7, 0.9};

/// The switching object among others with a lamp, and possibly a camera that renders them into an image of
/// its own before the main one.
struct Studio
{
    Studio() : lit(new osg::Group), all(new osg::Group)
    {
        const osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
        lamp->getLight()->setPosition({0.3F, -0.7F, 0.6F, 0.0F});
        lit->addChild(lamp);
        lit->addChild(scene.all);
        all->addChild(lit);
        EXPECT_TRUE(scene.node->setSelection(always(finerSteps())));
    }

    /// Looks from the front. The nested camera has its own position, which for `isRelative` follows from that
    /// of the main camera.
    void open(bool hasNested, bool isRelative = false, const osg::Vec3d& from = kFrom, bool isFirst = false)
    {
        stage = Stage::of(*all, 1, kWidthPx, kHeightPx);
        stage->turnOffHeadlight();
        const osg::BoundingSphere ball = scene.node->drawable()->getBound();
        stage->lookAt(ball, 1.0, kOtherSide);
        const osg::Matrixd aside = stage->camera().getViewMatrix();
        stage->lookAt(ball, 1.0, from);
        if (!hasNested) return;
        const osg::Matrixd front = stage->camera().getViewMatrix();
        nested->setReferenceFrame(isRelative ? osg::Camera::RELATIVE_RF : osg::Camera::ABSOLUTE_RF);
        // OSG multiplies a relative camera's matrix before that of the camera above it.
        nested->setViewMatrix(isRelative ? aside * osg::Matrixd::inverse(front) : aside);
        nested->setProjectionMatrix(isRelative ? osg::Matrixd() : stage->camera().getProjectionMatrix());
        nested->setRenderOrder(osg::Camera::PRE_RENDER);
        nested->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        nested->setViewport(0, 0, kWidthPx, kHeightPx);
        nested->setClearColor(kSky);
        nested->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        nested->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        image->allocateImage(kWidthPx, kHeightPx, 1, GL_RGB, GL_UNSIGNED_BYTE);
        nested->attach(osg::Camera::COLOR_BUFFER, image);
        nested->addChild(lit);
        all->insertChild(isFirst ? 0 : 1, nested);
    }

    /// Renders one frame: the main image and that of the nested camera.
    std::pair<Picture, Picture> next()
    {
        const Picture main = stage->after(kFrameS);
        return {main, new osg::Image(*image, osg::CopyOp::DEEP_COPY_ALL)};
    }

    void beginSwitch() { EXPECT_TRUE(scene.node->setSelection(always(coarserSteps()))); }

    Scene scene{by(SwitchMethod::blend)};
    osg::ref_ptr<osg::Group> lit, all;
    osg::ref_ptr<osg::Camera> nested = new osg::Camera;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    std::unique_ptr<Stage> stage;
};

/// Renders what one camera alone sees of the same blend; the first image is that before it.
std::vector<Picture> alone(const osg::Vec3d& from)
{
    Studio studio;
    studio.open(false, false, from);
    std::vector<Picture> pictures{studio.next().first};
    studio.beginSwitch();
    for (int frame = 0; frame < kFrames; ++frame)
        pictures.push_back(studio.next().first);
    return pictures;
}

int differing(const Picture& a, const Picture& b)
{
    const auto difference = osgOffscreen::compareImages(*a, *b);
    return difference.sameShape ? static_cast<int>(difference.differingPixels) : kWidthPx * kHeightPx;
}

/// The matrix of a relative camera is a product, which rounds.
constexpr int kRoundedPixels = 16;

const std::vector<Picture>& front()
{
    static const std::vector<Picture> pictures = alone(kFrom);
    return pictures;
}

const std::vector<Picture>& aside()
{
    static const std::vector<Picture> pictures = alone(kOtherSide);
    return pictures;
}

/// An absolute camera is an eye of its own, and a relative one shows the levels of the main camera; each has
/// the image that it would have alone.
class NestedCameras : public testing::TestWithParam<bool>
{
};

TEST_P(NestedCameras, HaveTheirPicturesOfABlendAndLeaveTheMainOneIts)
{
    Studio studio;
    studio.open(true, GetParam());
    studio.next();
    studio.beginSwitch();
    for (int frame = 1; frame <= kFrames; ++frame)
    {
        const auto [main, nested] = studio.next();
        EXPECT_EQ(differing(main, front()[frame]), 0) << frame;
        EXPECT_LE(differing(nested, aside()[frame]), GetParam() ? kRoundedPixels : 0) << frame;
        if (frame == 18) keep(*main, "nested-main");
        if (frame == 18) keep(*nested, "nested");
    }
    // A frame too early or too late would be found, and so would the image of the other camera.
    EXPECT_GT(differing(aside()[18], aside()[17]), 500);
    EXPECT_GT(differing(aside()[18], front()[18]), 500);
}

INSTANTIATE_TEST_SUITE_P(Frames, NestedCameras, testing::Bool(),
                         [](const auto& p) { return p.param ? "Relative" : "Absolute"; });

/// A camera that joins late finds its own level at once; the main camera's switch goes on.
TEST(NestedCamerasThatComeLate, HaveNoPartInTheSwitchOfAnotherEye)
{
    for (const bool isRelative : {false, true})
    {
        Studio studio;
        studio.open(true, isRelative);
        studio.nested->setNodeMask(0);
        studio.next();
        studio.beginSwitch();
        for (int frame = 1; frame <= 12; ++frame)
            studio.next();
        studio.nested->setNodeMask(~0U);
        const auto [main, nested] = studio.next();
        EXPECT_EQ(differing(main, front()[13]), 0);
        const Picture& atRest = aside().back();
        // The control: a relative camera shares the switch of the main camera and shows it half done.
        if (isRelative)
            EXPECT_LE(differing(nested, aside()[13]), kRoundedPixels);
        else
            EXPECT_EQ(differing(nested, atRest), 0);
        EXPECT_GT(differing(aside()[13], atRest), 500);
    }
}

/// A camera that comes first in the scene is culled before the main camera chooses, and shows the frame
/// before.
TEST(NestedCamerasThatComeFirst, AreAFrameBehindTheMainOnesLevels)
{
    Studio studio;
    studio.open(true, true, kFrom, true);
    studio.next();
    studio.beginSwitch();
    for (int frame = 1; frame <= kFrames; ++frame)
    {
        const auto [main, nested] = studio.next();
        EXPECT_EQ(differing(main, front()[frame]), 0) << frame;
        EXPECT_LE(differing(nested, aside()[frame - 1]), kRoundedPixels) << frame;
    }
}

} // namespace
