// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include <osgDB/Registry>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>

#include <osgMultiTriangulation/OpenMultiTriangulation>
#include <osgOffscreen/OffscreenViewer>

#include "HillSurface.h"
#include "RenderedPicture.h"
#include "TestFolder.h"

namespace osgMultiTriangulation
{

namespace
{

constexpr double kSpacingM = 30.0;
constexpr int kColumns = 150, kRows = 140;
const osg::Vec3d kEye(300.0, 250.0, 260.0), kTarget(3000.0, 3200.0, 0.0);

/// Hills in a file of 8 rectangles.
struct HillsToDraw
{
    testsupport::TestFolder folder{"mt-drawing"};
    core::SurfaceMesh mesh = testsupport::hillSurface(kColumns, kRows, 1.0);
    std::filesystem::path path = folder / "hills.mt";

    HillsToDraw()
    {
        core::ForestOptions options;
        options.treeCount = 8;
        EXPECT_TRUE(core::buildMtFile(mesh, {0.0, 0.0, kSpacingM, kSpacingM}, options, path));
    }

    MtTerrain terrain(double tolerancePx, const MtDrawableSettings& settings = {.waits = true}) const
    {
        auto opened = openMultiTriangulation(path, settings);
        EXPECT_TRUE(opened) << opened.error().message();
        EXPECT_TRUE(opened->terrain->drawable()->setErrorTolerancePx(tolerancePx));
        return *opened;
    }

    /// The same ground by ROAM.
    osg::ref_ptr<osgTerrainROAM::RoamTerrain> roam(double tolerancePx) const
    {
        osgTerrainROAM::core::HeightField field;
        field.columns = kColumns;
        field.rows = kRows;
        field.spacingEastM = field.spacingNorthM = kSpacingM;
        for (const core::SurfacePoint& point : mesh.points)
            field.heightsM.push_back(static_cast<float>(point.height));
        const auto tile = std::make_shared<osgTerrainROAM::core::RoamTile>(
            osgTerrainROAM::core::PlacedTile(std::move(field)));
        const auto terrain = osgTerrainROAM::makeTerrain({}, tile);
        EXPECT_TRUE(terrain && (*terrain)->drawable()->setErrorTolerancePx(tolerancePx));
        return *terrain;
    }
};

std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* node)
{
    auto viewer = rendered::viewerOf(node, {.widthPx = 320, .heightPx = 180});
    viewer->camera().setClearColor({1.0F, 0.0F, 1.0F, 1.0F}); // seen through a hole
    viewer->camera().setProjectionMatrixAsPerspective(50.0, 320.0 / 180.0, 5.0, 100000.0);
    viewer->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    viewer->camera().setViewMatrixAsLookAt(kEye, kTarget, {0.0, 0.0, 1.0});
    return viewer;
}

osg::ref_ptr<osg::Image> pictureOf(osg::Node* node)
{
    return viewerOn(node)->picture();
}

/// Mean difference of two pictures, levels of 255.
double meanDifference(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.getTotalSizeInBytes(); ++i)
        sum += std::abs(int(a.data()[i]) - int(b.data()[i]));
    return sum / static_cast<double>(a.getTotalSizeInBytes());
}

/// The number of pixels below the horizon through which the background is seen.
int holesIn(const osg::Image& picture)
{
    int holes = 0;
    for (int row = 0; row < picture.t() / 2; ++row)
        for (int column = 0; column < picture.s(); ++column)
        {
            const unsigned char* const p = picture.data(column, row);
            holes += p[0] > 240 && p[1] < 15 && p[2] > 240;
        }
    return holes;
}

