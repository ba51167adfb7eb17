// SPDX-License-Identifier: Apache-2.0
// Traffic on a roundabout of 40 m with four arms, of which two and two are joined by loops: 2 km of street.
#include <gtest/gtest.h>

#include "TrafficNetworks.h"
#include "TrafficWatch.h"

namespace simulation
{
namespace
{

using namespace trafficnetworks;

Scenario aroundRoundabout()
{
    return trafficAround({300.0, -300.0}, 15.0, 2000.0);
}

void expectNoHarm(double untilS)
{
    const auto player = playerOf(aroundRoundabout(), crossing(roundaboutText()), 0, 30);
    ASSERT_TRUE(player);
    const Watched seen = watch(*player, untilS);
    EXPECT_EQ(seen.collisions, 0);
    EXPECT_LT(seen.longestStandS, 120.0);
    EXPECT_GE(seen.least, 20u);
    EXPECT_GT(seen.drivenM / static_cast<double>(seen.most), untilS * 4.0) << "m for each vehicle";
    testing::Test::RecordProperty("standsS", std::to_string(seen.longestStandS));
    testing::Test::RecordProperty("drivenM", std::to_string(seen.drivenM / static_cast<double>(seen.most)));
}

TEST(Roundabout, HasNoCollisionInAMinute)
{
    expectNoHarm(60.0);
}

TEST(RoundaboutHour, HasNoCollisionAndNoJam)
{
    expectNoHarm(3600.0);
}

/// The mutation of the tests above.
TEST(Roundabout, HasCollisionsWhereNobodyGivesWay)
{
    const auto player = playerOf(withoutGivingWay(aroundRoundabout()), crossing(roundaboutText()), 0, 30);
    ASSERT_TRUE(player);
    EXPECT_GT(watch(*player, 400.0).collisions, 0);
}

TEST(Roundabout, ThoseInTheRingGoFirst)
{
    const auto roads = crossing(roundaboutText());
    JunctionTable table(*roads);
    for (int i = 0; i < 4; ++i)
    {
        const JunctionLane inRing{roads->network().roadIndex(std::to_string(31 + i)), -1, true};
        const JunctionLane fromArm{roads->network().roadIndex(std::to_string(41 + i)), -1, true};
        EXPECT_TRUE(table.conflict(inRing, fromArm)) << i;
        EXPECT_TRUE(table.goesBefore(inRing, fromArm)) << i;
        EXPECT_FALSE(table.goesBefore(fromArm, inRing)) << i;
    }
}

} // namespace
} // namespace simulation
