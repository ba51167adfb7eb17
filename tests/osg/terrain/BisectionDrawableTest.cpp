// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>
#include <osgTerrainROAM/core/bisection/BisectionFile.h>

#include <osgTerrainROAM/BisectionDrawable>

#include "HandCull.h"
#include "TestFolder.h"

namespace
{

using handcull::cameraAt;
using handcull::cull;
using osgTerrainROAM::BisectionDrawable;

const osg::Vec3d kNear(0.0, -1150.0, 0.0), kFar(0.0, -9000.0, 0.0), kCentre(0.0, 0.0, 0.0);

class BisectionDrawing : public testing::Test
{
protected:
    std::filesystem::path file() const
    {
        return folder.write("sphere.bisection", "levels = 11\nradius = 1000\nrelief = 60 700\n");
    }

    osg::ref_ptr<BisectionDrawable> drawable(double tolerancePx = 2.0) const
    {
        const osg::ref_ptr<BisectionDrawable> made =
            new BisectionDrawable(*osgTerrainROAM::core::openBisection(file()));
        made->setErrorTolerancePx(tolerancePx);
        return made;
    }

    testsupport::TestFolder folder{"bisection-drawable"};
};

} // namespace

TEST_F(BisectionDrawing, eyesHaveMeshesOfTheirOwn)
{
    const auto sphere = drawable();
    const auto near = cameraAt(kNear, kCentre), far = cameraAt(kFar, kCentre);
    const std::uint64_t fine = cull(*sphere, *near, 1).triangles();
    const std::uint64_t coarse = cull(*sphere, *far, 1).triangles();
    EXPECT_GT(fine, 4 * coarse);
    EXPECT_EQ(sphere->statistics().size(), 2u);
    EXPECT_EQ(cull(*sphere, *near, 2).triangles(), fine);
    EXPECT_EQ(cull(*sphere, *far, 2).triangles(), coarse);
}

TEST_F(BisectionDrawing, camerasAtOneEyeShareAMesh)
{
    const auto sphere = drawable();
    const auto left = cameraAt(kNear, {-300.0, 0.0, 0.0}), right = cameraAt(kNear, {300.0, 0.0, 0.0});
    const auto first = cull(*sphere, *left, 1), second = cull(*sphere, *right, 1);
    ASSERT_EQ(sphere->statistics().size(), 1u);
    EXPECT_EQ(sphere->statistics()[0].cameras, 2u);
    EXPECT_EQ(first.drawables, second.drawables);
}

TEST_F(BisectionDrawing, whatIsDrawnIsNotChangedAndStaysWhereNothingMoves)
{
    const auto sphere = drawable();
    const auto camera = cameraAt(kNear, kCentre);
    const auto first = cull(*sphere, *camera, 1);
    const std::uint64_t triangles = first.triangles();
    EXPECT_EQ(cull(*sphere, *camera, 2).drawables, first.drawables);
    camera->setViewMatrixAsLookAt(kFar, kCentre, {0.0, 0.0, 1.0});
    EXPECT_NE(cull(*sphere, *camera, 3).drawables, first.drawables);
    EXPECT_EQ(first.triangles(), triangles);
}

TEST_F(BisectionDrawing, noPointIsFartherOffThanTheCameraAllows)
{
    const auto sphere = drawable(2.0);
    const auto camera = cameraAt(kNear, kCentre);
    cull(*sphere, *camera, 1);
    const auto& model = *sphere->model();
    osgTerrainROAM::core::BisectionMesh mesh(model.surface, model.patches);
    // 800 pixels over 60 degrees; a unit of tangent in the corner of the picture has no fewer pixels than in
    // the middle.
    const double pixelsPerTangent = 800.0 / (2.0 * std::tan(osg::DegreesToRadians(30.0)));
    const osgTerrainROAM::core::BisectionView view{
        {kNear.x(), kNear.y(), kNear.z()}, 2.0 / pixelsPerTangent, 1.0};
    mesh.refine(view);
    EXPECT_LE(osgTerrainROAM::core::worstShare(mesh, view), 1.0);
    EXPECT_LE(mesh.drawn().size(), cull(*sphere, *camera, 2).triangles())
        << "the camera is given at least what it allows";
    sphere->setErrorTolerancePx(8.0);
    EXPECT_GT(mesh.drawn().size(), cull(*sphere, *camera, 3).triangles());
}

TEST_F(BisectionDrawing, functorsSeeTheCoarsestMeshBeforeAnEyeCame)
{
    const auto sphere = drawable();
    handcull::Culled shown{{sphere}, {}};
    EXPECT_EQ(shown.triangles(), 24u); // the sides of the cube
    cull(*sphere, *cameraAt(kNear, kCentre), 1);
    EXPECT_GT(shown.triangles(), 1000u);
}

TEST_F(BisectionDrawing, thePluginOpensFilesAndTellsWhatIsWrong)
{
    osgDB::Registry::instance()->setLibraryFilePathList(OSGTRAINER_PLUGIN_FOLDER);
    const auto node = osgDB::readRefNodeFile(file().string());
    ASSERT_TRUE(node);
    EXPECT_NEAR(node->getBound().radius(), 1800.0, 200.0); // of the corners of a box
    const auto bad = folder.write("bad.bisection", "levels = 99\n");
    EXPECT_THAT(osgDB::Registry::instance()->readNode(bad.string(), nullptr).message(),
                testing::HasSubstr("bad.bisection:1"));
}
