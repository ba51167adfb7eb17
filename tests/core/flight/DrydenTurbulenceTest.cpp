// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/DrydenTurbulence.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

constexpr double kStepS = 1.0 / 120.0;

TEST(DrydenTurbulenceTest, HasTheStrengthOfItsHeight)
{
    // By hand at 500 ft in 15.4 m/s at 6 m: L_u = 500/(0.177 + 0.4115)^1.2 ft, σ_u = σ_w/(0.5885)^0.4.
    const auto low = DrydenTurbulence::strengthOf({50.0, 152.4, 15.4, 1.5, 11.0});
    EXPECT_NEAR(low.lengthM.z, 152.4, 1e-9);
    EXPECT_NEAR(low.lengthM.x, 152.4 / std::pow(0.5885, 1.2), 1e-6);
    EXPECT_NEAR(low.deviationMps.z, 1.54, 1e-12);
    EXPECT_NEAR(low.deviationMps.x, 1.54 / std::pow(0.5885, 0.4), 1e-9);
    const auto high = DrydenTurbulence::strengthOf({50.0, 3000.0, 15.4, 1.5, 11.0});
    EXPECT_EQ(high.deviationMps, glm::dvec3(1.5));
    EXPECT_NEAR(high.lengthM.x, 533.4, 1e-9);
}

// The deviation of half an hour of gusts, and their correlation after the scale's time, are those of the
// spectrum.
TEST(DrydenTurbulenceTest, GustsHaveTheirDeviationAndScale)
{
    const TurbulenceConditions conditions{100.0, 3000.0, 0.0, 2.0, 11.0};
    DrydenTurbulence turbulence(1);
    const int lag = static_cast<int>(533.4 / 100.0 / kStepS);
    std::vector<double> along, down;
    double rollSquare = 0.0;
    for (int i = 0; i < 600000; ++i)
    {
        turbulence.step(conditions, kStepS);
        along.push_back(turbulence.velocity().x);
        down.push_back(turbulence.velocity().z);
        rollSquare += turbulence.rates().x * turbulence.rates().x;
    }
    const auto mean = [](const std::vector<double>& values, std::size_t apart)
    {
        double sum = 0.0;
        for (std::size_t i = apart; i < values.size(); ++i)
            sum += values[i] * values[i - apart];
        return sum / static_cast<double>(values.size() - apart);
    };
    EXPECT_NEAR(std::sqrt(mean(along, 0)), 2.0, 0.15);
    EXPECT_NEAR(std::sqrt(mean(down, 0)), 2.0, 0.15);
    EXPECT_NEAR(mean(along, static_cast<std::size_t>(lag)) / mean(along, 0), std::exp(-1.0), 0.08);
    // The transverse correlation is (1 - x/2)·exp(-x) after x scales.
    EXPECT_NEAR(mean(down, static_cast<std::size_t>(lag)) / mean(down, 0), 0.5 * std::exp(-1.0), 0.08);
    const double roll = 2.0 * std::sqrt(0.8 * 9.8696 / 8.0 * std::cbrt(0.7854)) / std::cbrt(533.4 * 121.0);
    EXPECT_NEAR(std::sqrt(rollSquare / 600000.0), roll, 0.05 * roll);
}

TEST(DrydenTurbulenceTest, TheSeedDecidesAll)
{
    const TurbulenceConditions conditions{50.0, 300.0, 10.0, 2.0, 11.0};
    DrydenTurbulence first(7), second(7), other(8);
    for (int i = 0; i < 100; ++i)
        for (DrydenTurbulence* turbulence : {&first, &second, &other})
            turbulence->step(conditions, kStepS);
    EXPECT_EQ(first.velocity(), second.velocity());
    EXPECT_EQ(first.rates(), second.rates());
    EXPECT_NE(first.velocity(), other.velocity());
}

} // namespace
