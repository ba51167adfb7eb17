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

/// The strips of a roof cover what lies inside the outline, and nothing else, up to the ridge over the
/// middle.
TEST(BuildingObstacles, HaveRoofsOverAllThatIsInside)
{
    scenery::StandingBuilding house = squareHouse();
    house.building.rings.push_back({{4.0, 3.0}, {4.0, 5.0}, {6.0, 5.0}, {6.0, 3.0}}); // a courtyard
    house.building.roofM = 3.0;
    simulation::ObstacleList list;
    scenery::addRoofs({house}, list);
    const simulation::ObstacleMap map(list);
    const auto highestAt = [&](const glm::dvec2& place)
    {
        double highest = 0.0;
        for (std::uint32_t i = 0; i < map.size(); ++i)
        {
            const simulation::Obstacle& strip = map.at(i);
            if (glm::all(glm::lessThan(glm::abs(place - strip.middle), strip.reachM())))
                highest = std::max(highest, strip.highM);
        }
        return highest;
    };
    EXPECT_NEAR(highestAt({1.0, 0.3}), 105.0 + 3.0 / 6.0, 1e-9) << "over the eaves";
    EXPECT_NEAR(highestAt({1.0, 3.9}), 105.0 + 3.0 * 5.0 / 6.0, 1e-9) << "beside the ridge";
    EXPECT_EQ(highestAt({5.0, 4.1}), 0.0) << "a courtyard";
    EXPECT_EQ(highestAt({10.2, 3.9}), 0.0) << "outside";
    for (const simulation::Obstacle& strip : list.obstacles())
        EXPECT_NEAR(strip.lowM, 104.7, 1e-9);
    house.building.roof = scenery::RoofForm::flat;
    house.building.roofM = 0.0;
    simulation::ObstacleList flat;
    scenery::addRoofs({house}, flat);
    for (const simulation::Obstacle& strip : flat.obstacles())
        EXPECT_NEAR(strip.highM, 105.0, 1e-9);
}

} // namespace
