// SPDX-License-Identifier: Apache-2.0
// Traffic that keeps the rules, on a crossing of four streets of which two and two are joined by loops, so
// that nobody comes to an end: 1.5 km of street.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "TrafficNetworks.h"
#include "TrafficWatch.h"
#include "simulation/player/EntityDistance.h"
#include "simulation/road/JunctionTable.h"

namespace simulation
{
namespace
{

using namespace trafficnetworks;

TEST(RuledTraffic, HasNoCollisionAndNoJamInAnHour)
{
    const auto player = playerOf(trafficAround({300.0, -300.0}, 15.0, 2000.0), crossing(), 0, 30);
    ASSERT_TRUE(player);
    const Watched seen = watch(*player, 3600.0);
    EXPECT_EQ(seen.collisions, 0);
    EXPECT_LT(seen.longestStandS, 120.0);
    EXPECT_GE(seen.least, 20u);
    EXPECT_GT(seen.drivenM / static_cast<double>(seen.most), 3600.0 * 5.0) << "m for each vehicle";
    EXPECT_LE(seen.fastestMps, 50.0 / 3.6 + 0.1);
    RecordProperty("standsS", std::to_string(seen.longestStandS));
}

/// The mutation of the test above: drivers who do not give way.
TEST(RuledTraffic, CollidesWhereNobodyGivesWay)
{
    const auto player =
        playerOf(withoutGivingWay(trafficAround({300.0, -300.0}, 15.0, 2000.0)), crossing(), 0, 30);
    ASSERT_TRUE(player);
    EXPECT_GT(watch(*player, 300.0).collisions, 0);
}

TEST(RuledTraffic, StandsBehindAPersonWhoStands)
{
    // On the lane that leads from the east to the crossing, 45 m before it, looking along its traffic.
    Scenario scenario = trafficAround({60.0, 1.75}, 15.0, 2000.0);
    auto& teleport = std::get<TeleportAction>(scenario.storyboard.init.privates.front().actions.front());
    std::get<WorldPosition>(teleport.position).orientation.headingRad = std::numbers::pi;
    const auto player = playerOf(std::move(scenario), crossing());
    ASSERT_TRUE(player);
    const Watched seen = watch(*player, 120.0);
    EXPECT_EQ(seen.collisions, 0);
    double nearestM = 1e9; // behind it, where those stand that came to it
    for (std::size_t i = 1; i < player->entities().size(); ++i)
    {
        const EntityState& state = player->entities()[i];
        if (state.isPresent && std::fabs(state.position.y - 1.75) < 0.5 && state.position.x > 60.0)
            nearestM = std::min(nearestM, state.position.x - 60.0);
    }
    // From rear axle to rear axle: a front of 3.55 m or 4.42 m, a tail of 0.95 m, 2 m between them.
    EXPECT_GT(nearestM, 5.5);
    EXPECT_LT(nearestM, 8.5);
}

TEST(RuledTraffic, IsTheSameInEveryRunAndAnotherWithAnotherSeed)
{
    const auto placesOf = [](std::uint64_t seed)
    {
        const auto player = playerOf(trafficAround({300.0, -300.0}, 15.0, 2000.0), crossing(), seed);
        std::vector<double> places;
        if (!player) return places;
        (void)watch(*player, 20.0);
        for (const EntityState& state : player->entities())
            for (const double place : {state.position.x, state.position.y, state.speedMps})
                places.push_back(place);
        return places;
    };
    const std::vector<double> once = placesOf(1);
    EXPECT_EQ(once, placesOf(1));
    EXPECT_NE(once, placesOf(2));
}

TEST(RuledTraffic, AppearsAndLeavesFarFromThePersonAlone)
{
    constexpr double kRadiusM = 150.0;
    const auto player = playerOf(trafficAround({0.0, 60.0}, 20.0, kRadiusM), crossing());
    ASSERT_TRUE(player);
    const auto apart = [&](const EntityState& state)
    { return glm::length(glm::dvec2(state.position) - glm::dvec2(0.0, 60.0)); };
    std::vector<EntityState> before = player->entities();
    int appeared = 0, left = 0;
    while (player->timeS() < 120.0)
    {
        player->step();
        const std::vector<EntityState>& now = player->entities();
        for (std::size_t i = 1; i < now.size(); ++i)
        {
            if (now[i].isPresent == before[i].isPresent) continue;
            ++(now[i].isPresent ? appeared : left);
            EXPECT_GE(apart(now[i].isPresent ? now[i] : before[i]),
                      now[i].isPresent ? SessionTraffic::kAppearShare * kRadiusM - 1.0 : kRadiusM - 1.0);
        }
        before = now;
    }
    EXPECT_GT(appeared, 3);
    EXPECT_GT(left, 3);
}

TEST(TrafficDensity, IsAWordOrVehiclesAKilometre)
{
    EXPECT_EQ(trafficDensity("none"), 0.0);
    EXPECT_EQ(trafficDensity("light"), 4.0);
    EXPECT_EQ(trafficDensity("medium"), 10.0);
    EXPECT_EQ(trafficDensity("dense"), 25.0);
    EXPECT_EQ(trafficDensity("7.5"), 7.5);
    for (const char* const wrong : {"", "much", "-1", "61", "nan", "5 km"})
        EXPECT_FALSE(trafficDensity(wrong)) << wrong;
}

TEST(JunctionTable, LetsWhoComesFromTheRightGoFirst)
{
    const auto roads = crossing();
    JunctionTable table(*roads);
    const JunctionLane fromEast = through(*roads, 0, 2), fromNorth = through(*roads, 1, 3);
    EXPECT_TRUE(table.goesBefore(fromNorth, fromEast)) << "whoever drives west has the north on the right";
    EXPECT_FALSE(table.goesBefore(fromEast, fromNorth));
    const JunctionLane leftFromWest = through(*roads, 2, 1);
    EXPECT_TRUE(table.goesBefore(fromEast, leftFromWest)) << "it crosses the way of the other";
    EXPECT_FALSE(table.goesBefore(leftFromWest, fromEast));
}

TEST(JunctionTable, HoldsPrioritiesAndSignsHigher)
{
    const auto ruled = crossing(crossingText({}, R"(<priority high="1" low="2"/>)"));
    JunctionTable byPriority(*ruled);
    EXPECT_TRUE(byPriority.goesBefore(through(*ruled, 0, 2), through(*ruled, 1, 3)));
    EXPECT_FALSE(byPriority.goesBefore(through(*ruled, 1, 3), through(*ruled, 0, 2)));
    // To give way, faced by whoever drives to the crossing, against s.
    const auto signedNetwork = crossing(crossingText(
        {R"(<signal s="2" t="5" id="1" name="" dynamic="no" orientation="-" country="DE" type="205" subtype="-1" zOffset="2" value="-1" height="0.9" width="0.9"/>)"}));
    JunctionTable bySigns(*signedNetwork);
    const JunctionLane fromEast = through(*signedNetwork, 0, 2);
    EXPECT_TRUE(bySigns.goesBefore(through(*signedNetwork, 3, 1), fromEast)) << "it comes from the left";
    EXPECT_FALSE(bySigns.goesBefore(fromEast, through(*signedNetwork, 3, 1)));
}

TEST(JunctionTable, KnowsWhichLanesMeet)
{
    const auto roads = crossing();
    JunctionTable table(*roads);
    EXPECT_TRUE(table.conflict(through(*roads, 0, 2), through(*roads, 1, 3)));
    EXPECT_TRUE(table.conflict(through(*roads, 0, 2), through(*roads, 2, 1)));
    EXPECT_TRUE(table.conflict(through(*roads, 0, 2), through(*roads, 1, 2))) << "both leave to the west";
    EXPECT_FALSE(table.conflict(through(*roads, 0, 2), through(*roads, 2, 0))) << "beside each other";
    EXPECT_FALSE(table.conflict(through(*roads, 0, 1), through(*roads, 1, 2))) << "both turn to the right";
    EXPECT_FALSE(table.conflict(through(*roads, 0, 2), through(*roads, 0, 3))) << "one follows the other";
    const LaneConflict* const crossed = table.conflict(through(*roads, 0, 2), through(*roads, 1, 3));
    // The lanes cross 16.75 m behind the begin of the first; the front of a vehicle, with some room 4.6 m
    // before its rear axle, comes to the side of the other, half as wide as 2.1 m, before that.
    ASSERT_TRUE(crossed);
    EXPECT_NEAR(crossed->ownFromM, 16.75 - 1.05 - 4.6, 1.1);
    EXPECT_NEAR(crossed->ownToM, 16.75 + 1.05 + 1.3, 1.1);
}

} // namespace
} // namespace simulation
