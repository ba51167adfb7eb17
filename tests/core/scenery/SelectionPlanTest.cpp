// SPDX-License-Identifier: Apache-2.0
// Shares of faces become levels of a model.
#include "scenery/placement/SelectionPlan.h"

#include <gtest/gtest.h>

namespace
{

using namespace scenery;
using namespace osgPMObjects::core;

/// Two faces fewer with each step.
LevelTable tableOf(std::uint32_t faces)
{
    LevelTable table;
    table.positions = faces / 2 + 2;
    for (std::uint32_t left = faces; left > 0; left -= 2)
    {
        table.faces.push_back(left);
        table.errors.push_back({});
    }
    return table;
}

TEST(SelectionPlan, TakesTheFinestLevelWithinAShare)
{
    SelectionPlan plan;
    plan.settings.method = SelectionMethod::ranges;
    plan.boundariesM = {10.0, 20.0};
    plan.facesPercent = {100.0, 25.0, 1.0};
    const auto settings = selectionFor(plan, tableOf(100), "plan");
    ASSERT_TRUE(settings) << settings.error().message();
    EXPECT_EQ(settings->ranges.steps, (std::vector<std::uint32_t>{0, 38, 49})); // 24 and 2 faces: never none
    EXPECT_EQ(settings->ranges.boundariesM, plan.boundariesM);
}

TEST(SelectionPlan, LetsLevelsOfASmallModelFallTogether)
{
    SelectionPlan plan;
    plan.settings.method = SelectionMethod::overlappingRanges;
    plan.boundariesM = {10.0, 20.0, 30.0};
    plan.facesPercent = {100.0, 10.0, 5.0, 1.0};
    const auto settings = selectionFor(plan, tableOf(8), "plan");
    ASSERT_TRUE(settings) << settings.error().message();
    EXPECT_EQ(settings->overlappingRanges.steps, (std::vector<std::uint32_t>{0, 3}));
}

TEST(SelectionPlan, HalvesByAreaWhereNothingIsSaid)
{
    SelectionPlan plan;
    plan.settings.method = SelectionMethod::sphereArea;
    const auto settings = selectionFor(plan, tableOf(100), "plan");
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->areaRows.steps.size(), 4u);
    plan.leastPx = {500.0};
    EXPECT_FALSE(selectionFor(plan, tableOf(100), "plan")); // one boundary, no levels
    plan.facesPercent = {100.0, 50.0};
    EXPECT_EQ(selectionFor(plan, tableOf(100), "plan")->areaRows.steps, (std::vector<std::uint32_t>{0, 25}));
}

TEST(SelectionPlan, SaysWhatIsWrong)
{
    SelectionPlan plan;
    plan.settings.tolerancePx = -1.0;
    const auto settings = selectionFor(plan, tableOf(10), "field wood");
    ASSERT_FALSE(settings);
    EXPECT_EQ(settings.error().place, "field wood");
}

} // namespace
