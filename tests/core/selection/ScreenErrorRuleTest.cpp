// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <viewlod/ScreenError.h>

#include <osgPMObjects/core/selection/ScreenErrorRule.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

LevelTable tableOf(std::vector<LevelError> errors)
{
    LevelTable table;
    for (std::size_t level = 0; level < errors.size(); ++level)
        table.faces.push_back(static_cast<std::uint32_t>(2 * (errors.size() - level)));
    table.errors = std::move(errors);
    return table;
}

/// Returns a table with estimated distances.
LevelTable errorsOf(std::initializer_list<float> distances)
{
    std::vector<LevelError> errors;
    for (const float distance : distances)
        errors.push_back({distance});
    return tableOf(std::move(errors));
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
    const LevelTable table = tableOf(errors);
    EXPECT_EQ(coarsestWithin(table, 1.0), 3u);
    EXPECT_EQ(coarsestWithin(table, 1.0, {{.normal = 3.0f}}), 0u);
    EXPECT_EQ(coarsestWithin(table, 1.0, {{.texCoord = 5.0f}}), 1u);
    EXPECT_EQ(coarsestWithin(table, 1.0, {{.colour = 2.0f}}), 2u);
    EXPECT_FLOAT_EQ(errorOf(errors[3], {1.0f, 1.0f, 2.0f}), 2.0f);
}

TEST(ScreenErrorRule, TheTolerableErrorIsTheInverseOfTheBoundInPixels)
{
    const double tolerable = tolerableError(2.0, 900.0, 50.0 - 3.0, 0.01);
    EXPECT_NEAR(viewlod::screenErrorBoundPx(900.0, tolerable * 0.01, 50.0, 3.0, 0.1), 2.0, 1e-12);
}

/// Returns the most switches while the distance varies by ±5 %, at steps of several sizes.
int mostSwitches(const LevelTable& errors, double band)
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
    const auto smooth = testsupport::levelTable(500);                         // many small steps
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
    const LevelTable table = testsupport::levelTable(500);
    Random random(13);
    HeldLevel held;
    double log = -6.0;
    for (int i = 0; i < 50'000; ++i)
    {
        log = glm::clamp(log + testsupport::between(random, -0.05, 0.05), -12.0, -3.0);
        const double tolerance = std::exp(log);
        held.level = heldWithin(table, tolerance, kDefaultBand, held);
        EXPECT_LE(table.errors[held.level].distance, tolerance);
        EXPECT_GE(held.level, coarsestWithin(table, tolerance / (kDefaultBand * kDefaultBand)));
        EXPECT_EQ(heldWithin(table, tolerance, 1.0, held), coarsestWithin(table, tolerance));
    }
}

TEST(ScreenErrorRule, ForgetsALevelThatIsNone)
{
    EXPECT_EQ(heldWithin(errorsOf({0.0f, 1.0f}), 5.0, 1.1, HeldLevel{17}), 1u);
}

TEST(ScreenErrorRule, TheFirstChoiceNeedsNoBand)
{
    const LevelTable table = errorsOf({0.0f, 1.0f, 2.0f, 3.0f});
    EXPECT_EQ(heldWithin(table, 2.1, 1.12, HeldLevel{}), 2u);
    EXPECT_EQ(heldWithin(table, 2.1, 1.12, HeldLevel{3}), 1u) << "a change of level does";
    EXPECT_EQ(heldWithin(table, 2.1, 1.12, HeldLevel{2}), 2u);
}

/// A table whose measured errors fall from level 2 to level 4; estimates never fall.
LevelTable measuredTable()
{
    LevelTable table = errorsOf({0.0f, 5.0f, 5.0f, 5.0f, 5.0f, 5.0f, 9.0f});
    table.measured = ErrorLadder(std::vector<MeasuredLevel>{
        {0, {0.0f, 0.0f}}, {1, {1.0f, 0.1f}}, {2, {3.0f, 0.2f}}, {4, {2.0f, 0.3f}}, {6, {4.0f, 0.8f}}});
    return table;
}

TEST(ScreenErrorRule, MeasuredErrorsReplaceEstimates)
{
    const LevelTable table = measuredTable();
    ASSERT_TRUE(isLevelTable(table));
    EXPECT_EQ(coarsestWithin(table, 0.9), 0u);
    EXPECT_EQ(coarsestWithin(table, 1.0), 1u);
    EXPECT_EQ(coarsestWithin(table, 2.0), 4u) << "level 2 does not keep it, a coarser one does";
    EXPECT_EQ(coarsestWithin(table, 4.0), 6u);
    EXPECT_EQ(coarsestWithin(table, 0.31, {.kind = ErrorKind::rootMeanSquare}), 4u);
    LevelTable estimated = table;
    estimated.measured = {};
    EXPECT_EQ(coarsestWithin(estimated, 4.0), 0u) << "one estimate decides";
}

TEST(ScreenErrorRule, TheToleranceHoldsWhereLevelsAreExcluded)
{
    const LevelTable table = measuredTable();
    EXPECT_EQ(coarsestWithin(table, 2.0, {}, {.mostSteps = 3}), 3u) << "between two levels: as the coarser";
    EXPECT_EQ(coarsestWithin(table, 2.0, {}, {.mostSteps = 2}), 1u);
    const std::uint32_t drawable[] = {0, 1, 2, 6};
    EXPECT_EQ(coarsestWithin(table, 2.0, {}, {.drawable = drawable}), 1u);
    EXPECT_EQ(coarsestWithin(table, 3.0, {}, {.drawable = drawable}), 2u);
    std::vector<LevelError> errors = table.errors;
    for (std::size_t level = 3; level < errors.size(); ++level)
        errors[level].normal = 1.0f;
    LevelTable bent = tableOf(errors);
    bent.measured = table.measured;
    EXPECT_EQ(coarsestWithin(bent, 2.0, {{.normal = 10.0f}}), 1u) << "attributes exclude levels, too";
}

TEST(ScreenErrorRule, HoldsMeasuredLevelsWithinTheToleranceOnly)
{
    const LevelTable table = measuredTable();
    EXPECT_EQ(heldWithin(table, 2.0, 1.12, HeldLevel{2}), 1u) << "3 is too much; 4 has to be within 2 / 1.12";
    EXPECT_EQ(heldWithin(table, 2.0, 1.12, HeldLevel{4}), 4u);
    EXPECT_EQ(heldWithin(table, 2.4, 1.12, HeldLevel{1}), 1u);
    EXPECT_EQ(heldWithin(table, 2.6, 1.12, HeldLevel{1}), 4u);
}

} // namespace
