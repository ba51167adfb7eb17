// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osg/MatrixTransform>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include <osgOffscreen/ImageComparison>

#include "RenderedPicture.h"
#include "SyntheticField.h"
#include "SyntheticScene.h"

namespace
{

using namespace osgTerrainROAM;
using namespace syntheticscene;
using osgOffscreen::Backend;
using osgOffscreen::compareImages;

osg::ref_ptr<osg::Image> pictureFrom(osgOffscreen::OffscreenViewer& viewer, const Viewpoint& viewpoint)
{
    look(viewer, viewpoint);
    return viewer.picture();
}

/// Pixels of the background's colour.
std::size_t backgroundPixels(const osg::Image& picture)
{
    std::size_t count = 0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            const unsigned char* p = picture.data(x, y);
            if (p[0] == 255 && p[1] == 0 && p[2] == 255) ++count;
        }
    return count;
}

} // namespace

// The triangles are the same, their order in the buffers is not: where two hills fall into one step of the
// depth buffer, the order would decide. With a near plane of 5 m no pixel here is such a place.
TEST(TerrainDrawing, APictureDoesNotDependOnTheWayThere)
{
    const auto travelled = islandTerrain();
    const auto fresh = islandTerrain();
    const auto viewer = viewerOn(travelled, rendered::backends().front());
    ASSERT_TRUE(viewer);
    const auto views = viewpoints(travelled->tile()->tile);
    testsupport::Random random(8);
    for (int frame = 0; frame < 60; ++frame)
        pictureFrom(*viewer,
                    {"", osg::Vec3d(random.unit() * 5000, random.unit() * 4500, 20 + random.unit() * 3000),
                     osg::Vec3d(2500, 2200, 0)});
    const auto other = viewerOn(fresh, rendered::backends().front());
    for (auto* each : {viewer.get(), other.get()})
        each->camera().setProjectionMatrixAsPerspective(45.0, 320.0 / 180.0, 5.0, 30000.0);
    for (const Viewpoint& view : views)
    {
        const auto difference = compareImages(*pictureFrom(*viewer, view), *pictureFrom(*other, view));
        EXPECT_TRUE(difference.identical()) << view.name << ": " << difference.message();
    }
}

// Where every sample is drawn, patches are another way to the same triangles.
TEST(TerrainDrawing, PatchesDrawTheSameGround)
{
    for (const auto backend : rendered::backends())
    {
        const auto terrain = islandTerrain(1e-4);
        const auto viewer = viewerOn(terrain, backend);
        ASSERT_TRUE(viewer);
        const auto views = viewpoints(terrain->tile()->tile);
        viewer->camera().setProjectionMatrixAsPerspective(45.0, 320.0 / 180.0, 5.0, 30000.0);
        for (const Viewpoint& view : views)
        {
            ASSERT_TRUE(terrain->drawable()->setPatchExponent(0));
            const auto plain = pictureFrom(*viewer, view);
            for (const int exponent : {2, 6})
            {
                ASSERT_TRUE(terrain->drawable()->setPatchExponent(exponent));
                const auto difference = compareImages(*plain, *pictureFrom(*viewer, view));
                EXPECT_TRUE(difference.within(16, 4))
                    << view.name << ' ' << exponent << ": " << difference.message();
                EXPECT_EQ(terrain->statistics().front().trianglesDrawn % (1u << exponent), 0u);
            }
        }
    }
}

TEST(TerrainDrawing, BothBackendsDrawTheSame)
{
    const auto backends = rendered::backends();
    if (backends.size() < 2) GTEST_SKIP() << "only one backend is built in";
    const auto terrain = islandTerrain();
    const auto one = viewerOn(terrain, backends[0]);
    const auto two = viewerOn(islandTerrain(), backends[1]);
    ASSERT_TRUE(one && two);
    for (const Viewpoint& view : viewpoints(terrain->tile()->tile))
        EXPECT_TRUE(compareImages(*pictureFrom(*one, view), *pictureFrom(*two, view)).identical())
            << view.name;
}

TEST(TerrainDrawing, OneTerrainInTwoContextsLooksTheSameInBoth)
{
    // Each context draws frames the other does not, so each misses packets of the shared drawable.
    const auto terrain = islandTerrain();
    const auto one = viewerOn(terrain, rendered::backends().front());
    const auto two = viewerOn(terrain, rendered::backends().front());
    ASSERT_TRUE(one && two);
    const auto views = viewpoints(terrain->tile()->tile);
    for (const Viewpoint& view : views)
    {
        const auto first = pictureFrom(*one, view);
        if (view.name == "pilot") continue;
        EXPECT_TRUE(compareImages(*pictureFrom(*two, view), *first).identical()) << view.name;
    }
}

TEST(TerrainDrawing, ReleasedBuffersAreFilledAnew)
{
    const auto terrain = islandTerrain();
    const auto viewer = viewerOn(terrain, rendered::backends().front());
    ASSERT_TRUE(viewer);
    const auto views = viewpoints(terrain->tile()->tile);
    const auto before = pictureFrom(*viewer, views[1]);
    terrain->releaseGLObjects();
    const auto after = pictureFrom(*viewer, views[1]);
    EXPECT_TRUE(compareImages(*before, *after).identical());
}

