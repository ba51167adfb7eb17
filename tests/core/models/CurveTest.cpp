// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/vehicles/Curve.h"

#include <gtest/gtest.h>

using scenery::models::Curve;

TEST(Curve, GoesThroughItsPointsAndStaysBeyondThem)
{
    const Curve curve({{0.0, 1.0}, {1.0, 3.0}, {3.0, 2.0}});
    EXPECT_DOUBLE_EQ(curve(0.0), 1.0);
    EXPECT_DOUBLE_EQ(curve(1.0), 3.0);
    EXPECT_DOUBLE_EQ(curve(3.0), 2.0);
    EXPECT_DOUBLE_EQ(curve(-5.0), 1.0);
    EXPECT_DOUBLE_EQ(curve(9.0), 2.0);
}

TEST(Curve, NeverOvershoots)
{
    const Curve curve({{0.0, 0.0}, {1.0, 0.0}, {1.1, 1.0}, {2.0, 1.0}, {2.5, 0.9}});
    double before = -1.0;
    for (int i = 0; i <= 2000; ++i)
    {
        const double x = 0.001 * i;
        EXPECT_GE(curve(x), -1e-12);
        EXPECT_LE(curve(x), 1.0 + 1e-12);
        EXPECT_GE(curve(x), before - 1e-12);
        before = curve(x);
    }
}

TEST(Curve, AStraightLineIsOne)
{
    const Curve line({{0.0, 1.0}, {1.0, 2.0}, {4.0, 5.0}});
    EXPECT_NEAR(line(0.3), 1.3, 1e-12);
    EXPECT_NEAR(line(2.7), 3.7, 1e-12);
}
