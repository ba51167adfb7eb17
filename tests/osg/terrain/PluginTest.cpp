// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgTerrainROAM/RoamTerrain>

#include "RasterWriter.h"

namespace
{

using osgTerrainROAM::RoamTerrain;

class RoamPlugin : public testing::Test
{
protected:
    void SetUp() override
    {
        osgDB::Registry::instance()->setLibraryFilePathList(OSGTRAINER_PLUGIN_FOLDER);
        RasterSpec spec;
        spec.columns = 40;
        spec.rows = 30;
        spec.geoTransform = northUp3Seconds(30);
        spec.epsg = 4326;
        writeRaster(_folder / "dem.tif", "GTiff", spec);
    }

    /// The class lives in this program and in the plugin: names tell, casts do not.
    static bool isTerrain(const osg::Object* object)
    {
        return object && std::string(object->libraryName()) == "osgTerrainROAM" &&
               std::string(object->className()) == "RoamTerrain";
    }

    static std::string messageOf(const std::filesystem::path& file)
    {
        return osgDB::Registry::instance()->readNode(file.string(), nullptr).message();
    }

    TemporaryFolder _folder;
};

} // namespace

TEST_F(RoamPlugin, OpensAnElevationRasterBySuffix)
{
    const auto node = osgDB::readRefNodeFile((_folder / "dem.tif.roam").string());
    EXPECT_TRUE(isTerrain(node));
    EXPECT_GT(node->getBound().radius(), 1000.0f);
}

TEST_F(RoamPlugin, OpensADescription)
{
    writeBytes(_folder / "place.roam", "dem = dem.tif\nerror_tolerance = 3\nvisibility = 5000\n");
    EXPECT_TRUE(isTerrain(osgDB::readRefNodeFile((_folder / "place.roam").string())));
    EXPECT_TRUE(isTerrain(osgDB::readRefObjectFile((_folder / "place.roam").string())));
}

TEST_F(RoamPlugin, OpensWhatGdalSeesThroughAGzip)
{
    writeGzip(_folder / "dem.tif.gz", readBytes(_folder / "dem.tif"));
    EXPECT_TRUE(isTerrain(osgDB::readRefNodeFile("/vsigzip/" + (_folder / "dem.tif.gz.roam").string())));
}

TEST_F(RoamPlugin, SaysFilePlaceAndRemedy)
{
    writeBytes(_folder / "bad.roam", "dem = dem.tif\nheight = 3\n");
    EXPECT_THAT(messageOf(_folder / "bad.roam"), testing::HasSubstr("bad.roam:2: unknown key 'height'"));
    EXPECT_THAT(messageOf(_folder / "none.tif.roam"), testing::HasSubstr("none.tif"));
    writeBytes(_folder / "text.tif", "no raster at all");
    EXPECT_THAT(messageOf(_folder / "text.tif.roam"), testing::HasSubstr("text.tif"));
}

TEST_F(RoamPlugin, LeavesOtherNamesToOthers)
{
    const auto result =
        osgDB::Registry::instance()->getReaderWriterForExtension("roam")->readNode("a.tif", nullptr);
    EXPECT_EQ(result.status(), osgDB::ReaderWriter::ReadResult::FILE_NOT_HANDLED);
}

TEST_F(RoamPlugin, TheLibraryOpensTheSameFiles)
{
    const auto terrain = osgTerrainROAM::openTerrain(_folder / "dem.tif");
    ASSERT_TRUE(terrain) << terrain.error().message();
    EXPECT_EQ((*terrain)->tile()->tile.grid().dataColumns(), 40);
    EXPECT_FALSE(osgTerrainROAM::openTerrain(_folder / "none.tif"));
}
