// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace
{

using osgTerrainROAM::core::HeightField;

HeightField ramp(int columns, int rows)
{
    HeightField field;
    field.columns = columns;
    field.rows = rows;
    field.spacingEastM = field.spacingNorthM = 1.0;
    for (int i = 0; i < columns * rows; ++i)
        field.heightsM.push_back(static_cast<float>(i));
    return field;
}

TEST(HeightField, TileSideIsTheSmallestPowerOfTwoPlusOneThatHoldsTheGrid)
{
    EXPECT_EQ(ramp(2, 2).tileSide(), 3);
    EXPECT_EQ(ramp(3, 3).tileSide(), 3);
    EXPECT_EQ(ramp(4, 2).tileSide(), 5);
    EXPECT_EQ(ramp(5, 3).tileSide(), 5);
    EXPECT_EQ(ramp(2, 6).tileSide(), 9);
}

TEST(HeightField, HeightsBeyondTheDataRepeatTheEdge)
{
    const HeightField field = ramp(4, 3);
    EXPECT_EQ(field.heightM(1, 2), 9.0f);
    EXPECT_EQ(field.heightM(7, 1), 7.0f);
    EXPECT_EQ(field.heightM(2, 5), 10.0f);
    EXPECT_EQ(field.heightM(8, 8), 11.0f);
}

TEST(HeightField, IsCompleteNoticesAMissingSampleAndAVoid)
{
    HeightField field = ramp(4, 3);
    EXPECT_TRUE(field.isComplete());
    field.heightsM[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(field.isComplete());
    field = ramp(4, 3);
    field.heightsM.pop_back();
    EXPECT_FALSE(field.isComplete());
    EXPECT_FALSE(ramp(4, 1).isComplete());
}

} // namespace
