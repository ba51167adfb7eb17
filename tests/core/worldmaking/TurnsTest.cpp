// SPDX-License-Identifier: Apache-2.0
// Which lane of a crossing leads where.
#include "worldmaking/streets/Turns.h"

#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using worldmaking::ArmLanes;
using worldmaking::Turn;
using worldmaking::turnsOf;

constexpr double kEast = 0.0, kNorth = std::numbers::pi / 2.0, kWest = std::numbers::pi,
                 kSouth = -std::numbers::pi / 2.0;

std::vector<char> all(std::size_t arms)
{
    return std::vector<char>(arms * arms, 1);
}

MATCHER_P4(LeadsFrom, fromArm, fromLane, toArm, toLane, "")
{
    return arg.fromArm == std::size_t(fromArm) && arg.fromLane == fromLane &&
           arg.toArm == std::size_t(toArm) && arg.toLane == toLane;
}

TEST(Turns, ACrossingOfTwoLaneStreets)
{
    const auto turns = turnsOf({{kEast, 1, 1}, {kNorth, 1, 1}, {kWest, 1, 1}, {kSouth, 1, 1}}, all(4));
    EXPECT_EQ(turns.size(), 12u); // nobody turns round
    EXPECT_TRUE(std::none_of(turns.begin(), turns.end(), [](const Turn& t) { return t.fromArm == t.toArm; }));
}

TEST(Turns, LeftFromTheInnerLaneRightFromTheOuter)
{
    // Traffic from the south, with two lanes: west lies to its left, east to its right.
    const auto turns = turnsOf({{kSouth, 2, 2}, {kWest, 1, 1}, {kEast, 1, 1}, {kNorth, 2, 2}}, all(4));
    EXPECT_THAT(turns, testing::Contains(LeadsFrom(0, 0, 1, 0)));
    EXPECT_THAT(turns, testing::Contains(LeadsFrom(0, 1, 2, 0)));
    EXPECT_THAT(turns, testing::Contains(LeadsFrom(0, 0, 3, 0)));
    EXPECT_THAT(turns, testing::Contains(LeadsFrom(0, 1, 3, 1)));
    EXPECT_THAT(turns, testing::Not(testing::Contains(LeadsFrom(0, 1, 1, 0))));
}

TEST(Turns, EveryLaneLeadsSomewhere)
{
    // At the end of a street with three lanes: the middle lane has neither left nor right of its own.
    const auto turns = turnsOf({{kSouth, 3, 0}, {kWest, 0, 1}, {kEast, 0, 1}}, all(3));
    for (int lane = 0; lane < 3; ++lane)
        EXPECT_TRUE(
            std::any_of(turns.begin(), turns.end(), [&](const Turn& t) { return t.fromLane == lane; }))
            << lane;
}

TEST(Turns, ForbiddenAndOneWay)
{
    std::vector<char> allowed = all(3);
    allowed[0 * 3 + 1] = 0;
    const auto turns = turnsOf({{kSouth, 1, 1}, {kWest, 1, 1}, {kEast, 1, 0}}, allowed);
    EXPECT_THAT(turns, testing::UnorderedElementsAre(LeadsFrom(1, 0, 0, 0), LeadsFrom(2, 0, 0, 0),
                                                     LeadsFrom(2, 0, 1, 0)));
}

} // namespace
