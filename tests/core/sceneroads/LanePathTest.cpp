// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/LanePath.h"

#include <memory>

#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>

namespace
{

using namespace osgRoads::core;
using scenery::LanePathPoint;

/// 200 m along x, climbing 1 m in 10: lanes of 4 m with ids 1, -1 and -2; a limit of 20 m/s from 100 m on, in
/// a town before.
PlacedNetwork straightRoad()
{
    const std::string lane = R"(<width sOffset="0" a="4" b="0" c="0" d="0"/></lane>)";
    auto read = parseNetwork(
        R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="200" junction="-1">
<type s="0" type="town"/><type s="100" type="rural"><speed max="20"/></type>
<planView><geometry s="0" x="0" y="0" hdg="0" length="200"><line/></geometry></planView>
<elevationProfile><elevation s="0" a="0" b="0.1" c="0" d="0"/></elevationProfile>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false">)" +
            lane + R"(</left><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">)" +
            lane + R"(<lane id="-2" type="driving" level="false">)" + lane +
            "</right></laneSection></lanes></road></OpenDRIVE>",
        "straight.xodr");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return PlacedNetwork(std::make_shared<const RoadNetwork>(std::move(read->network)));
}

} // namespace

TEST(LanePath, IsTheMiddleOfTheLaneOnTheSurfaceInTheDirectionOfTravel)
{
    const PlacedNetwork roads = straightRoad();
    LaneRoute route;
    route.legs = {{{0, 0, 1, false}, 180.0, 30.0, false}};
    route.lengthM = 150.0;
    const auto path = scenery::lanePath(roads, route);
    ASSERT_EQ(path.size(), 151u);
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        const double x = 180.0 - static_cast<double>(i);
        EXPECT_LT(glm::distance(path[i].place, glm::dvec3(x, 2.0, 0.1 * x)), 1e-5);
        EXPECT_DOUBLE_EQ(path[i].limitMps, x >= 100.0 ? 20.0 : 13.9);
    }
    EXPECT_DOUBLE_EQ(scenery::defaultSpeedMps(roads.network()), 13.9);
}

TEST(LanePath, GoesOverToTheNextLaneWithoutAJump)
{
    const PlacedNetwork roads = straightRoad();
    LaneRoute route;
    route.legs = {{{0, 0, -2, true}, 10.0, 50.0, false},
                  {{0, 0, -2, true}, 50.0, 50.0, false},
                  {{0, 0, -1, true}, 50.0, 150.0, true}};
    route.lengthM = 140.0;
    const auto path = scenery::lanePath(roads, route);
    const auto aside = [&](double x) { return path[static_cast<std::size_t>(x - 10.0)].place.y; };
    EXPECT_NEAR(aside(50.0), -6.0, 1e-9);
    EXPECT_NEAR(aside(70.0), -4.0, 1e-5) << "half of the way over";
    EXPECT_NEAR(aside(90.0), -2.0, 1e-5);
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_LT(std::fabs(path[i].place.y - path[i - 1].place.y), 0.16) << i; // 4 m · 1.5 / 40 m
}
