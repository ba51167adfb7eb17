// SPDX-License-Identifier: Apache-2.0
#include <utility>
#include <vector>

#include <foundation/KeptResults.h>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "KeptFiles.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using foundation::KeptResults;
using testsupport::filesIn;

HeightField field(double spacingM = 30.0)
{
    return testsupport::onTheEarth(testsupport::hills(70, 50, spacingM));
}

/// The bounds of all vertices of a tile, beyond its data, too.
std::vector<float> boundsOf(const RoamTile& tile)
{
    std::vector<float> bounds;
    for (int row = 0; row < tile.tile.grid().side(); ++row)
        for (int column = 0; column < tile.tile.grid().side(); ++column)
        {
            const SplitBound bound = tile.bound({column, row});
            bounds.push_back(bound.errorM);
            bounds.push_back(bound.radiusM);
        }
    return bounds;
}

TEST(KeptBounds, AreThoseThatWouldBeMeasured)
{
    const testsupport::TestFolder folder("kept-bounds");
    const KeptResults kept(folder / "made");
    for (const int exponent : {0, 2})
    {
        const auto placed = [&] { return PlacedTile(field(), PlacedTileOptions{.gridExponent = exponent}); };
        const RoamTile measured(placed()), first(placed(), &kept);
        ASSERT_FALSE(measured.verticesBeyond().empty());
        EXPECT_EQ(boundsOf(first), boundsOf(measured));
        const auto files = filesIn(folder / "made");
        const RoamTile second(placed(), &kept);
        EXPECT_EQ(boundsOf(second), boundsOf(measured));
        EXPECT_EQ(filesIn(folder / "made"), files); // found, not measured
    }
    EXPECT_EQ(filesIn(folder / "made").size(), 2U);
}

TEST(KeptBounds, WhateverDiffersIsAnotherFile)
{
    const testsupport::TestFolder folder("kept-bounds-differ");
    const KeptResults kept(folder / "made");
    HeightField higher = field(), moved = field();
    higher.heightsM[100] += 1.0f;
    moved.net->nodes.front().geoidM += 1.0;
    HeightField holed = field();
    std::vector<std::uint8_t> isThere(holed.heightsM.size(), 1);
    isThere[200] = 0;
    holed.mask = SampleMask(isThere, holed.columns, holed.rows);
    const std::vector<std::pair<HeightField, PlacedTileOptions>> tiles{
        {field(), {}},
        {field(), {.placement = Placement::planar}},
        {field(29.0), {}},
        {field(), {.origin = Geodetic{46.0, 8.0, 10.0}}},
        {field(), {.storage = Storage::exact}},
        {field(), {.gridExponent = 1}},
        {higher, {}},
        {moved, {}},
        {holed, {}}};
    for (const auto& [heights, options] : tiles)
        EXPECT_EQ(boundsOf(RoamTile(PlacedTile(heights, options), &kept)),
                  boundsOf(RoamTile(PlacedTile(heights, options))));
    EXPECT_EQ(filesIn(folder / "made").size(), tiles.size());
}

TEST(KeptBounds, NonsenseOfTheRightCheckSumIsMeasuredAnew)
{
    const testsupport::TestFolder folder("kept-bounds-nonsense");
    const KeptResults kept(folder / "made");
    const RoamTile first(PlacedTile(field()), &kept);
    testsupport::writeNonsense(folder / "made");
    const auto files = filesIn(folder / "made");
    EXPECT_EQ(boundsOf(RoamTile(PlacedTile(field()), &kept)), boundsOf(first));
    EXPECT_NE(filesIn(folder / "made"), files);
}

} // namespace
