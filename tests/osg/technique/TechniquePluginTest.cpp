// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osg/PagedLOD>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include "TechniqueScene.h"

namespace
{

using namespace techniquescene;

class TechniquePlugin : public testing::Test
{
protected:
    void SetUp() override
    {
        osgDB::Registry::instance()->getLibraryFilePathList().push_front(OSGTRAINER_PLUGIN_FOLDER);
        std::filesystem::create_directories(_folder);
    }
    void TearDown() override
    {
        osgDB::Registry::instance()->getLibraryFilePathList().pop_front();
        std::filesystem::remove_all(_folder);
    }

    std::string messageOf(const std::string& name) const
    {
        return osgDB::Registry::instance()->readNode((_folder / name).string(), nullptr).message();
    }

    std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("technique-plugin." + std::to_string(::getpid()));
};

/// The class lives in this program and in the plugin: names tell, casts do not.
bool isOurs(const osg::Node* node)
{
    const auto* tile = dynamic_cast<const osgTerrain::TerrainTile*>(node);
    return tile && tile->getTerrainTechnique() &&
           std::string(tile->getTerrainTechnique()->className()) == "RoamTechnique";
}

} // namespace

TEST_F(TechniquePlugin, OpensADatabaseBySuffixAndItsPagedFilesToo)
{
    for (const char* extension : {"osgb", "ive"})
    {
        const auto file = writePagedDatabase(_folder, 4000.0, extension);
        const auto database = osgDB::readRefNodeFile(file.string() + ".roam");
        ASSERT_TRUE(database);
        auto* const paged = dynamic_cast<osg::PagedLOD*>(database->asGroup()->getChild(0));
        EXPECT_TRUE(isOurs(paged->getChild(0)));
        const auto* options = dynamic_cast<const osgDB::Options*>(paged->getDatabaseOptions());
        const auto children =
            osgDB::readRefNodeFile(paged->getDatabasePath() + paged->getFileName(1), options);
        ASSERT_TRUE(children) << extension;
        EXPECT_TRUE(isOurs(children->asGroup()->getChild(3)));
    }
}

TEST_F(TechniquePlugin, FindsADatabaseOnTheSearchPathOfItsOptions)
{
    writePagedDatabase(_folder, 4000.0);
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->getDatabasePathList().push_back(_folder.string());
    EXPECT_TRUE(osgDB::readRefNodeFile("database.osgb.roam", options));
    EXPECT_FALSE(osgDB::readRefNodeFile("database.osgb.roam"));
}

TEST_F(TechniquePlugin, SaysWhyADatabaseCannotBeOpened)
{
    EXPECT_THAT(messageOf("none.osgb.roam"), testing::HasSubstr("none.osgb"));
    std::ofstream(_folder / "broken.osgb") << "no database at all";
    EXPECT_THAT(messageOf("broken.osgb.roam"), testing::HasSubstr("broken.osgb: "));
    osgDB::writeNodeFile(*osg::ref_ptr<osg::Group>(new osg::Group), (_folder / "bare.osgb").string());
    EXPECT_THAT(
        messageOf("bare.osgb.roam"),
        testing::EndsWith("bare.osgb: has no osgTerrain tile and pages no file in; open it without .roam"));
    std::ofstream(_folder / "words.txt") << "no database at all";
    EXPECT_THAT(messageOf("words.txt.roam"), testing::HasSubstr("words.txt"));
}
