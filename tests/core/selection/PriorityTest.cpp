// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/Priority.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;

const BoundingSphere kAhead{{0, 100, 0}, 1.0};

TEST(Priority, IsImportanceTimesAttention)
{
    EXPECT_EQ(priorityGain({}, {}, {}, kAhead), 1.0);
    EXPECT_EQ(priorityGain({.importance = 3.0}, {}, {}, kAhead), 3.0);
    EXPECT_EQ(priorityGain({.importance = 3.0, .isAttended = true}, {.attendedGain = 2.5}, {}, kAhead), 7.5);
}

TEST(Priority, FallsWithTheAngleFromTheGaze)
{
    const AttentionRule rule{
        .peripheralGain = 0.4, .gazeInnerDeg = 10.0, .gazeOuterDeg = 30.0, .gaze = {0, 1, 0}};
    const auto at = [&](double offDeg, double radius = 0.0)
    {
        const double off = glm::radians(offDeg);
        return priorityGain({}, rule, {}, {{100.0 * std::sin(off), 100.0 * std::cos(off), 0.0}, radius});
    };
    EXPECT_DOUBLE_EQ(at(0.0), 1.0);
    EXPECT_DOUBLE_EQ(at(9.9), 1.0);
    EXPECT_NEAR(at(20.0), 0.7, 1e-9);
    EXPECT_DOUBLE_EQ(at(31.0), 0.4);
    EXPECT_DOUBLE_EQ(at(180.0), 0.4);
    // The nearest point of a large object counts, and the eye inside looks at it.
    EXPECT_NEAR(at(20.0, 100.0 * std::sin(glm::radians(5.0))), 0.85, 1e-9);
    EXPECT_EQ(at(90.0, 150.0), 1.0);
    EXPECT_EQ(priorityGain({.isAttended = true}, rule, {}, {{0, -100, 0}, 1.0}), 2.0);
}

TEST(Priority, AGazeWithoutASlopeIsAStep)
{
    const AttentionRule rule{
        .peripheralGain = 0.5, .gazeInnerDeg = 10.0, .gazeOuterDeg = 10.0, .gaze = {0, 1, 0}};
    EXPECT_EQ(priorityGain({}, rule, {}, kAhead), 1.0);
    EXPECT_EQ(priorityGain({}, rule, {}, {{100, 0, 0}, 1.0}), 0.5);
}

} // namespace
