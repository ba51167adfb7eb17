// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/Hydrometeors.h"

#include <gtest/gtest.h>

namespace simulation
{
namespace
{

TEST(Hydrometeors, RainOfTenMillimetresByHand)
{
    // Slope 4.1 · 10^-0.21 = 2.5280 a mm. Above 2 mm: 8000 / 2.5280 · exp(-5.0561) = 20.17 a m³, of 2 + 1 /
    // 2.5280 mm in the mean.
    const Hydrometeors rain = rainOf(10.0);
    EXPECT_FALSE(rain.isSnow);
    EXPECT_NEAR(rain.perM3, 20.17, 0.02);
    EXPECT_NEAR(rain.sizeM, 2.3956e-3, 1e-6);
    EXPECT_NEAR(rain.fallMps, 7.203, 0.001);           // 9.65 - 10.3 exp(-0.6 · 2.3956)
    EXPECT_NEAR(rain.extinctionPerM, 1.5555e-3, 1e-6); // π · 8000 / 2.5280³ mm² a m³
}

TEST(Hydrometeors, HeavyRainLeavesLessThanTwoKilometresOfVisibility)
{
    // 3.00 / (3.00 / 60 000 + 1.5555e-3)
    EXPECT_NEAR(visibilityM(60000.0, rainOf(10.0)), 1866.0, 1.0);
    EXPECT_DOUBLE_EQ(visibilityM(300.0, rainOf(0.0)), 300.0);
}

TEST(Hydrometeors, SnowPartsLightFromModerateAndHeavy)
{
    EXPECT_TRUE(snowOf(1.0).isSnow);
    EXPECT_GT(visibilityM(1e9, snowOf(1.0)), 1000.0); // light
    EXPECT_LT(visibilityM(1e9, snowOf(1.3)), 1000.0); // moderate
    EXPECT_LT(visibilityM(1e9, snowOf(2.5)), 500.0);  // heavy
    // A flake of 5 mm has 3.27 mg: 1 mm an hour are 0.278 g a m² and second, so 85 flakes.
    EXPECT_NEAR(snowOf(1.0).perM3, 84.9, 0.1);
}

TEST(Hydrometeors, NothingFallsWhereNothingIsTold)
{
    for (const Hydrometeors& nothing : {rainOf(0.0), snowOf(0.0), rainOf(-1.0)})
    {
        EXPECT_EQ(nothing.perM3, 0.0);
        EXPECT_EQ(nothing.extinctionPerM, 0.0);
    }
}

} // namespace
} // namespace simulation
