// SPDX-License-Identifier: Apache-2.0
// What vehicles meet of a building, by hand.
#include "scenery/buildings/BuildingObstacles.h"

#include <gtest/gtest.h>

namespace
{

scenery::StandingBuilding squareHouse()
{
    scenery::StandingBuilding standing;
    standing.building.rings = {{{0.0, 0.0}, {10.0, 0.0}, {10.0, 8.0}, {0.0, 8.0}}};
    standing.building.eavesM = 5.0;
    standing.floorM = 100.0;
    standing.footM = 99.0;
    return standing;
}

TEST(BuildingObstacles, AreItsWallsInsideTheOutline)
{
    simulation::ObstacleList list;
    scenery::addObstacles({squareHouse()}, list);
    ASSERT_EQ(list.obstacles().size(), 4U);
    for (const simulation::Obstacle& wall : list.obstacles())
    {
        EXPECT_EQ(wall.kind, simulation::ObstacleKind::house);
        const glm::dvec2 low = wall.middle - wall.reachM(), high = wall.middle + wall.reachM();
        EXPECT_GT(low.x, -1e-9);
        EXPECT_GT(low.y, -1e-9);
        EXPECT_LT(high.x, 10.0 + 1e-9);
        EXPECT_LT(high.y, 8.0 + 1e-9);
        EXPECT_EQ(wall.lowM, 99.0);
        EXPECT_EQ(wall.highM, 105.0);
    }
    EXPECT_EQ(simulation::ObstacleMap(list).nameOf(0), "building");
}

TEST(BuildingObstacles, LeaveAPassageOpenAndRoofsOnPosts)
{
    scenery::StandingBuilding over = squareHouse(), roof = squareHouse();
    over.building.liftedM = roof.building.liftedM = 4.0;
    roof.building.isOnPosts = true;
    simulation::ObstacleList list;
    scenery::addObstacles({over, roof}, list);
    ASSERT_EQ(list.obstacles().size(), 4U);
    EXPECT_EQ(list.obstacles().front().lowM, 104.0);
}

} // namespace
