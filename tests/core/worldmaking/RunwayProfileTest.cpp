// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/RunwayProfile.h"

#include <cmath>

#include <gtest/gtest.h>

using worldmaking::runwayLimits;
using worldmaking::runwayProfile;

namespace
{

/// The steepest part and the sharpest change of slope of heights 10 m apart.
struct Figures
{
    double slope = 0.0, leastRadiusM = 1e12;
};

Figures figuresOf(const std::vector<double>& heights)
{
    Figures figures;
    for (std::size_t i = 1; i < heights.size(); ++i)
        figures.slope = std::max(figures.slope, std::abs(heights[i] - heights[i - 1]) / 10.0);
    for (std::size_t i = 1; i + 1 < heights.size(); ++i)
        figures.leastRadiusM =
            std::min(figures.leastRadiusM,
                     100.0 / std::max(std::abs(heights[i - 1] - 2.0 * heights[i] + heights[i + 1]), 1e-12));
    return figures;
}

/// Ground as elevation data have it: a slope, a swell and noise.
std::vector<double> ground(double slope, double swellM)
{
    std::vector<double> heights;
    for (int i = 0; i <= 120; ++i)
        heights.push_back(500.0 + 10.0 * slope * i + swellM * std::sin(0.08 * i) + 1.5 * std::sin(3.7 * i));
    return heights;
}

} // namespace

TEST(RunwayProfile, KeepsTheLimitsOfItsLengthOverRoughGround)
{
    const auto limits = runwayLimits(1200.0);
    EXPECT_EQ(limits.code, 3);
    for (const double slope : {0.0, 0.006, -0.009})
        for (const double swell : {0.0, 2.0, 6.0})
        {
            const auto rough = ground(slope, swell);
            const auto profile = runwayProfile(rough, 10.0, limits);
            const Figures figures = figuresOf(profile.heightsM);
            EXPECT_LE(figures.slope, limits.slope * 1.0001);
            EXPECT_GE(figures.leastRadiusM, limits.leastRadiusM * 0.9999);
            EXPECT_FALSE(profile.isSteep);
            EXPECT_GT(figuresOf(rough).slope, limits.slope) << "the ground itself breaks them";
        }
}

TEST(RunwayProfile, FollowsASwellRatherThanCutThroughIt)
{
    const auto swell = ground(0.0, 3.0);
    const auto profile = runwayProfile(swell, 10.0, runwayLimits(700.0));
    double followed = 0.0, straight = 0.0;
    for (std::size_t i = 0; i < swell.size(); ++i)
    {
        followed += std::pow(profile.heightsM[i] - swell[i], 2.0);
        straight += std::pow(500.0 - swell[i], 2.0);
    }
    EXPECT_LT(followed, 0.7 * straight);
}

TEST(RunwayProfile, ASteepSiteKeepsItsOwnSlopeAndSaysSo)
{
    const auto mountain = runwayProfile(ground(0.12, 0.0), 10.0, runwayLimits(500.0));
    EXPECT_TRUE(mountain.isSteep);
    EXPECT_NEAR(figuresOf(mountain.heightsM).slope, 0.12, 0.01);
    const auto hill = runwayProfile(ground(0.025, 0.0), 10.0, runwayLimits(700.0));
    EXPECT_FALSE(hill.isSteep);
    EXPECT_LE(figuresOf(hill.heightsM).slope, 0.02 + 1e-9);
}

TEST(RunwayProfile, TwoStationsAreALine)
{
    const std::vector<double> two{10.0, 10.1};
    EXPECT_EQ(runwayProfile(two, 10.0, runwayLimits(700.0)).heightsM.size(), 2u);
}
