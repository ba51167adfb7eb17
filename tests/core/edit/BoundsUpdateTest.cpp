// SPDX-License-Identifier: Apache-2.0
// Compares bounds after edits with those of a tile newly made from the edited heights.
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using Between = TileEditor::Between;

PlacedTileOptions options(bool curved, int gridExponent = 0)
{
    return {.placement = curved ? Placement::curved : Placement::planar, .gridExponent = gridExponent};
}

constexpr double kTiny = 1e-4; ///< the least error that is kept is 0.06 mm

/// Tells whether the bounds are nested: every view that activates a vertex activates its ancestors.
bool isNested(const RoamTile& tile)
{
    bool nested = true;
    const int side = tile.tile.grid().side();
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
        {
            if (column % (side - 1) == 0 && row % (side - 1) == 0) continue;
            const SplitBound bound = tile.bound({column, row});
            SplitDiamond({column, row}, side)
                .forEachChild(
                    [&](GridPoint c)
                    {
                        const SplitBound child = tile.bound(c);
                        if (child.errorM <= 0.0f) return;
                        const double reachM =
                            glm::distance(glm::dvec3(bound.centre), glm::dvec3(child.centre)) + child.radiusM;
                        nested = nested && bound.errorM >= child.errorM && bound.radiusM >= reachM;
                    });
        }
    return nested;
}

/// A tile with an editor, and a copy of the field that receives the same edits.
struct Edited
{
    Edited(int columns, int rows, bool isCurved)
        : curved(isCurved),
          field(curved ? testsupport::onTheEarth(testsupport::hills(columns, rows))
                       : testsupport::hills(columns, rows)),
          tile(std::make_shared<RoamTile>(PlacedTile(field, options(curved)))),
          editor(tile)
    {
    }

    /// Heights within the table's range, in multiples of 1/64 m: both tables keep them exactly.
    void set(const std::vector<HeightChange>& changes)
    {
        for (const HeightChange& change : changes)
            field.heightsM[static_cast<std::size_t>(change.place.row) * field.columns + change.place.column] =
                change.heightM;
        ASSERT_TRUE(editor.apply(changes, Between::follows));
    }

    HeightChange randomChange(testsupport::Random& random) const
    {
        const GridPoint p{static_cast<int>(random.below(field.columns)),
                          static_cast<int>(random.below(field.rows))};
        return {p, static_cast<float>(std::floor((100.0 + 600.0 * random.unit()) * 64.0) / 64.0)};
    }

    /// Of the tile: no triangle is split there.
    bool isCorner(int column, int row) const
    {
        const int last = tile->tile.grid().side() - 1;
        return column % last == 0 && row % last == 0;
    }

    template<class Compare>
    void compareWithNew(const Compare& compare) const
    {
        const RoamTile fresh(PlacedTile(field, options(curved)));
        for (int row = 0; row < tile->tile.grid().side(); ++row)
            for (int column = 0; column < tile->tile.grid().side(); ++column)
                if (!isCorner(column, row))
                    compare(GridPoint{column, row}, tile->bound({column, row}), fresh.bound({column, row}));
    }

    bool curved;
    HeightField field;
    std::shared_ptr<RoamTile> tile;
    TileEditor editor;
};

