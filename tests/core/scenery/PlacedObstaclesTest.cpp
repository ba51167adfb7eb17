// SPDX-License-Identifier: Apache-2.0
// What vehicles meet of placed models, by hand.
#include "scenery/placement/PlacedObstacles.h"

#include <gtest/gtest.h>

namespace
{

using scenery::models::Kind;
using simulation::ObstacleKind;

TEST(PlacedObstacles, AreTrunksBushesAndBases)
{
    scenery::SceneryDescription description;
    scenery::PlacedScenery placed;
    std::vector<scenery::Measures> measures;
    for (const Kind kind : {Kind::oak, Kind::bush, Kind::saloon, Kind::barn})
    {
        scenery::SceneryField field;
        field.objects = {{kind, 1, {}}};
        const auto number = static_cast<std::uint32_t>(description.fields.size());
        description.fields.push_back(field);
        placed.placements.push_back(
            {{20.0 * number, 5.0, 100.0}, scenery::uprightAxes(0.0), 1.0, number, number});
        scenery::Measures one;
        one.baseLow = {-2.0, -1.0};
        one.baseHigh = {2.4, 1.0};
        measures.push_back(one);
    }
    simulation::ObstacleList list;
    scenery::addObstacles(description, placed, measures, list);
    const auto& obstacles = list.obstacles();
    ASSERT_EQ(obstacles.size(), 4U);
    EXPECT_EQ(obstacles[0].kind, ObstacleKind::tree);
    EXPECT_NEAR(obstacles[0].halfM.x, 0.026 * 14.5, 1e-9); // of an oak in the middle of 10 to 19 m
    EXPECT_NEAR(obstacles[0].highM, 114.5, 1e-9);
    EXPECT_EQ(obstacles[1].kind, ObstacleKind::hedge);
    EXPECT_NEAR(obstacles[1].halfM.x, 1.6, 1e-9);
    EXPECT_EQ(obstacles[2].kind, ObstacleKind::vehicle);
    EXPECT_NEAR(obstacles[2].middle.x, 40.2, 1e-9);
    EXPECT_NEAR(obstacles[2].halfM.x, 2.2, 1e-9);
    EXPECT_EQ(obstacles[3].kind, ObstacleKind::house);
    EXPECT_EQ(simulation::ObstacleMap(list).nameOf(3), "barn");
}

} // namespace
