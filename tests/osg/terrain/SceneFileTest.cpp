// SPDX-License-Identifier: Apache-2.0
// A terrain in OpenSceneGraph's scene files: stored by the file it was read from, or refused with a message.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osg/Geode>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgTerrainROAM/RoamTerrain>

#include "RasterWriter.h"
#include "SyntheticField.h"

namespace
{

using osgTerrainROAM::RoamDrawableSettings;
using osgTerrainROAM::RoamTerrain;
using testing::HasSubstr;

class SceneFile : public testing::TestWithParam<const char*>
{
protected:
    SceneFile()
    {
        RasterSpec spec;
        spec.columns = 40;
        spec.rows = 30;
        spec.geoTransform = northUp3Seconds(30);
        spec.epsg = 4326;
        writeRaster(_folder / "dem.tif", "GTiff", spec);
        writeBytes(_folder / "land.roam", "dem = dem.tif\nerror_tolerance = 3\nvisibility = 5000\n");
    }

    osg::ref_ptr<RoamTerrain> opened() const
    {
        const auto terrain = osgTerrainROAM::openTerrain(_folder / "land.roam");
        EXPECT_TRUE(terrain) << terrain.error().message();
        return *terrain;
    }

    std::string file() const { return (_folder / ("scene." + std::string(GetParam()))).string(); }

    /// What osgDB says about writing a node; empty: it has been written.
    std::string refusal(const osg::Node& node) const
    {
        const auto written = osgDB::Registry::instance()->writeNode(node, file(), nullptr);
        return written.success() ? "" : written.message();
    }

    TemporaryFolder _folder;
};

TEST_P(SceneFile, StoresTheFileTheSettingsAndTheAtmosphere)
{
    const auto terrain = opened();
    const RoamDrawableSettings settings{.method = osgTerrainROAM::core::Method::roamQueue,
                                        .errorTolerancePx = 1.0 / 3.0,
                                        .maxTriangles = 7777,
                                        .morphing = true,
                                        .patchExponent = 2,
                                        .viewMarginDeg = 2.5};
    ASSERT_TRUE(terrain->setSettings(settings));
    osgSky::AtmosphereSettings air = terrain->atmosphere()->settings();
    air.cloudCover = 0.1;
    air.fogColour = osg::Vec3f(0.1f, 0.2f, 0.3f);
    ASSERT_TRUE(terrain->atmosphere()->setSettings(air));
    terrain->setName("a land with a name");
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(terrain);
    ASSERT_EQ(refusal(*scene), "");

    const osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(file());
    ASSERT_TRUE(read && read->asGroup() && read->asGroup()->getNumChildren() == 1);
    const auto* const again = dynamic_cast<const RoamTerrain*>(read->asGroup()->getChild(0));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->getName(), "a land with a name");
    EXPECT_EQ(again->settings(), settings);
    EXPECT_EQ(again->atmosphere()->settings(), air);
    EXPECT_EQ(again->source(), terrain->source());
    ASSERT_TRUE(again->tile());
    EXPECT_EQ(again->tile()->tile.grid().dataColumns(), 40);
    EXPECT_EQ(again->getNumChildren(), 2u);
    EXPECT_TRUE(again->showsSurroundings());
    EXPECT_EQ(again->getChild(0), again->drawable());
    EXPECT_TRUE(again->editor());
    EXPECT_EQ(again->getBound(), terrain->getBound());
}

TEST_P(SceneFile, RefusesATerrainThatNoFileDescribes)
{
    const osg::ref_ptr<RoamTerrain> terrain =
        new RoamTerrain(testsupport::planarTile(testsupport::hills(33, 33)), nullptr);
    EXPECT_THAT(refusal(*terrain), HasSubstr("was not opened from a file"));
}

TEST_P(SceneFile, RefusesEditsAndFurtherChildren)
{
    const auto edited = opened();
    ASSERT_TRUE(edited->editor()->stamp({.radiusM = 300.0}));
    EXPECT_THAT(refusal(*edited), HasSubstr("has been edited"));
    const auto withChild = opened();
    withChild->addChild(new osg::Geode);
    EXPECT_THAT(refusal(*withChild), HasSubstr("has children besides its drawable"));
}

TEST_P(SceneFile, RefusesADrawableAlone)
{
    EXPECT_THAT(refusal(*opened()->drawable()), HasSubstr("write its RoamTerrain"));
}

TEST_P(SceneFile, ReadingNamesTheFileThatIsMissing)
{
    ASSERT_EQ(refusal(*opened()), "");
    std::filesystem::remove(_folder / "land.roam");
    auto read = osgDB::Registry::instance()->readNode(file(), nullptr);
    EXPECT_FALSE(read.validNode());
    EXPECT_THAT(read.message(), HasSubstr("land.roam"));
}

INSTANTIATE_TEST_SUITE_P(Formats, SceneFile, testing::Values("osgt", "osgb"));

TEST(SceneFileText, RefusesSettingsThatNobodyKnowsOrThatAreOutOfRange)
{
    TemporaryFolder folder;
    const auto messageFor = [&](const std::string& line)
    {
        RasterSpec spec;
        spec.columns = spec.rows = 9;
        spec.geoTransform = northUp3Seconds(9);
        spec.epsg = 4326;
        writeRaster(folder / "dem.tif", "GTiff", spec);
        const auto opened = osgTerrainROAM::openTerrain(folder / "dem.tif");
        if (!opened) return opened.error().message();
        const std::string file = (folder / "scene.osgt").string();
        EXPECT_TRUE(osgDB::Registry::instance()->writeNode(**opened, file, nullptr).success());
        std::string text = readBytes(file);
        const std::size_t at = text.find("errorTolerancePx=");
        if (at == std::string::npos) return "no such line in " + text;
        writeBytes(file, text.replace(at, text.find_first_of(" \n", at) - at, line));
        return osgDB::Registry::instance()->readNode(file, nullptr).message();
    };
    EXPECT_THAT(messageFor("errorTolerancePx=-1"), HasSubstr("RoamDrawable.errorTolerancePx"));
    EXPECT_THAT(messageFor("errorTolerancePx=1x"), HasSubstr("cannot be"));
    EXPECT_THAT(messageFor("colour=1"), HasSubstr("\"colour\" is not known"));
}

} // namespace
