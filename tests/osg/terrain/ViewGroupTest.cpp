// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/RoamDrawable>
#include <osgTraversal/EyeSharing>

#include "HandCull.h"
#include "SyntheticField.h"

namespace
{

using handcull::cameraAt;
using handcull::cull;
using osgTerrainROAM::RoamDrawable;

osg::ref_ptr<RoamDrawable> drawableOfGroups()
{
    return new RoamDrawable(testsupport::planarTile(testsupport::hills(129, 129)));
}

const osg::Vec3d kGroupEye(1900, 300, 900);
const osg::Vec3d kOtherEye(1900, 3300, 1200);
const osg::Vec3d kGroupNorth(1900, 4000, 500);
const osg::Vec3d kWest(-4000, 300, 500);

} // namespace

TEST(ViewGroups, CamerasWithOneEyeShareAMesh)
{
    const auto drawable = drawableOfGroups();
    const auto left = cameraAt(kGroupEye, kGroupNorth);
    const auto right = cameraAt(kGroupEye, kWest);
    for (unsigned int frame = 1; frame < 4; ++frame)
    {
        cull(*drawable, *left, frame);
        cull(*drawable, *right, frame);
    }
    const auto statistics = drawable->statistics();
    ASSERT_EQ(statistics.size(), 1u);
    EXPECT_EQ(statistics.front().cameras, 2u);
}

TEST(ViewGroups, EyesThatOnlyRoundingPartsShareAMeshAndTheEyesOfAHeadDoNot)
{
    for (const double apartM : {5e-5, 0.063})
    {
        const auto drawable = drawableOfGroups();
        const osg::Vec3d away(apartM, 0, 0);
        cull(*drawable, *cameraAt(kGroupEye, kGroupNorth), 1);
        const auto left = cameraAt(kGroupEye, kGroupNorth),
                   right = cameraAt(kGroupEye + away, kGroupNorth + away);
        cull(*drawable, *left, 2);
        cull(*drawable, *right, 2);
        EXPECT_EQ(drawable->statistics().size(), apartM < 1e-4 ? 1u : 2u) << apartM;
    }
}

TEST(ViewGroups, InSightAreRefinedForWhatAllTheirCamerasSee)
{
    const auto drawable = drawableOfGroups();
    const auto trianglesAfter = [&](std::initializer_list<const osg::Vec3d*> targets, unsigned int& frame)
    {
        std::vector<osg::ref_ptr<osg::Camera>> cameras;
        for (const osg::Vec3d* target : targets)
            cameras.push_back(cameraAt(kGroupEye, *target));
        for (int twice = 0; twice < 2; ++twice, ++frame)
            for (const auto& camera : cameras)
                cull(*drawable, *camera, frame);
        EXPECT_EQ(drawable->statistics().size(), 1u);
        return drawable->statistics().front().refine.triangles;
    };
    unsigned int frame = 1;
    const auto around = trianglesAfter({&kGroupNorth}, frame);
    EXPECT_EQ(trianglesAfter({&kWest}, frame), around) << "a turn changes nothing";
    ASSERT_TRUE(drawable->setViewMarginDeg(2.0));
    const auto north = trianglesAfter({&kGroupNorth}, frame), west = trianglesAfter({&kWest}, frame),
               both = trianglesAfter({&kGroupNorth, &kWest}, frame);
    EXPECT_LT(north, around);
    EXPECT_LT(west, around);
    EXPECT_NE(north, west);
    EXPECT_GT(both, std::max(north, west));
    EXPECT_LE(both, around);
    ASSERT_TRUE(drawable->setViewMarginDeg(90.0));
    EXPECT_EQ(trianglesAfter({&kWest}, frame), around) << "the margin is all around";
    ASSERT_TRUE(drawable->setViewMarginDeg(std::nullopt));
    EXPECT_EQ(trianglesAfter({&kWest}, frame), around);
}

TEST(ViewGroups, IndependentEyesHaveMeshesOfTheirOwn)
{
    const auto drawable = drawableOfGroups();
    const auto one = cameraAt(kGroupEye, kGroupNorth);
    const auto other = cameraAt(kOtherEye, kGroupNorth);
    cull(*drawable, *one, 1);
    cull(*drawable, *other, 1);
    EXPECT_EQ(drawable->statistics().size(), 2u);
}

TEST(ViewGroups, TheStrictestCameraOfAGroupDecides)
{
    const auto drawable = drawableOfGroups();
    const auto wide = cameraAt(kGroupEye, kGroupNorth);
    const auto narrow = cameraAt(kGroupEye, kGroupNorth);
    narrow->setProjectionMatrixAsPerspective(6.0, 800.0 / 600.0, 1.0, 1.0e6);
    cull(*drawable, *narrow, 1);
    const std::uint32_t strict = drawable->statistics().front().refine.triangles;
    for (unsigned int frame = 2; frame < 4; ++frame)
    {
        cull(*drawable, *wide, frame);
        EXPECT_EQ(drawable->statistics().front().refine.triangles, strict);
        cull(*drawable, *narrow, frame);
        EXPECT_EQ(drawable->statistics().front().refine.triangles, strict);
    }
    ASSERT_EQ(drawable->statistics().size(), 1u);
}

TEST(ViewGroups, ACameraThatMovesAwayLeavesItsGroup)
{
    const auto drawable = drawableOfGroups();
    const auto stays = cameraAt(kGroupEye, kGroupNorth);
    const auto goes = cameraAt(kGroupEye, kWest);
    cull(*drawable, *stays, 1);
    cull(*drawable, *goes, 1);
    ASSERT_EQ(drawable->statistics().size(), 1u);
    goes->setViewMatrixAsLookAt(kOtherEye, kGroupNorth, osg::Vec3d(0, 0, 1));
    cull(*drawable, *stays, 2);
    cull(*drawable, *goes, 2);
    const auto statistics = drawable->statistics();
    ASSERT_EQ(statistics.size(), 2u);
    EXPECT_EQ(statistics[0].cameras, 1u);
    EXPECT_EQ(statistics[1].cameras, 1u);
}