class BoundsAfterEdits : public testing::TestWithParam<std::tuple<int, int, bool>>
{
protected:
    Edited edited{std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
};

TEST_P(BoundsAfterEdits, AreNeverTooSmall)
{
    testsupport::Random random(3);
    for (int step = 0; step < 60; ++step)
    {
        std::vector<HeightChange> changes;
        for (std::uint32_t i = 0; i <= random.below(8); ++i)
            changes.push_back(edited.randomChange(random));
        edited.set(changes);
    }
    std::size_t larger = 0;
    edited.compareWithNew(
        [&](GridPoint v, const SplitBound& kept, const SplitBound& wanted)
        {
            ASSERT_EQ(kept.centre, wanted.centre) << v.column << ", " << v.row;
            ASSERT_GE(kept.errorM, 0.999 * wanted.errorM - kTiny) << v.column << ", " << v.row;
            larger += kept.errorM > 1.01f * wanted.errorM ? 1 : 0;
        });
    EXPECT_LT(larger, 200u) << "only the coarsest may be loose";
}

TEST_P(BoundsAfterEdits, Nest)
{
    testsupport::Random random(4);
    for (int step = 0; step < 60; ++step)
        edited.set({edited.randomChange(random), edited.randomChange(random)});
    EXPECT_TRUE(isNested(*edited.tile));
    edited.tile->setBound({31, 31}, 1e6f, 1.0f);
    EXPECT_FALSE(isNested(*edited.tile)) << "the check must be able to fail";
}

TEST_P(BoundsAfterEdits, AreExactOnceTightened)
{
    testsupport::Random random(5);
    for (int step = 0; step < 40; ++step)
        edited.set({edited.randomChange(random)});
    EXPECT_FALSE(edited.tile->looseVertices().empty());
    while (!edited.editor.tighten(1000))
    {
    }
    EXPECT_TRUE(edited.tile->looseVertices().empty());
    edited.compareWithNew(
        [&](GridPoint v, const SplitBound& kept, const SplitBound& wanted)
        {
            EXPECT_NEAR(kept.errorM, wanted.errorM, 0.001 * wanted.errorM + kTiny)
                << v.column << ", " << v.row;
            EXPECT_LE(kept.radiusM, 1.05 * wanted.radiusM) << v.column << ", " << v.row;
        });
}

TEST_P(BoundsAfterEdits, AreWhatTheyWereAfterUndo)
{
    const Edited untouched = {std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
    testsupport::Random random(7);
    for (int step = 0; step < 30; ++step)
        edited.set({edited.randomChange(random), edited.randomChange(random)});
    EXPECT_EQ(edited.editor.undoSteps(), 30u);
    while (edited.editor.undo())
    {
    }
    for (int row = 0; row < untouched.tile->tile.grid().side(); ++row)
        for (int column = 0; column < untouched.tile->tile.grid().side(); ++column)
        {
            const SplitBound is = edited.tile->bound({column, row}),
                             was = untouched.tile->bound({column, row});
            ASSERT_EQ(is.centre, was.centre);
            ASSERT_EQ(is.errorM, was.errorM);
            ASSERT_EQ(is.radiusM, was.radiusM);
        }
}

INSTANTIATE_TEST_SUITE_P(Tiles, BoundsAfterEdits,
                         testing::Values(std::tuple{65, 65, false}, std::tuple{65, 65, true},
                                         std::tuple{50, 40, false}, std::tuple{65, 41, true}));

/// Mutation: the comparison detects a bound that BoundsUpdate has not updated.
TEST(BoundsUpdate, AForgottenUpdateShows)
{
    Edited edited(65, 65, false);
    edited.field.heightsM[20 * 65 + 20] += 100.0f;
    std::size_t tooSmall = 0;
    edited.compareWithNew([&](GridPoint, const SplitBound& kept, const SplitBound& wanted)
                          { tooSmall += kept.errorM < 0.999 * wanted.errorM ? 1 : 0; });
    EXPECT_GT(tooSmall, 5u);
}

/// A fine edit on a coarse raster gives the same surface as the same edit on a fine raster.
TEST(BoundsUpdate, BetweenSamplesTheyHoldForAllOfTheSurface)
{
    const auto tile = std::make_shared<RoamTile>(PlacedTile(testsupport::hills(17, 17), options(false, 3)));
    TileEditor editor(tile);
    testsupport::Random random(11);
    for (int step = 0; step < 25; ++step)
    {
        const GridPoint middle{10 + static_cast<int>(random.below(100)),
                               10 + static_cast<int>(random.below(100))};
        std::vector<HeightChange> changes;
        for (int row = -3; row <= 3; ++row)
            for (int column = -4; column <= 4; ++column)
                changes.push_back({{middle.column + column, middle.row + row},
                                   static_cast<float>(300.0 + 200.0 * random.unit())});
        ASSERT_TRUE(editor.apply(changes, Between::stays));
        if (step % 5 != 4) continue;
        const GridPoint sample{middle.column & -8, middle.row & -8};
        ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{sample, 250.0f}}, Between::follows));
    }
    const PlacedTile& placed = tile->tile;
    const int side = placed.grid().side();
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
        {
            if ((column == 0 || column == side - 1) && (row == 0 || row == side - 1)) continue;
            const SplitDiamond diamond({column, row}, side);
            const float kept = tile->bound({column, row}).errorM;
            double exact = 0.0;
            diamond.forEachTriangle(
                [&](const GridTriangle& t)
                {
                    const auto at = [&](GridPoint p) { return placed.position(p.column, p.row); };
                    t.forEachRow(side, side,
                                 [&](int r, int west, int east)
                                 {
                                     for (int c = west; c <= east; ++c)
                                     {
                                         const auto b = t.at(c, r);
                                         const glm::dvec3 drawn = at(t.apex) +
                                                                  b.u * (at(t.left) - at(t.apex)) +
                                                                  b.w * (at(t.right) - at(t.apex));
                                         exact = std::max(exact, glm::distance(drawn, at({c, r})));
                                     }
                                 });
                });
            ASSERT_GE(kept, exact - 1e-3) << column << ", " << row;
        }
}

} // namespace
