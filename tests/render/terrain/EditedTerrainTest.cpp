// SPDX-License-Identifier: Apache-2.0
// Edits as they are seen: in the next frame, shaded, and gone without a trace when they are taken back.
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include <osgOffscreen/ImageComparison>

#include "RenderedPicture.h"
#include "SyntheticScene.h"

namespace
{

using namespace osgTerrainROAM;
using namespace syntheticscene;
using osgOffscreen::compareImages;

struct Scene
{
    Scene() : terrain(editableIsland()), viewer(viewerOn(terrain, rendered::backends().front())) {}

    osg::ref_ptr<osg::Image> pictureFrom(const glm::dvec3& eye, const glm::dvec3& target)
    {
        look(*viewer, {"", {eye.x, eye.y, eye.z}, {target.x, target.y, target.z}});
        return viewer->picture();
    }

    glm::dvec3 over(const glm::dvec2& place, double metres) const
    {
        const auto ground = core::groundAt(terrain->tile()->tile, place.x, place.y);
        return ground->position + glm::dvec3(0.0, 0.0, metres);
    }

    osg::ref_ptr<RoamTerrain> terrain;
    std::unique_ptr<osgOffscreen::OffscreenViewer> viewer;
};

const glm::dvec2 kPlace(1600.0, 1500.0);

} // namespace

TEST(EditedTerrain, ShowsInTheNextFrameAndGoesWithoutATrace)
{
    Scene scene;
    ASSERT_TRUE(scene.viewer);
    const glm::dvec3 eye = scene.over(kPlace + glm::dvec2(-150.0, -150.0), 80.0),
                     target = scene.over(kPlace, 0.0);
    const osg::ref_ptr<osg::Image> before = scene.pictureFrom(eye, target);
    ASSERT_TRUE(
        scene.terrain->editor()->stamp({.centre = kPlace, .radiusM = 40.0, .depthM = 15.0, .rimM = 3.0}));
    const osg::ref_ptr<osg::Image> cratered = scene.pictureFrom(eye, target);
    EXPECT_GT(compareImages(*before, *cratered).differingPixels, 3000u);
    ASSERT_TRUE(scene.terrain->editor()->undo());
    EXPECT_TRUE(compareImages(*before, *scene.pictureFrom(eye, target)).within(300, 2));
}

/// From straight above nothing but light tells that something is there.
TEST(EditedTerrain, SlopesBetweenSamplesAreShaded)
{
    Scene scene;
    ASSERT_TRUE(scene.viewer);
    const glm::dvec3 eye = scene.over(kPlace, 60.0) + glm::dvec3(0.0, -0.5, 0.0),
                     target = scene.over(kPlace, 0.0);
    const osg::ref_ptr<osg::Image> before = scene.pictureFrom(eye, target);
    const double level = scene.over(kPlace, 4.0).z;
    core::Platform platform;
    for (const glm::dvec2 corner : {glm::dvec2(-5, -5), {5, -5}, {5, 5}, {-5, 5}})
        platform.corners.emplace_back(kPlace + corner, level);
    ASSERT_TRUE(scene.terrain->editor()->conform(platform));
    const osg::ref_ptr<osg::Image> after = scene.pictureFrom(eye, target);
    std::size_t brighter = 0, darker = 0;
    for (int y = 0; y < after->t(); ++y)
        for (int x = 0; x < after->s(); ++x)
        {
            const int by = int(after->data(x, y)[1]) - int(before->data(x, y)[1]);
            brighter += by > 12 ? 1 : 0;
            darker += by < -12 ? 1 : 0;
        }
    EXPECT_GT(brighter, 150u) << "towards the sun";
    EXPECT_GT(darker, 150u) << "away from it";
}

/// What rises above all that was is neither culled nor cut off.
TEST(EditedTerrain, BoundsGrow)
{
    Scene scene;
    ASSERT_TRUE(scene.viewer);
    const glm::dvec3 eye(-2000.0, 1500.0, 3000.0), target(1600.0, 1500.0, 2950.0);
    const osg::ref_ptr<osg::Image> before = scene.pictureFrom(eye, target);
    ASSERT_TRUE(scene.terrain->editor()->setHeight(core::Region::circle(kPlace, 60.0), 3000.0));
    EXPECT_GT(compareImages(*before, *scene.pictureFrom(eye, target)).differingPixels, 20u);
    EXPECT_GT(scene.terrain->drawable()->getBoundingBox().zMax(), 2999.0f);
}

TEST(EditedTerrain, MayBeEditedWhileItIsDrawn)
{
    Scene scene;
    ASSERT_TRUE(scene.viewer);
    const glm::dvec3 eye = scene.over(kPlace, 120.0), target(1700.0, 1600.0, 0.0);
    std::atomic<bool> isDone = false;
    std::thread editing(
        [&]
        {
            for (int i = 0; i < 60; ++i)
            {
                const glm::dvec2 place = kPlace + glm::dvec2(20.0 * (i % 8), 15.0 * (i % 5));
                EXPECT_TRUE(scene.terrain->editor()->stamp({.centre = place, .radiusM = 6.0}));
                if (i % 3 == 0) scene.terrain->editor()->undo();
            }
            isDone = true;
        });
    int frames = 0;
    for (; !isDone || frames < 5; ++frames)
        scene.pictureFrom(eye + glm::dvec3(0.0, 0.0, frames % 7), target);
    editing.join();
    scene.pictureFrom(eye, target);
    EXPECT_GT(frames, 4);
    for (const ViewGroupStatistics& group : scene.terrain->statistics())
        EXPECT_FALSE(group.refine.sliceBound);
}
