// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "simulation/vehicle/Table.h"

namespace
{

using simulation::Table;

// By hand: rows 0 and 2, columns 10 and 20.
TEST(FlightTableTest, IsLinearBetweenPointsAndConstantBeyond)
{
    const auto table = Table::of({0.0, 2.0}, {10.0, 20.0}, {1.0, 3.0, 5.0, 9.0});
    ASSERT_TRUE(table);
    EXPECT_DOUBLE_EQ(table->at(0.0, 10.0), 1.0);
    EXPECT_DOUBLE_EQ(table->at(1.0, 15.0), 4.5);
    EXPECT_DOUBLE_EQ(table->at(2.0, 15.0), 7.0);
    EXPECT_DOUBLE_EQ(table->at(-5.0, 5.0), 1.0);
    EXPECT_DOUBLE_EQ(table->at(9.0, 99.0), 9.0);
}

TEST(FlightTableTest, SaysWhatIsWrong)
{
    EXPECT_FALSE(Table::of({0.0, 1.0}, {0.0}, {1.0}));
    EXPECT_FALSE(Table::of({1.0, 1.0}, {0.0}, {1.0, 2.0}));
    EXPECT_FALSE(Table::of({}, {0.0}, {}));
    EXPECT_FALSE(Table::of({0.0}, {0.0}, {std::numeric_limits<double>::quiet_NaN()}));
}

} // namespace
