// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "scenery/lights/LitTimes.h"
#include "scenery/lights/StreetLamps.h"

using scenery::RoomUse;
using scenery::StreetLine;

namespace
{

StreetLine street(double fromX, double toX, double y = 0.0, double widthM = 6.0)
{
    return {{{fromX, y}, {toX, y}}, widthM};
}

std::vector<glm::dvec2> village()
{
    std::vector<glm::dvec2> houses;
    for (double x = 0.0; x <= 300.0; x += 25.0)
        for (const double y : {-20.0, 20.0})
            houses.emplace_back(x, y);
    return houses;
}

/// The share of rooms that are lit at an hour.
double litShare(RoomUse use, double hour)
{
    int lit = 0;
    constexpr int kRooms = 4000;
    for (int room = 0; room < kRooms; ++room)
        lit += isLit(scenery::litTimes(use, static_cast<std::uint64_t>(room)), 3600.0 * hour) ? 1 : 0;
    return static_cast<double>(lit) / kRooms;
}

} // namespace

TEST(StreetLamps, StandWhereHousesAreAndNotOnOtherStreets)
{
    const std::vector<StreetLine> streets{street(-2000.0, 2000.0), {{{150.0, -500.0}, {150.0, 500.0}}, 8.0}};
    const auto lamps = streetLampsAlong(streets, village());
    EXPECT_GT(lamps.size(), 10u);
    EXPECT_LT(lamps.size(), 25u);
    for (const auto& lamp : lamps)
    {
        EXPECT_TRUE(lamp.place.x > -62.0 && lamp.place.x < 362.0) << "no lamp in the open";
        EXPECT_GT(std::abs(lamp.place.y), 3.0);
        EXPECT_GT(std::abs(lamp.place.x - 150.0), 4.0);
        EXPECT_NEAR(glm::length(lamp.towards), 1.0, 1e-9);
    }
    EXPECT_TRUE(streetLampsAlong(streets, {}).empty());
}

TEST(StreetLamps, StandByTurnsOnBothSides32MetresApart)
{
    const std::vector<StreetLine> streets{street(0.0, 300.0)};
    const auto lamps = streetLampsAlong(streets, village());
    for (std::size_t i = 0; i + 1 < lamps.size(); ++i)
    {
        EXPECT_NEAR(lamps[i + 1].place.x - lamps[i].place.x, 32.0, 1e-9);
        EXPECT_NEAR(lamps[i + 1].place.y, -lamps[i].place.y, 1e-9);
    }
}

TEST(StreetLamps, AMapSaysWhichStreetsAreLit)
{
    // Two streets through a village and one in the open; the middle of the line that a map has is not the
    // road's.
    const std::vector<StreetLine> streets{street(0.0, 300.0), street(0.0, 300.0, 38.0),
                                          street(0.0, 300.0, 1000.0)};
    const auto on = [&](const std::vector<scenery::StreetLamp>& lamps, double y)
    {
        return std::count_if(lamps.begin(), lamps.end(),
                             [=](const scenery::StreetLamp& lamp)
                             { return std::abs(lamp.place.y - y) < 5.0; });
    };
    const auto leftOpen = streetLampsAlong(streets, village());
    EXPECT_GT(on(leftOpen, 0.0), 5);
    EXPECT_GT(on(leftOpen, 38.0), 5);
    EXPECT_EQ(on(leftOpen, 1000.0), 0);
    scenery::MappedLamps mapped;
    mapped.unlit = {{{0.0, 1.5}, {300.0, 1.5}}};
    mapped.lit = {{{0.0, 1001.5}, {300.0, 1001.5}}};
    const auto told = streetLampsAlong(streets, village(), mapped);
    EXPECT_EQ(on(told, 0.0), 0);
    EXPECT_EQ(on(told, 38.0), on(leftOpen, 38.0)) << "nothing is said of it";
    EXPECT_GT(on(told, 1000.0), 5) << "no house stands there";
}

TEST(StreetLamps, ThoseOfAMapStandWhereItHasThem)
{
    const std::vector<StreetLine> streets{street(0.0, 300.0)};
    scenery::MappedLamps mapped;
    mapped.posts = {{150.0, 5.0}, {170.0, -0.5}, {150.0, 700.0}};
    const auto lamps = streetLampsAlong(streets, village(), mapped);
    ASSERT_GT(lamps.size(), 5u);
    EXPECT_EQ(lamps[0].place, mapped.posts[0]);
    EXPECT_NEAR(lamps[0].towards.y, -1.0, 0.1);
    EXPECT_GT(std::abs(lamps[1].place.y), 3.0) << "one on the line of a street stands beside it";
    EXPECT_EQ(lamps[2].place, mapped.posts[2]) << "in a park";
    for (std::size_t i = 3; i < lamps.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_GT(glm::distance(lamps[i].place, mapped.posts[k]), 48.0);
    EXPECT_GT(streetLampsAlong(streets, village()).size(), lamps.size() - 3) << "by rule more stand there";
}

TEST(StreetLamps, LightTheStreetMoreThanTheSky)
{
    const auto lamps = streetLampsAlong(std::vector{street(0.0, 300.0)}, village());
    const auto light = lightOf(lamps.front(), 100.0);
    EXPECT_NEAR(light.place.z, 105.9, 1e-9);
    const double down = candelaTowards(light, light.place + glm::dvec3(20.0, 0.0, -10.0), 0.0),
                 up = candelaTowards(light, light.place + glm::dvec3(1000.0, 0.0, 500.0), 0.0);
    EXPECT_GT(down, 5.0 * up);
    EXPECT_GT(up, 80.0) << "what the street throws back is seen from 10 km";
}

TEST(LitTimes, FollowHourAndUseOfTheRoom)
{
    EXPECT_LT(litShare(RoomUse::dwelling, 14.0), 0.01);
    EXPECT_NEAR(litShare(RoomUse::dwelling, 20.4), 0.55, 0.03);
    EXPECT_NEAR(litShare(RoomUse::dwelling, 3.0), 0.04, 0.01);
    EXPECT_GT(litShare(RoomUse::work, 12.0), 0.7);
    EXPECT_LT(litShare(RoomUse::work, 22.0), 0.05);
    EXPECT_GT(litShare(RoomUse::shop, 17.5), 0.99);
    EXPECT_NEAR(litShare(RoomUse::shop, 23.0), 0.25, 0.03);
    for (double hour = 0.0; hour < 24.0; hour += 1.0)
        EXPECT_EQ(litShare(RoomUse::unused, hour), 0.0);
}

TEST(LitTimes, NoHourSwitchesManyRoomsAtOnce)
{
    double before = litShare(RoomUse::dwelling, 12.0), most = 0.0;
    for (double hour = 12.0; hour < 36.0; hour += 0.1)
    {
        const double now = litShare(RoomUse::dwelling, std::fmod(hour, 24.0));
        most = std::max(most, std::abs(now - before));
        before = now;
    }
    EXPECT_LT(most, 0.05);
}
