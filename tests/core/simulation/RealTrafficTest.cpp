// SPDX-License-Identifier: Apache-2.0
// Traffic on a network of others: five crossings with lights (esmini's multi_intersections).
#include <filesystem>

#include <gtest/gtest.h>

#include "../../support/RealData.h"
#include "TrafficWatch.h"

namespace simulation
{
namespace
{

using namespace trafficnetworks;

void expectOrderOnRealRoads(const std::filesystem::path& file, double untilS)
{
    const auto roads = RoadScene::open(file);
    ASSERT_TRUE(roads) << roads.error().message();
    // Somebody 30 m beside the middle of the longest road.
    RoadPlace place;
    for (std::size_t i = 0; i < (*roads)->network().roads.size(); ++i)
        if (place.road < 0 || (*roads)->network().roads[i].length > (*roads)->roadAt(place).length)
            place.road = static_cast<int>(i);
    place.s = 0.5 * (*roads)->roadAt(place).length;
    place.t = 30.0;
    const auto player =
        playerOf(trafficAround(glm::dvec2((*roads)->poseAt(place).position), 10.0, 600.0), *roads, 0, 30);
    ASSERT_TRUE(player);
    EXPECT_GE(player->scenario().roadNetwork.signalControllers.size(), 5U);
    const Watched seen = watch(*player, untilS);
    EXPECT_EQ(seen.collisions, 0);
    EXPECT_LT(seen.longestStandS, 120.0);
    EXPECT_GE(seen.most, 20U);
    testing::Test::RecordProperty("standsS", std::to_string(seen.longestStandS));
    testing::Test::RecordProperty("drivenM", std::to_string(seen.drivenM / static_cast<double>(seen.most)));
}

TEST(RealTraffic, KeepsOrderAtTheLightsOfManyCrossings)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/multi_intersections.xodr");
    expectOrderOnRealRoads(file, 60.0);
}

TEST(RealTrafficLong, KeepsOrderAtTheLightsOfManyCrossings)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/multi_intersections.xodr");
    expectOrderOnRealRoads(file, 900.0);
}

} // namespace
} // namespace simulation
