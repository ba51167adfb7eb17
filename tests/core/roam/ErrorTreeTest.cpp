// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/ErrorTree.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

TEST(ErrorTree, OneSpikeIsTheErrorOfEverythingAboveIt)
{
    HeightField field = testsupport::hills(5, 5);
    std::fill(field.heightsM.begin(), field.heightsM.end(), 0.0f);
    field.heightsM[2 * 5 + 1] = 10.0f; // row 2, column 1: an edge middle of the finest squares
    const PlacedTile tile(field, Placement::planar);
    const ErrorTree errors(tile);
    EXPECT_EQ(errors.errorM(2 * 5 + 1), 10.0f);
    EXPECT_EQ(errors.errorM(1 * 5 + 1), 10.0f); // the centres whose diamonds hold it
    EXPECT_EQ(errors.errorM(3 * 5 + 1), 10.0f);
    EXPECT_EQ(errors.errorM(2 * 5 + 2), 10.0f); // the tile's centre
    EXPECT_EQ(errors.errorM(2 * 5 + 3), 0.0f);  // away from it nothing
    EXPECT_EQ(errors.errorM(1 * 5 + 3), 0.0f);
}

TEST(ErrorTree, CountsEverySampleNotOnlyTheMiddles)
{
    HeightField field = testsupport::hills(9, 9);
    std::fill(field.heightsM.begin(), field.heightsM.end(), 0.0f);
    field.heightsM[1 * 9 + 3] = 7.0f;
    const ErrorTree errors(PlacedTile(field, Placement::planar));
    EXPECT_EQ(errors.errorM(4 * 9 + 4), 7.0f);
}

TEST(ErrorTree, RadiiAndErrorsNest)
{
    for (const int side : {3, 5, 17, 65})
    {
        const PlacedTile tile(testsupport::hills(side, side), Placement::planar);
        EXPECT_TRUE(ErrorTree(tile).isNested(tile));
    }
}

TEST(ErrorTree, NestingCheckSeesATreeOfOtherHeights)
{
    const PlacedTile tile(testsupport::hills(33, 33), Placement::planar);
    HeightField stretched = testsupport::hills(33, 33, 31.0);
    EXPECT_FALSE(ErrorTree(tile).isNested(PlacedTile(stretched, Placement::planar)));
}

TEST(ErrorTree, IsTheSameEveryTime)
{
    const PlacedTile tile(testsupport::hills(129, 100), Placement::planar);
    const ErrorTree one(tile), two(tile);
    for (SampleIndex v = 0; v < 129 * 129; ++v)
    {
        ASSERT_EQ(one.errorM(v), two.errorM(v));
        ASSERT_EQ(one.radiusM(v), two.radiusM(v));
    }
}

} // namespace