TEST(ViewGroups, AGroupThatMovesTogetherStaysTogether)
{
    const auto drawable = drawableOfGroups();
    const auto left = cameraAt(kGroupEye, kGroupNorth);
    const auto right = cameraAt(kGroupEye, kWest);
    for (unsigned int frame = 1; frame < 5; ++frame)
    {
        const osg::Vec3d eye = kGroupEye + osg::Vec3d(0, 40.0 * frame, 0);
        left->setViewMatrixAsLookAt(eye, kGroupNorth, osg::Vec3d(0, 0, 1));
        right->setViewMatrixAsLookAt(eye, kWest, osg::Vec3d(0, 0, 1));
        cull(*drawable, *left, frame);
        cull(*drawable, *right, frame);
        ASSERT_EQ(drawable->statistics().size(), 1u);
    }
}

TEST(ViewGroups, StateOfAnUnusedCameraIsDropped)
{
    const auto drawable = drawableOfGroups();
    const auto stays = cameraAt(kGroupEye, kGroupNorth);
    const auto idle = cameraAt(kOtherEye, kGroupNorth);
    cull(*drawable, *stays, 1);
    cull(*drawable, *idle, 1);
    const unsigned int kept = osgTraversal::kUnusedFrames;
    cull(*drawable, *stays, 1 + kept);
    EXPECT_EQ(drawable->statistics().size(), 2u);
    cull(*drawable, *stays, 2 + kept);
    EXPECT_EQ(drawable->statistics().size(), 1u);
}

TEST(ViewGroups, StateOfADeletedCameraIsDropped)
{
    const auto drawable = drawableOfGroups();
    const auto stays = cameraAt(kGroupEye, kGroupNorth);
    auto gone = cameraAt(kOtherEye, kGroupNorth);
    cull(*drawable, *gone, 1);
    gone = nullptr;
    cull(*drawable, *stays, 2);
    EXPECT_EQ(drawable->statistics().size(), 1u);
}

TEST(ViewGroups, AShadowCameraUsesItsMainViewsMesh)
{
    const auto drawable = drawableOfGroups();
    const auto main = cameraAt(kGroupEye, kGroupNorth);
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const osg::ref_ptr<osg::Camera> shadow = new osg::Camera;
    shadow->setReferenceFrame(osg::Transform::ABSOLUTE_RF_INHERIT_VIEWPOINT);
    shadow->setRenderOrder(osg::Camera::PRE_RENDER);
    shadow->setViewport(0, 0, 512, 512);
    shadow->setViewMatrixAsLookAt(osg::Vec3d(1900, 1900, 6000), osg::Vec3d(1900, 1900.1, 0),
                                  osg::Vec3d(0, 0, 1));
    shadow->setProjectionMatrixAsOrtho(-2500, 2500, -2500, 2500, 1, 10000);
    shadow->addChild(drawable);
    scene->addChild(drawable);
    scene->addChild(shadow);
    for (unsigned int frame = 1; frame < 4; ++frame)
        cull(*scene, *main, frame);
    ASSERT_EQ(drawable->statistics().size(), 1u);
    EXPECT_EQ(drawable->statistics().front().cameras, 1u);

    // With a frame of its own the same camera looks for itself.
    shadow->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    cull(*scene, *main, 4);
    EXPECT_EQ(drawable->statistics().size(), 2u);
}

TEST(ViewGroups, TheMeshOfAnEyeDoesNotDependOnThePathThere)
{
    const auto travelled = drawableOfGroups();
    const auto fresh = drawableOfGroups();
    const auto camera = cameraAt(kGroupEye, kGroupNorth);
    testsupport::Random random(3);
    for (unsigned int frame = 1; frame < 60; ++frame)
    {
        const osg::Vec3d eye(random.unit() * 3800, random.unit() * 3800, 700 + random.unit() * 900);
        camera->setViewMatrixAsLookAt(eye, kGroupNorth, osg::Vec3d(0, 0, 1));
        cull(*travelled, *camera, frame);
    }
    camera->setViewMatrixAsLookAt(kGroupEye, kGroupNorth, osg::Vec3d(0, 0, 1));
    const auto after = cull(*travelled, *camera, 60);
    const auto direct = cull(*fresh, *camera, 60);
    EXPECT_EQ(after.triangles(), direct.triangles());
    EXPECT_EQ(travelled->statistics().front().refine.triangles, fresh->statistics().front().refine.triangles);
}

TEST(ViewGroups, ManyThreadsMayCullAndReadAtOnce)
{
    const auto drawable = drawableOfGroups();
    drawable->getBound();
    const auto work = [&](unsigned int which)
    {
        const auto camera = cameraAt(which % 2 ? kGroupEye : kOtherEye, kGroupNorth);
        for (unsigned int frame = 1; frame < 30; ++frame)
        {
            const osg::Vec3d eye = (which % 2 ? kGroupEye : kOtherEye) + osg::Vec3d(0, 10.0 * frame, 0);
            camera->setViewMatrixAsLookAt(eye, kGroupNorth, osg::Vec3d(0, 0, 1));
            EXPECT_GT(cull(*drawable, *camera, frame).triangles(), 0u);
            EXPECT_GE(drawable->statistics().size(), 1u);
        }
    };
    std::vector<std::thread> threads;
    for (unsigned int i = 0; i < 4; ++i)
        threads.emplace_back(work, i);
    for (std::thread& thread : threads)
        thread.join();
}
