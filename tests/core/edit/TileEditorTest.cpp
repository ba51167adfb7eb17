// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using Between = TileEditor::Between;

std::shared_ptr<RoamTile> tileOf(int side, int gridExponent)
{
    return std::make_shared<RoamTile>(PlacedTile(
        testsupport::hills(side, side), {.placement = Placement::planar, .gridExponent = gridExponent}));
}

double heightAt(const RoamTile& tile, double x, double y)
{
    return groundAt(tile.tile, x, y)->position.z;
}

TEST(TileEditor, KeepsHeightsToHalfAMillimetre)
{
    const auto tile = tileOf(17, 0);
    TileEditor editor(tile);
    for (const float heightM : {123.4567f, -77.123f, 9000.25f, -0.0004f})
    {
        ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{{5, 6}, heightM}}, Between::follows));
        EXPECT_NEAR(tile->tile.samples().heightM(5, 6), heightM, 0.0005);
        EXPECT_NEAR(heightAt(*tile, 150.0, 180.0), heightM, 0.0005);
    }
    EXPECT_EQ(editor.undoSteps(), 4u);
}

TEST(TileEditor, TheSurfaceBetweenSamplesFollowsTheRaster)
{
    const auto tile = tileOf(17, 4);
    const double before = heightAt(*tile, 165.0, 180.0);
    TileEditor editor(tile);
    const float was = tile->tile.samples().heightM(5 * 16, 6 * 16);
    ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{{5 * 16, 6 * 16}, was + 8.0f}}, Between::follows));
    EXPECT_NEAR(heightAt(*tile, 165.0, 180.0), before + 4.0, 0.02) << "half-way to the next sample";
}

TEST(TileEditor, OrStaysAsItIsUpToTheNextPlace)
{
    const auto tile = tileOf(17, 4);
    const double step = 30.0 / 16.0, x = 165.0, y = 180.0;
    const double beside = heightAt(*tile, x + step, y), far = heightAt(*tile, x + 5.0, y);
    TileEditor editor(tile);
    const GridPoint p{88, 96};
    ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{p, 777.0f}}, Between::stays));
    EXPECT_NEAR(heightAt(*tile, x, y), 777.0, 1e-4);
    EXPECT_NEAR(heightAt(*tile, x + step, y), beside, 1e-4);
    EXPECT_NEAR(heightAt(*tile, x + 5.0, y), far, 1e-4);
    EXPECT_NEAR(heightAt(*tile, x + 0.5 * step, y), 0.5 * (777.0 + beside), 1e-3);
    ASSERT_TRUE(editor.undo());
    EXPECT_FALSE(tile->tile.samples().hasSample(p.column, p.row));
    EXPECT_NEAR(heightAt(*tile, x + step, y), beside, 1e-9);
}

/// A fine edit of a raster sample does not move the surface around it.
TEST(TileEditor, AFineEditOfASampleStaysWhereItIs)
{
    const auto tile = tileOf(17, 4);
    const double before = heightAt(*tile, 165.0, 180.0);
    TileEditor editor(tile);
    ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{{80, 96}, 900.0f}}, Between::stays));
    EXPECT_NEAR(heightAt(*tile, 150.0, 180.0), 900.0, 1e-4);
    EXPECT_NEAR(heightAt(*tile, 165.0, 180.0), before, 1e-4);
}

TEST(TileEditor, RefusesWhatCannotBe)
{
    const auto tile = tileOf(17, 2);
    TileEditor editor(tile);
    const auto refuses = [&](GridPoint p, float heightM, Between between)
    {
        const auto outcome = editor.apply(std::vector<HeightChange>{{{4, 4}, 1.0f}, {p, heightM}}, between);
        return !outcome && !outcome.error().remedy.empty();
    };
    const float before = tile->tile.samples().heightM(4, 4);
    EXPECT_TRUE(refuses({65, 3}, 10.0f, Between::stays));
    EXPECT_TRUE(refuses({3, -1}, 10.0f, Between::stays));
    EXPECT_TRUE(refuses({3, 3}, 10.0f, Between::follows)) << "no sample there";
    EXPECT_TRUE(refuses({4, 8}, std::numeric_limits<float>::quiet_NaN(), Between::stays));
    EXPECT_TRUE(refuses({4, 8}, 30000.0f, Between::stays));
    EXPECT_EQ(tile->tile.samples().heightM(4, 4), before) << "all or nothing";
    EXPECT_EQ(editor.undoSteps(), 0u);
    EXPECT_EQ(tile->revision(), 0u);
    EXPECT_FALSE(editor.undo());
}

TEST(TileEditor, UndoAfterTighteningKeepsTheBounds)
{
    const auto tile = tileOf(65, 0), untouched = tileOf(65, 0);
    TileEditor editor(tile);
    ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{{30, 30}, 650.0f}}, Between::follows));
    ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{{32, 32}, 20.0f}}, Between::follows));
    while (!editor.tighten())
    {
    }
    while (editor.undo())
    {
    }
    for (int row = 0; row < 65; ++row)
        for (int column = 0; column < 65; ++column)
        {
            EXPECT_EQ(tile->tile.samples().heightM(column, row),
                      untouched->tile.samples().heightM(column, row));
            EXPECT_GE(tile->errorM({column, row}), untouched->errorM({column, row}));
        }
}

} // namespace
