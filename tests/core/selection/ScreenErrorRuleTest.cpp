// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <viewlod/ScreenError.h>

#include <osgPMObjects/core/selection/ScreenErrorRule.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

std::vector<LevelError> errorsOf(std::initializer_list<float> distances)
{
    std::vector<LevelError> errors;
    for (const float distance : distances)
        errors.push_back({distance});
    return errors;
}

TEST(ScreenErrorRule, TakesTheCoarsestLevelWithinTheTolerance)
{
    const auto errors = errorsOf({0.0f, 1.0f, 1.0f, 2.0f, 5.0f});
    EXPECT_EQ(coarsestWithin(errors, 0.5), 0u);
    EXPECT_EQ(coarsestWithin(errors, 1.0), 2u);
    EXPECT_EQ(coarsestWithin(errors, 4.99), 3u);
    EXPECT_EQ(coarsestWithin(errors, 5.0), 4u);
    EXPECT_EQ(coarsestWithin(errors, -1.0), 0u);
    EXPECT_EQ(coarsestWithin(errorsOf({0.0f}), 3.0), 0u);
}

TEST(ScreenErrorRule, CountsAttributesWhenTheyAreWeighed)
{
    std::vector<LevelError> errors(4);
    errors[1] = {0.1f, 0.5f, 0.0f, 0.0f};
    errors[2] = {0.2f, 0.5f, 0.3f, 0.0f};
    errors[3] = {0.3f, 0.5f, 0.3f, 1.0f};
    EXPECT_EQ(coarsestWithin(errors, 1.0), 3u);
    EXPECT_EQ(coarsestWithin(errors, 1.0, {.normal = 3.0f}), 0u);
    EXPECT_EQ(coarsestWithin(errors, 1.0, {.texCoord = 5.0f}), 1u);
    EXPECT_EQ(coarsestWithin(errors, 1.0, {.colour = 2.0f}), 2u);
    EXPECT_FLOAT_EQ(errorOf(errors[3], {1.0f, 1.0f, 2.0f}), 2.0f);
}

TEST(ScreenErrorRule, TheTolerableErrorIsTheInverseOfTheBoundInPixels)
{
    const double tolerable = tolerableError(2.0, 900.0, 50.0 - 3.0, 0.01);
    EXPECT_NEAR(viewlod::screenErrorBoundPx(900.0, tolerable * 0.01, 50.0, 3.0, 0.1), 2.0, 1e-12);
}

/// Returns the most switches while the distance varies by ±5 %, at steps of several sizes.
int mostSwitches(const std::vector<LevelError>& errors, double band)
{
    Random random(12);
    int most = 0;
    for (double distance = 1.0; distance < 3000.0; distance *= 1.03)
        for (const double cameFrom : {0.5, 0.9, 0.93, 1.0, 1.07, 1.1, 2.0})
        {
            HeldLevel held;
            const auto level = [&](double d)
            { return held.level = heldWithin(errors, d * 1e-5, band, held); };
            level(cameFrom * distance);
            most = std::max(most, testsupport::switchesWhileTrembling(distance, 0.05, 4, level));
            most = std::max(most, testsupport::switchesWhileWalking(random, distance, 0.05, 100, level));
        }
    return most;
}

TEST(ScreenErrorRule, SwitchesAtMostOnceWhileTheDistanceTremblesByFivePerCent)
{
    const auto smooth = testsupport::levelTable(500).errors;                  // many small steps
    const auto rough = errorsOf({0.0f, 1e-4f, 1e-3f, 1.1e-3f, 5e-3f, 2e-2f}); // some large ones
    for (const auto& errors : {smooth, rough})
    {
        EXPECT_EQ(mostSwitches(errors, kDefaultBand), 1);
        EXPECT_GT(mostSwitches(errors, 1.0), 1);
    }
    EXPECT_GT(mostSwitches(smooth, 1.05), 1);
}

TEST(ScreenErrorRule, TheToleranceHoldsAlwaysAndTheBandCostsLittle)
{
    const auto errors = testsupport::levelTable(500).errors;
    Random random(13);
    HeldLevel held;
    double log = -6.0;
    for (int i = 0; i < 50'000; ++i)
    {
        log = glm::clamp(log + testsupport::between(random, -0.05, 0.05), -12.0, -3.0);
        const double tolerance = std::exp(log);
        held.level = heldWithin(errors, tolerance, kDefaultBand, held);
        EXPECT_LE(errors[held.level].distance, tolerance);
        EXPECT_GE(held.level, coarsestWithin(errors, tolerance / (kDefaultBand * kDefaultBand)));
        EXPECT_EQ(heldWithin(errors, tolerance, 1.0, held), coarsestWithin(errors, tolerance));
    }
}

TEST(ScreenErrorRule, ForgetsALevelThatIsNone)
{
    EXPECT_EQ(heldWithin(errorsOf({0.0f, 1.0f}), 5.0, 1.1, HeldLevel{17}), 1u);
}

} // namespace
