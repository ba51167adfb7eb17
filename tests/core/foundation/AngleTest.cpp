// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <foundation/Angle.h>
#include <gtest/gtest.h>

namespace foundation
{

static_assert(radiansOf(0.0) == 0.0 && degreesOf(0.0) == 0.0);

TEST(AngleTest, ConvertsBothWays)
{
    EXPECT_DOUBLE_EQ(radiansOf(180.0), std::acos(-1.0));
    EXPECT_DOUBLE_EQ(radiansOf(-90.0), std::asin(-1.0));
    EXPECT_DOUBLE_EQ(degreesOf(std::atan(1.0)), 45.0);
    EXPECT_DOUBLE_EQ(degreesOf(radiansOf(12.5)), 12.5);
}

TEST(AngleTest, WrapsToHalfATurn)
{
    EXPECT_DOUBLE_EQ(wrappedDeg(270.0), -90.0);
    EXPECT_DOUBLE_EQ(wrappedDeg(-725.0), -5.0);
    EXPECT_NEAR(wrappedRad(radiansOf(190.0)), radiansOf(-170.0), 1e-15);
}

} // namespace foundation
