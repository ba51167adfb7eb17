// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/MatrixTransform>

#include <osgTerrainROAM/RoamDrawable>

#include "HandCull.h"
#include "SyntheticField.h"

namespace
{

using handcull::cameraAt;
using handcull::cull;
using handcull::Culled;
using osgTerrainROAM::RoamDrawable;

/// 200×150 samples, 30 m apart; the data end inside the 257² tile.
osg::ref_ptr<RoamDrawable> drawableOf(double tolerancePx = 2.0)
{
    osg::ref_ptr<RoamDrawable> drawable =
        new RoamDrawable(testsupport::planarTile(testsupport::hills(200, 150)));
    EXPECT_TRUE(drawable->setErrorTolerancePx(tolerancePx));
    return drawable;
}

const osg::Vec3d kEye(3000, 300, 900);
const osg::Vec3d kNorth(3000, 4000, 500);
const osg::Vec3d kSouth(3000, -4000, 500);

} // namespace

TEST(RoamDrawableCull, LookingAwayDrawsFarFewerTriangles)
{
    const auto drawable = drawableOf();
    const auto camera = cameraAt(kEye, kNorth);
    const std::uint64_t towards = cull(*drawable, *camera, 1).triangles();
    camera->setViewMatrixAsLookAt(kEye, kSouth, osg::Vec3d(0, 0, 1));
    const std::uint64_t away = cull(*drawable, *camera, 2).triangles();
    EXPECT_GT(towards, 1000u);
    EXPECT_LT(away * 5, towards);
    EXPECT_EQ(drawable->statistics().front().refine.splits, 0u) << "turning the head changes no mesh";
}

TEST(RoamDrawableCull, LeavesItsBoundingBoxBehindTheCameraOut)
{
    const auto drawable = drawableOf();
    const auto camera = cameraAt(osg::Vec3d(3000, -2000, 900), osg::Vec3d(3000, -9000, 900));
    EXPECT_TRUE(cull(*drawable, *camera, 1).drawables.empty());
}

TEST(RoamDrawableCull, ATimeSliceSpreadsTheWorkOverFrames)
{
    const auto whole = drawableOf(), sliced = drawableOf();
    const auto camera = cameraAt(kEye, kNorth);
    const std::uint64_t wanted = cull(*whole, *camera, 1).triangles();
    osgTerrainROAM::RoamDrawableSettings settings = sliced->settings();
    settings.maxAdaptTimeUs = 40.0;
    settings.adaptClock = viewlod::Budget::Clock::modelled;
    ASSERT_TRUE(sliced->setSettings(settings));
    unsigned int frame = 1;
    EXPECT_LT(cull(*sliced, *camera, frame).triangles(), wanted);
    EXPECT_TRUE(sliced->statistics().front().refine.sliceBound);
    while (sliced->statistics().front().refine.sliceBound && frame < 1000)
        cull(*sliced, *camera, ++frame);
    EXPECT_EQ(cull(*sliced, *camera, ++frame).triangles(), wanted);
    EXPECT_GT(frame, 5u);
}

TEST(RoamDrawableCull, AStricterToleranceDrawsMoreTriangles)
{
    const auto drawable = drawableOf(8.0);
    const auto camera = cameraAt(kEye, kNorth);
    const std::uint64_t coarse = cull(*drawable, *camera, 1).triangles();
    ASSERT_TRUE(drawable->setErrorTolerancePx(1.0));
    EXPECT_GT(cull(*drawable, *camera, 2).triangles(), 2 * coarse);
}

TEST(RoamDrawableCull, TheTriangleCeilingHolds)
{
    const auto drawable = drawableOf(0.5);
    ASSERT_TRUE(drawable->setMaxTriangles(3000));
    const auto camera = cameraAt(kEye, kNorth);
    cull(*drawable, *camera, 1);
    const auto statistics = drawable->statistics().front();
    EXPECT_LE(statistics.refine.leaves, 3000u);
    EXPECT_TRUE(statistics.refine.ceilingBound);
    EXPECT_GT(statistics.refine.tolerancePx, 0.5);
}

TEST(RoamDrawableCull, RefinesOnceForOneEyeInOneFrame)
{
    const auto drawable = drawableOf();
    const auto camera = cameraAt(kEye, kNorth);
    cull(*drawable, *camera, 1);
    const auto first = drawable->statistics().front();
    EXPECT_GT(first.refine.splits, 0u);
    cull(*drawable, *camera, 1);
    EXPECT_EQ(drawable->statistics().front().adaptUs, first.adaptUs)
        << "the second cull must not refine again";
    cull(*drawable, *camera, 2);
    EXPECT_EQ(drawable->statistics().front().refine.splits, 0u);
    EXPECT_EQ(drawable->statistics().front().frame, 2u);
}

TEST(RoamDrawableCull, ATransformMovesTheEyeIntoTheTilesFrame)
{
    const auto plain = drawableOf();
    const auto camera = cameraAt(kEye, kNorth);
    const std::uint64_t expected = cull(*plain, *camera, 1).triangles();

    const auto moved = drawableOf();
    const osg::Matrixd placing =
        osg::Matrixd::rotate(0.7, 0, 0, 1) * osg::Matrixd::translate(50000, -20000, 10);
    const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(placing);
    transform->addChild(moved);
    camera->setViewMatrixAsLookAt(kEye * placing, kNorth * placing, osg::Vec3d(0, 0, 1));
    const std::uint64_t found = cull(*transform, *camera, 1).triangles();
    EXPECT_NEAR(static_cast<double>(found), static_cast<double>(expected), 4.0);
}

TEST(RoamDrawableCull, TheNearPlaneDoesNotCutTheGroundUnderADriver)
{
    const auto drawable = drawableOf();
    const auto& tile = drawable->tile()->tile;
    osg::Vec3d ground;
    for (int i = 0; i < 3; ++i)
        ground[i] = tile.position(100, 75)[i];
    const auto camera = cameraAt(ground + osg::Vec3d(0, 0, 1.5), ground + osg::Vec3d(0, 300, -30));
    const Culled culled = cull(*drawable, *camera, 1, true);
    double left, right, bottom, top, nearM, farM;
    ASSERT_TRUE(culled.projection.getFrustum(left, right, bottom, top, nearM, farM));
    EXPECT_LT(nearM, 1.5);
    EXPECT_GT(nearM, 0.2);
    EXPECT_GT(farM, 2000.0);
    EXPECT_LT(farM, 9000.0);
}

TEST(RoamDrawableCull, AParallelProjectionGetsAnEvenMesh)
{
    const auto drawable = drawableOf(1.0);
    const auto camera = cameraAt(osg::Vec3d(3000, 2200, 5000), osg::Vec3d(3000, 2200.001, 0));
    camera->setProjectionMatrixAsOrtho(-4000, 4000, -3000, 3000, 1, 10000);
    EXPECT_GT(cull(*drawable, *camera, 1).triangles(), 500u);
    EXPECT_EQ(drawable->statistics().front().refine.tolerancePx, 0.0) << "no eye, no pixel tolerance";
}

TEST(RoamDrawableCull, ANodeMaskHidesIt)
{
    const auto drawable = drawableOf();
    drawable->setNodeMask(0);
    EXPECT_TRUE(cull(*drawable, *cameraAt(kEye, kNorth), 1).drawables.empty());
}
