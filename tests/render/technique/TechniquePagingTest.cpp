// SPDX-License-Identifier: Apache-2.0
// A database of stock osgTerrain nodes, written to files and paged in by osgViewer, in all of its threading
// models.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include <osg/PagedLOD>
#include <osgDB/DatabasePager>
#include <osgDB/ReadFile>

#include "TechniquePictures.h"

namespace
{

using namespace techniquepictures;
using namespace techniquescene;

class TechniquePaging : public testing::Test
{
protected:
    void SetUp() override { std::filesystem::create_directories(_folder); }
    void TearDown() override { std::filesystem::remove_all(_folder); }

    osg::ref_ptr<osg::Node> database(bool withOurs = true)
    {
        const auto node = osgDB::readRefNodeFile(writePagedDatabase(_folder, 6000.0).string());
        if (withOurs) osgTerrainROAM::installTechnique(*node, *_technique);
        return node;
    }

    /// Until the pager has nothing more to do.
    void settle(Pictures& pictures)
    {
        osgViewer::Viewer& viewer = pictures.viewer().viewer();
        for (int frame = 0; frame < 600; ++frame)
        {
            pictures.viewer().frame(10.0 + 0.1 * frame);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            if (frame > 5 && viewer.getDatabasePager()->getFileRequestListSize() == 0 &&
                !viewer.getDatabasePager()->getRequestsInProgress())
                break;
        }
    }

    std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("technique-paging." + std::to_string(::getpid()));
    osg::ref_ptr<osgTerrainROAM::RoamTechnique> _technique = new osgTerrainROAM::RoamTechnique;
};

const Viewpoint kNear{{1500, -300, 1100}, {1920, 1920, 200}};
const Viewpoint kFar{{1900, -9000, 5000}, {1920, 1920, 200}};

osgTerrain::TerrainTile* pagedTile(osg::Node& database)
{
    auto* const paged = dynamic_cast<osg::PagedLOD*>(database.asGroup()->getChild(0));
    if (paged->getNumChildren() < 2) return nullptr;
    return dynamic_cast<osgTerrain::TerrainTile*>(paged->getChild(1)->asGroup()->getChild(0));
}

} // namespace

TEST_F(TechniquePaging, PagesChildrenInAndDrawsThemAsGeometryTechniqueDoes)
{
    const auto mine = database(), theirs = database(false);
    Pictures ofMine(mine), ofTheirs(theirs);
    for (const Viewpoint& viewpoint : {kFar, kNear})
    {
        for (Pictures* pictures : {&ofMine, &ofTheirs})
        {
            pictures->from(viewpoint);
            settle(*pictures);
        }
        const Unlikeness found = unlikeness(*ofMine.from(viewpoint), *ofTheirs.from(viewpoint));
        EXPECT_LT(found.mean, 3.0);
        EXPECT_LT(found.shareFar, 0.035);
    }
    osgTerrain::TerrainTile* const tile = pagedTile(*mine);
    ASSERT_TRUE(tile) << "nothing was paged in";
    const auto* technique = dynamic_cast<osgTerrainROAM::RoamTechnique*>(tile->getTerrainTechnique());
    ASSERT_TRUE(technique);
    EXPECT_EQ(technique->drawable()->statistics().size(), 1u) << "it was drawn";
}

TEST_F(TechniquePaging, LetsGoOfWhatIsPagedOut)
{
    const auto mine = database();
    Pictures pictures(mine);
    pictures.from(kNear);
    settle(pictures);
    ASSERT_TRUE(pagedTile(*mine));
    const std::weak_ptr<const osgTerrainROAM::core::RoamTile> ground =
        dynamic_cast<osgTerrainROAM::RoamTechnique*>(pagedTile(*mine)->getTerrainTechnique())
            ->drawable()
            ->tile();
    pictures.viewer().viewer().getDatabasePager()->setTargetMaximumNumberOfPageLOD(0);
    pictures.from(kFar);
    for (int frame = 0; frame < 400 && !ground.expired(); ++frame)
    {
        pictures.viewer().frame(100.0 + frame);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_TRUE(ground.expired());
    EXPECT_GT(magentaPixels(*pictures.from(kFar)), 0u);
}

TEST_F(TechniquePaging, EveryThreadingModelOfOsgViewerLeadsToTheSamePicture)
{
    osg::ref_ptr<osg::Image> expected;
    for (const auto model : {osgViewer::Viewer::SingleThreaded, osgViewer::Viewer::CullDrawThreadPerContext,
                             osgViewer::Viewer::DrawThreadPerContext,
                             osgViewer::Viewer::CullThreadPerCameraDrawThreadPerContext})
    {
        const auto mine = database();
        Pictures pictures(mine);
        osgViewer::Viewer& viewer = pictures.viewer().viewer();
        viewer.realize();
        pictures.viewer().context().releaseContext();
        viewer.setThreadingModel(model);
        viewer.startThreading();
        for (int frame = 0; frame < 40; ++frame)
        {
            const double angle = 0.15 * frame;
            pictures.viewer().camera().setViewMatrixAsLookAt(
                {1900 + 1800 * std::cos(angle), 1900 + 1800 * std::sin(angle), 1000}, {1900, 1900, 200},
                {0, 0, 1});
            pictures.viewer().frame(0.1 * frame);
            osgTerrain::TerrainTile* const tile = pagedTile(*mine);
            if (tile && frame % 10 == 9) tile->setDirty(true);
        }
        settle(pictures);
        viewer.stopThreading();
        viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        const auto picture = pictures.from(kNear);
        ASSERT_TRUE(pagedTile(*mine)) << model;
        if (!expected) expected = picture;
        EXPECT_EQ(unlikeness(*picture, *expected).mean, 0.0) << model;
    }
}
