// SPDX-License-Identifier: Apache-2.0
// How one object stands on a slope.
#include "scenery/placement/Footing.h"

#include <gtest/gtest.h>

namespace
{

using namespace scenery;

Ground plane(double alongEast, double alongNorth)
{
    Ground ground;
    ground.heightM = [=](const glm::dvec2& plan) -> std::optional<double>
    { return 100.0 + alongEast * plan.x + alongNorth * plan.y; };
    return ground;
}

constexpr double kEast = 0.0;
const Measures kHouse{8.0, 1.0, {-5.0, -4.0}, {5.0, 4.0}, Stance::upright, false};
const Measures kCar{2.4, 0.0, {-1.2, -0.8}, {1.6, 0.8}, Stance::tilted, false};

TEST(Footing, OfAHouseIsTheHighestGroundUnderIt)
{
    const auto footing = standOn(plane(0.05, 0.0), kHouse, {0.0, 0.0}, kEast, 1.0);
    ASSERT_TRUE(footing);
    EXPECT_NEAR(footing->heightM, 100.25, 1e-9); // its foundation reaches 99.25, the lowest ground is 99.75
    EXPECT_NEAR(footing->slopeDeg, 2.862, 0.01);
    EXPECT_EQ(footing->axes[2], glm::dvec3(0.0, 0.0, 1.0));
}

TEST(Footing, OfAHouseIsLowerWhereItsFoundationAsksForIt)
{
    const auto footing = standOn(plane(0.11, 0.0), kHouse, {0.0, 0.0}, kEast, 1.0);
    ASSERT_TRUE(footing); // lowest 99.45, highest 100.55
    EXPECT_NEAR(footing->heightM, 99.45 + 1.0 - kFoundationMarginM, 1e-9);
}

TEST(Footing, IsRefusedWhereTheGroundIsTooSteepForIt)
{
    EXPECT_FALSE(standOn(plane(0.2, 0.0), kHouse, {0.0, 0.0}, kEast, 1.0));
    EXPECT_TRUE(standOn(plane(0.0, 0.12), kHouse, {0.0, 0.0}, kEast, 1.0)); // along its shorter side
    Ground nothing;
    nothing.heightM = [](const glm::dvec2&) -> std::optional<double> { return std::nullopt; };
    EXPECT_FALSE(standOn(nothing, kHouse, {0.0, 0.0}, kEast, 1.0));
}

TEST(Footing, OfACarLiesInTheSlope)
{
    const auto footing = standOn(plane(0.1, -0.05), kCar, {10.0, 20.0}, 0.7, 1.0);
    ASSERT_TRUE(footing);
    for (const glm::dvec2 wheel : {glm::dvec2(-1.2, -0.8), glm::dvec2(1.6, 0.8), glm::dvec2(1.6, -0.8)})
    {
        const glm::dvec3 at =
            glm::dvec3(10.0, 20.0, footing->heightM) + footing->axes * glm::dvec3(wheel, 0.0);
        EXPECT_NEAR(at.z, 100.0 + 0.1 * at.x - 0.05 * at.y, 1e-9);
    }
    EXPECT_NEAR(glm::determinant(footing->axes), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(footing->axes[0], footing->axes[2]), 0.0, 1e-12);
}

TEST(Footing, OfACarIsRefusedOnARidge)
{
    Ground saddle;
    saddle.heightM = [](const glm::dvec2& plan) -> std::optional<double> { return 0.3 * plan.x * plan.y; };
    EXPECT_FALSE(standOn(saddle, kCar, {0.0, 0.0}, kEast, 1.0));
}

TEST(Footing, LooksAtTheWholeRim)
{
    const std::vector<glm::dvec2> places = basePlaces(kHouse, 2.0);
    double widest = 0.0;
    for (std::size_t i = 2; i < places.size(); ++i)
        widest = std::max(widest, glm::length(places[i] - places[i - 1]));
    EXPECT_LE(widest, kRimStepM);
    EXPECT_EQ(basePlaces({}, 1.0).size(), 1u);
}

} // namespace
