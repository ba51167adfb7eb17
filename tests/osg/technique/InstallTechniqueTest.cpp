// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include <osg/PagedLOD>
#include <osg/ProxyNode>
#include <osgDB/ReadFile>
#include <osgTerrain/GeometryTechnique>

#include <osgTerrainROAM/RoamTechnique>

#include "TechniqueScene.h"

namespace
{

using namespace techniquescene;
using osgTerrain::TerrainTile;
using osgTerrainROAM::installTechnique;
using osgTerrainROAM::RoamTechnique;

class InstallTechnique : public testing::Test
{
protected:
    void SetUp() override
    {
        std::filesystem::remove_all(_folder);
        std::filesystem::create_directories(_folder);
    }
    void TearDown() override { std::filesystem::remove_all(_folder); }

    std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("technique." + std::to_string(::getpid()));
    osg::ref_ptr<RoamTechnique> _prototype = new RoamTechnique;
};

osg::PagedLOD* pagedOf(osg::Node& database)
{
    return dynamic_cast<osg::PagedLOD*>(database.asGroup()->getChild(0));
}

/// What the pager does for a paged file.
osg::ref_ptr<osg::Node> childrenOf(osg::PagedLOD& paged)
{
    const auto* options = dynamic_cast<const osgDB::Options*>(paged.getDatabaseOptions());
    return osgDB::readRefNodeFile(paged.getDatabasePath() + paged.getFileName(1), options);
}

bool isOurTile(const osg::Node* node)
{
    const auto* tile = dynamic_cast<const TerrainTile*>(node);
    return tile && dynamic_cast<const RoamTechnique*>(tile->getTerrainTechnique());
}

struct CountingReader : public osgDB::ReadFileCallback
{
    osgDB::ReaderWriter::ReadResult readNode(const std::string& name, const osgDB::Options* options) override
    {
        ++reads;
        return osgDB::ReadFileCallback::readNode(name, options);
    }
    int reads = 0;
};

} // namespace

TEST_F(InstallTechnique, ReachesTilesPrototypesAndPagedFiles)
{
    for (const char* extension : {"osgb", "osgt", "ive"})
    {
        const auto database = osgDB::readRefNodeFile(writePagedDatabase(_folder, 4000.0, extension).string());
        ASSERT_TRUE(database) << extension;
        const auto count = installTechnique(*database, *_prototype);
        EXPECT_EQ(count.tiles, 1u);
        EXPECT_EQ(count.pagedFiles, 1u);
        const auto* terrain = dynamic_cast<const osgTerrain::Terrain*>(database.get());
        EXPECT_TRUE(dynamic_cast<const RoamTechnique*>(terrain->getTerrainTechniquePrototype()));
        EXPECT_TRUE(isOurTile(pagedOf(*database)->getChild(0)));
        const auto children = childrenOf(*pagedOf(*database));
        ASSERT_TRUE(children) << extension;
        ASSERT_EQ(children->asGroup()->getNumChildren(), 4u);
        for (unsigned int i = 0; i < 4; ++i)
            EXPECT_TRUE(isOurTile(children->asGroup()->getChild(i))) << extension;
    }
}

TEST_F(InstallTechnique, WithoutItPagedTilesAreStock)
{
    // The mutation for the test above.
    const auto database = osgDB::readRefNodeFile(writePagedDatabase(_folder, 4000.0).string());
    const auto children = childrenOf(*pagedOf(*database));
    ASSERT_TRUE(children);
    EXPECT_FALSE(isOurTile(children->asGroup()->getChild(0)));
}

TEST_F(InstallTechnique, ReachesFilesThatPagedFilesPage)
{
    // children.osgb pages itself, once more.
    const auto file = writePagedDatabase(_folder, 4000.0);
    std::filesystem::copy(file, _folder / "children.osgb", std::filesystem::copy_options::overwrite_existing);
    auto level = osgDB::readRefNodeFile(file.string());
    installTechnique(*level, *_prototype);
    for (int depth = 0; depth < 3; ++depth)
    {
        level = childrenOf(*pagedOf(*level));
        ASSERT_TRUE(level);
        EXPECT_TRUE(isOurTile(pagedOf(*level)->getChild(0))) << depth;
    }
}

TEST_F(InstallTechnique, LeavesOptionsAndCallbacksThatAreThereAtWork)
{
    const auto database = osgDB::readRefNodeFile(writePagedDatabase(_folder, 4000.0).string());
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options("some option");
    osg::ref_ptr<CountingReader> reader = new CountingReader;
    options->setReadFileCallback(reader);
    pagedOf(*database)->setDatabaseOptions(options);
    for (int twice = 0; twice < 2; ++twice)
        installTechnique(*database, *_prototype);
    EXPECT_EQ(options->getReadFileCallback(), reader.get()) << "others may use these options, too";
    const auto* installed = dynamic_cast<const osgDB::Options*>(pagedOf(*database)->getDatabaseOptions());
    EXPECT_EQ(installed->getOptionString(), "some option");
    EXPECT_TRUE(isOurTile(childrenOf(*pagedOf(*database))->asGroup()->getChild(0)));
    EXPECT_EQ(reader->reads, 1);
}

TEST_F(InstallTechnique, ReplacesTheTechniqueOfATileThatHasBeenDrawn)
{
    const auto terrain = terrainOf(1, {});
    auto& tile = static_cast<TerrainTile&>(*terrain->getChild(0));
    tile.init(TerrainTile::ALL_DIRTY, false);
    EXPECT_TRUE(dynamic_cast<osgTerrain::GeometryTechnique*>(tile.getTerrainTechnique()));
    EXPECT_EQ(installTechnique(*terrain, *_prototype).tiles, 1u);
    EXPECT_TRUE(isOurTile(&tile));
    EXPECT_TRUE(tile.getDirty());
}

TEST_F(InstallTechnique, CountsNothingWhereThereIsNoTerrain)
{
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    const auto count = installTechnique(*group, *_prototype);
    EXPECT_EQ(count.tiles + count.pagedFiles, 0u);
}
