// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/EditFile.h>
#include <osgTerrainROAM/core/edit/GroundEditor.h>

#include "SyntheticField.h"
#include "TestFolder.h"

namespace
{

using namespace osgTerrainROAM::core;

std::shared_ptr<RoamTile> freshTile(int side, int gridExponent)
{
    return std::make_shared<RoamTile>(PlacedTile(
        testsupport::hills(side, side), {.placement = Placement::planar, .gridExponent = gridExponent}));
}

/// A tile with finer samples, moved samples of the raster, and edits at the edge of the data.
std::shared_ptr<RoamTile> editedTile()
{
    auto tile = freshTile(30, 3);
    GroundEditor editor(tile);
    EXPECT_TRUE(editor.stamp({.centre = {300.0, 310.0}, .radiusM = 20.0, .depthM = 9.0}));
    EXPECT_TRUE(editor.raise(Region::circle({869.0, 500.0}, 40.0), 25.0));
    editor.setDetail(EditDetail::samples);
    EXPECT_TRUE(editor.raise(Region::circle({200.0, 700.0}, 90.0), 60.0));
    return tile;
}

/// The points of a tile whose heights or bounds differ from another's.
std::size_t differences(const RoamTile& a, const RoamTile& b)
{
    std::size_t count = 0;
    const int side = a.tile.grid().side();
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
        {
            const SplitBound one = a.bound({column, row}), other = b.bound({column, row});
            const bool isSame =
                one.centre == other.centre && one.errorM == other.errorM && one.radiusM == other.radiusM &&
                a.tile.samples().hasSample(column, row) == b.tile.samples().hasSample(column, row);
            count += isSame ? 0 : 1;
        }
    return count;
}

class EditFile : public testing::Test
{
protected:
    void SetUp() override { ASSERT_TRUE(writeEdits(*freshTile(30, 3), *edited, 7, file)); }

    foundation::Outcome read(RoamTile& tile, std::uint64_t source = 7) const
    {
        return readEdits(tile, source, file);
    }

    std::shared_ptr<RoamTile> edited = editedTile();
    testsupport::TestFolder folder{"edits"};
    std::filesystem::path file = folder / "ground.edits";
};

} // namespace

TEST_F(EditFile, ATileGetsTheSameHeightsAndBoundsBack)
{
    const auto tile = freshTile(30, 3);
    EXPECT_GT(differences(*tile, *edited), 500u); // the comparison can fail
    ASSERT_TRUE(read(*tile));
    EXPECT_EQ(differences(*tile, *edited), 0u);
    EXPECT_EQ(tile->looseVertices().size(), edited->looseVertices().size());
    EXPECT_EQ(tile->hidingGround.lowestM, edited->hidingGround.lowestM);
    const auto spheres = tile->regions.spheres(), kept = edited->regions.spheres();
    for (std::size_t i = 0; i < spheres.size(); ++i)
        EXPECT_EQ(spheres[i].radiusM, kept[i].radiusM);
}

TEST_F(EditFile, EditsGoOnFromThere)
{
    const auto tile = freshTile(30, 3);
    ASSERT_TRUE(read(*tile));
    for (const auto& edit : {tile, edited})
    {
        GroundEditor editor(edit);
        ASSERT_TRUE(editor.raise(Region::circle({305.0, 300.0}, 60.0), 4.0));
        while (!editor.steps().tighten())
            ;
    }
    EXPECT_EQ(differences(*tile, *edited), 0u);
}

TEST_F(EditFile, OtherDataAndOtherSourcesAreRefused)
{
    const auto other = freshTile(29, 3), coarser = freshTile(30, 2), tile = freshTile(30, 3);
    EXPECT_NE(read(*other).error().message().find("other elevation data"), std::string::npos);
    EXPECT_NE(read(*coarser).error().message().find("other elevation data"), std::string::npos);
    EXPECT_NE(read(*tile, 8).error().message().find("other roads"), std::string::npos);
    EXPECT_EQ(differences(*tile, *freshTile(30, 3)), 0u);
}

TEST_F(EditFile, DamagedFilesAreRefusedAndChangeNothing)
{
    const std::string whole = testsupport::bytesOf(file);
    std::mt19937 random(1);
    const auto tile = freshTile(30, 3), untouched = freshTile(30, 3);
    for (int i = 0; i < 200; ++i)
    {
        std::string damaged = whole;
        if (i % 2 == 0)
            damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
        else
            damaged.resize(random() % damaged.size());
        std::ofstream(file, std::ios::binary) << damaged;
        EXPECT_FALSE(read(*tile)) << i;
    }
    EXPECT_EQ(differences(*tile, *untouched), 0u);
}