TEST(TerrainDrawing, ShowsNoHoleFromAbove)
{
    const auto terrain = islandTerrain(4.0);
    const auto viewer = viewerOn(terrain, rendered::backends().front());
    ASSERT_TRUE(viewer);
    viewer->camera().setClearColor(osg::Vec4(1, 0, 1, 1));
    testsupport::Random random(4);
    for (int i = 0; i < 30; ++i)
    {
        // Steep enough to see land alone: the field of view is 45° high and 73° wide.
        const auto ground =
            core::groundAt(terrain->tile()->tile, 1900 + 1100 * random.unit(), 1500 + 1300 * random.unit());
        ASSERT_TRUE(ground);
        const osg::Vec3d eye(ground->position.x, ground->position.y, ground->position.z + 600);
        const auto picture = pictureFrom(*viewer, {"", eye, eye + osg::Vec3d(10 * random.unit(), 1, -400)});
        EXPECT_EQ(backgroundPixels(*picture), 0u) << i;
    }
}

TEST(TerrainDrawing, AMissingRegionWouldShowAsAHole)
{
    // The mutation for the test above: the data end 400 m earlier.
    const auto terrain = islandTerrain(4.0);
    terrain->material()->stateSet()->getUniform("terrainLastSample")->set(osg::Vec2f(90.0f, 90.0f));
    const auto viewer = viewerOn(terrain, rendered::backends().front());
    ASSERT_TRUE(viewer);
    viewer->camera().setClearColor(osg::Vec4(1, 0, 1, 1));
    const osg::Vec3d eye(2300, 2300, 1200);
    EXPECT_GT(backgroundPixels(*pictureFrom(*viewer, {"", eye, eye + osg::Vec3d(5, 1, -400)})), 1000u);
}

TEST(TerrainDrawing, FarFromTheOriginNothingMovesAboutInThePicture)
{
    // The same view of the same terrain at the origin and far from it; the eye stands 1.5 m above the ground.
    const auto terrain = islandTerrain();
    const Viewpoint here = viewpoints(terrain->tile()->tile).front();
    const auto near = viewerOn(terrain, rendered::backends().front());
    const osg::Vec3d shift(65536.0, -131072.0, 0.0);
    const osg::ref_ptr<osg::MatrixTransform> far = new osg::MatrixTransform(osg::Matrixd::translate(shift));
    far->addChild(islandTerrain());
    const auto away = viewerOn(far, rendered::backends().front());
    ASSERT_TRUE(near && away);
    const auto difference = compareImages(*pictureFrom(*near, here),
                                          *pictureFrom(*away, {"", here.eye + shift, here.target + shift}));
    EXPECT_TRUE(difference.within(40, 8)) << difference.message();
}

TEST(TerrainDrawing, UploadsOnlyWhatChanged)
{
    const auto terrain = islandTerrain();
    const auto viewer = viewerOn(terrain, rendered::backends().front());
    ASSERT_TRUE(viewer);
    Viewpoint view = viewpoints(terrain->tile()->tile)[1];
    pictureFrom(*viewer, view);
    const auto whole = terrain->statistics().front();
    EXPECT_GT(whole.trianglesDrawn, 1000u);
    view.eye += osg::Vec3d(2, 1, 0);
    pictureFrom(*viewer, view);
    const auto moved = terrain->statistics().front();
    EXPECT_LT((moved.bytesUploaded - whole.bytesUploaded) * 5, whole.bytesUploaded);
    pictureFrom(*viewer, view);
    EXPECT_EQ(terrain->statistics().front().bytesUploaded, moved.bytesUploaded)
        << "standing still costs nothing";
}

TEST(TerrainDrawing, EveryThreadingModelOfOsgViewerLeadsToTheSamePicture)
{
    osg::ref_ptr<osg::Image> expected;
    std::size_t expectedBytes = 0;
    for (const auto model : {osgViewer::Viewer::SingleThreaded, osgViewer::Viewer::CullDrawThreadPerContext,
                             osgViewer::Viewer::DrawThreadPerContext,
                             osgViewer::Viewer::CullThreadPerCameraDrawThreadPerContext})
    {
        const auto terrain = islandTerrain(2.0);
        const auto viewer = viewerOn(terrain, rendered::backends().front());
        ASSERT_TRUE(viewer);
        viewer->viewer().realize();
        viewer->context().releaseContext();
        viewer->viewer().setThreadingModel(model);
        viewer->viewer().startThreading();
        for (int frame = 0; frame < 60; ++frame)
        {
            const double angle = 0.1 * frame;
            look(*viewer, {"", osg::Vec3d(2500 + 1800 * std::cos(angle), 2200 + 1800 * std::sin(angle), 1300),
                           osg::Vec3d(2500, 2200, 0)});
            viewer->frame(0.1 * frame);
        }
        // The picture is taken by one thread, from the buffers that the others have filled.
        viewer->viewer().stopThreading();
        viewer->viewer().setThreadingModel(osgViewer::Viewer::SingleThreaded);
        const auto picture = viewer->picture(7.0);
        if (!expected)
        {
            expected = picture;
            expectedBytes = terrain->statistics().front().bytesUploaded;
        }
        EXPECT_TRUE(compareImages(*picture, *expected).identical()) << model;
        EXPECT_EQ(terrain->statistics().front().bytesUploaded, expectedBytes)
            << "no packet was lost or repeated";
    }
}
