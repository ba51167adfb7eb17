// SPDX-License-Identifier: Apache-2.0
// Networks through osgDB, as osgviewer opens them.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include "RenderedPicture.h"
#include "RoadTexts.h"

namespace
{

using namespace roadtexts;

class XodrPlugin : public testing::Test
{
protected:
    void SetUp() override
    {
        osgDB::Registry::instance()->setLibraryFilePathList(OSGTRAINER_PLUGIN_FOLDER);
        std::filesystem::create_directories(_folder);
        write("straight.xodr", network(road("1", 200.0, straightPlan(200.0) + twoLanes())));
    }
    void TearDown() override { std::filesystem::remove_all(_folder); }

    std::string write(const std::string& name, const std::string& text) const
    {
        std::ofstream(_folder / name) << text;
        return (_folder / name).string();
    }

    static osgDB::ReaderWriter::ReadResult read(const std::string& file, const std::string& options = "")
    {
        const osg::ref_ptr<osgDB::Options> told = new osgDB::Options(options);
        return osgDB::Registry::instance()->readNode(file, told);
    }

    /// The share of a picture from 6 m above the road's middle in which anything is drawn.
    static double drawnShare(osg::Node* scene)
    {
        osgOffscreen::OffscreenSettings settings;
        settings.widthPx = settings.heightPx = 96;
        const auto viewer = rendered::viewerOf(scene, settings);
        if (!viewer) return -1.0;
        viewer->camera().setClearColor({1.0F, 0.0F, 1.0F, 1.0F});
        viewer->camera().setViewMatrixAsLookAt({100.0, 0.0, 30.0}, {100.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
        const osg::ref_ptr<osg::Image> picture = viewer->picture();
        int drawn = 0;
        for (int row = 0; row < picture->t(); ++row)
            for (int column = 0; column < picture->s(); ++column)
                drawn += picture->getColor(column, row).g() > 0.05F ? 1 : 0;
        return static_cast<double>(drawn) / (picture->s() * picture->t());
    }

    std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("xodr-plugin." + std::to_string(::getpid()));
};

TEST_F(XodrPlugin, ShowsARoadAsWideAsItIs)
{
    const auto node = osgDB::readRefNodeFile((_folder / "straight.xodr").string());
    ASSERT_TRUE(node);
    EXPECT_NEAR(node->getBound().center().x(), 100.0, 1.0);
    const double visibleM = 2.0 * 30.0 * std::tan(osg::DegreesToRadians(22.5)); // the viewer's 45 degrees
    // Two lanes of 3.5 m, verges of 2.5 m, and skirts that end 0.75 m farther out and 1.65 m lower.
    EXPECT_NEAR(drawnShare(node), 2.0 * (3.5 + 2.5 + 0.75) * 30.0 / 31.65 / visibleM, 0.015);
}

TEST_F(XodrPlugin, IntersectionsFindTheSurface)
{
    const auto node = osgDB::readRefNodeFile((_folder / "straight.xodr").string());
    ASSERT_TRUE(node);
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> down =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(50.0, 1.0, 10.0), osg::Vec3d(50.0, 1.0, -10.0));
    osgUtil::IntersectionVisitor visitor(down);
    node->accept(visitor);
    ASSERT_TRUE(down->containsIntersections());
    EXPECT_NEAR(down->getFirstIntersection().getWorldIntersectPoint().z(), 0.0, 1e-3);
}

TEST_F(XodrPlugin, DrawsNoRoadBeyondTheFarthestDistance)
{
    auto far = read((_folder / "straight.xodr").string(), "farthest=20");
    ASSERT_TRUE(far.getNode());
    EXPECT_EQ(drawnShare(far.getNode()), 0.0);
}

TEST_F(XodrPlugin, SaysFilePlaceAndRemedy)
{
    EXPECT_THAT(read(write("bad.xodr", "<OpenDRIVE>\n<road>\n</OpenDRIVE>\n")).message(),
                testing::HasSubstr("bad.xodr:"));
    EXPECT_THAT(read((_folder / "straight.xodr").string(), "tolerance=fine").message(),
                testing::HasSubstr("tolerance=fine: holds no number; write tolerance=NUMBER"));
    EXPECT_THAT(read((_folder / "straight.xodr").string(), "tolerance=0").message(),
                testing::HasSubstr("not above 0"));
    EXPECT_EQ(read((_folder / "none.xodr").string()).status(),
              osgDB::ReaderWriter::ReadResult::FILE_NOT_FOUND);
}

TEST_F(XodrPlugin, TellsWhatIsWrongInTheDescriptions)
{
    auto result =
        read(write("odd.xodr", network(road("1", 200.0, straightPlan(200.0) + twoLanes() + "<riddle/>"))));
    ASSERT_TRUE(result.validNode());
    ASSERT_EQ(result.getNode()->getNumDescriptions(), 1u);
    EXPECT_THAT(result.getNode()->getDescription(0), testing::HasSubstr("riddle"));
}

} // namespace