TEST(MtDrawing, looksAsTheSameGroundByRoamDoesWithFewerTriangles)
{
    const HillsToDraw here;
    const MtTerrain fine = here.terrain(0.5), coarse = here.terrain(60.0);
    const osg::ref_ptr<osgTerrainROAM::RoamTerrain> roam = here.roam(0.5);
    const auto expected = pictureOf(roam), drawn = pictureOf(fine.terrain);
    EXPECT_LT(meanDifference(*drawn, *expected), 1.0); // both cut their cells along other diagonals
    EXPECT_GT(meanDifference(*pictureOf(coarse.terrain), *expected), 3.0) << "the comparison sees no shape";
    EXPECT_EQ(holesIn(*drawn), 0);
    ASSERT_EQ(fine.drawable->statistics().size(), 1u);
    EXPECT_LT(fine.drawable->statistics()[0].triangles, roam->statistics().at(0).refine.triangles * 2 / 3);
    EXPECT_LT(coarse.drawable->statistics()[0].triangles, fine.drawable->statistics()[0].triangles / 10);
}

TEST(MtDrawing, equalFramesAreEqual)
{
    const HillsToDraw here;
    const auto one = pictureOf(here.terrain(1.0).terrain), other = pictureOf(here.terrain(1.0).terrain);
    EXPECT_EQ(meanDifference(*one, *other), 0.0);
}

TEST(MtDrawing, aFrameThatDoesNotWaitHasNoHoleAndDetailFollows)
{
    const HillsToDraw here;
    const MtTerrain slow = here.terrain(1.0, {.mostBytesPerS = 3e6});
    const auto viewer = viewerOn(slow.terrain);
    const auto settled = pictureOf(here.terrain(1.0).terrain);
    double before = 1e30;
    for (int frame = 0; frame < 200; ++frame)
    {
        const auto picture = viewer->picture(frame / 60.0);
        EXPECT_EQ(holesIn(*picture), 0) << frame;
        const double difference = meanDifference(*picture, *settled);
        if (frame == 0) before = difference;
        if (difference == 0.0) break;
        ASSERT_LT(frame, 199) << "detail has not come";
    }
    EXPECT_GT(before, 1.0) << "the first frame shows no detail yet";
}

TEST(MtDrawing, aCameraThatMovesAndATurnAboutKeepTheGroundWhole)
{
    const HillsToDraw here;
    const MtTerrain terrain = here.terrain(2.0);
    const auto viewer = viewerOn(terrain.terrain);
    for (int frame = 0; frame < 24; ++frame)
    {
        const double along = (frame < 12 ? frame : 24 - frame) / 12.0, way = frame < 12 ? 1.0 : -1.0;
        const osg::Vec3d eye(600.0 + 2400.0 * along, 900.0 + 2000.0 * along, 200.0);
        viewer->camera().setViewMatrixAsLookAt(eye, eye + osg::Vec3d(way * 900.0, way * 800.0, -700.0),
                                               {0.0, 0.0, 1.0});
        EXPECT_EQ(holesIn(*viewer->picture(frame / 24.0)), 0) << frame;
    }
    terrain.drawable->setNodeMask(0);
    terrain.terrain->showSurroundings(false);
    EXPECT_GT(holesIn(*viewer->picture(1.0)), 1000) << "without the drawable there must be holes";
}

TEST(MtDrawing, osgDbOpensItThroughItsPlugin)
{
    const HillsToDraw here;
    osgDB::Registry::instance()->getLibraryFilePathList().push_front(OSGTRAINER_PLUGIN_FOLDER);
    auto read = osgDB::Registry::instance()->readNode(here.path.string(), nullptr);
    ASSERT_TRUE(read.getNode()) << read.message();
    EXPECT_NEAR(read.getNode()->getBound().radius(), 0.5 * kSpacingM * std::hypot(kColumns, kRows), 200.0);
    std::ofstream(here.folder / "bad.mt") << "no triangulation";
    auto bad = osgDB::Registry::instance()->readNode((here.folder / "bad.mt").string(), nullptr);
    EXPECT_FALSE(bad.getNode());
    EXPECT_NE(bad.message().find("is not a .mt file"), std::string::npos) << bad.message();
}

} // namespace

} // namespace osgMultiTriangulation
