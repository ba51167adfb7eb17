// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/StandBuildings.h"

#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace
{

using namespace scenery;
using osgTerrainROAM::core::MapShape;
using osgTerrainROAM::core::ShapeSet;

ShapeSet oneHouse()
{
    ShapeSet set;
    set.shapes.push_back(
        {7, {}, {{{0, 0}, {12, 0}, {12, 8}, {0, 8}}}, {{"building", "house"}, {"height", "8"}}});
    return set;
}

TEST(StandBuildings, TheDoorIsOnTheStreetsSideAndTheFloorAtTheGroundThere)
{
    const auto slope = [](const glm::dvec2& plan) { return std::optional(100.0 + 0.15 * plan.x); };
    for (const double streetM : {-20.0, 30.0})
    {
        const auto street = [&](const glm::dvec3& from)
        { return std::optional(glm::dvec2(streetM, from.y)); };
        const StandingBuildings made = standBuildings(oneHouse(), slope, street);
        ASSERT_EQ(made.buildings.size(), 1u);
        const StandingBuilding& house = made.buildings[0];
        EXPECT_EQ(house.doorEdge, streetM < 0.0 ? 3u : 1u);
        EXPECT_NEAR(house.floorM, streetM < 0.0 ? 100.05 : 101.85, 1e-9);
        EXPECT_NEAR(house.footM, 99.5, 1e-9);
        EXPECT_NEAR(house.groundAt(0, 0, 0.5), 100.9, 1e-9);
    }
}

TEST(StandBuildings, WithoutAStreetTheDoorIsOnTheLongestSide)
{
    const auto slope = [](const glm::dvec2& plan) { return std::optional(100.0 + 0.2 * plan.y); };
    const StandingBuildings made = standBuildings(oneHouse(), slope);
    ASSERT_EQ(made.buildings.size(), 1u);
    EXPECT_EQ(made.buildings[0].doorEdge, 0u);
    EXPECT_NEAR(made.buildings[0].floorM, 100.05, 1e-9);
}

TEST(StandBuildings, NoMoreThanAStoreyOfTheUphillWallLiesInTheGround)
{
    const auto slope = [](const glm::dvec2& plan) { return std::optional(100.0 + 0.3 * plan.x); };
    const auto street = [](const glm::dvec3& from) { return std::optional(glm::dvec2(-20.0, from.y)); };
    const StandingBuildings made = standBuildings(oneHouse(), slope, street);
    ASSERT_EQ(made.buildings.size(), 1u);
    EXPECT_NEAR(made.buildings[0].floorM, 103.6 - kMostWallSunkM, 1e-9);
}

TEST(StandBuildings, OnASteepSlopeTheFloorIsLowerAndNoWallFloats)
{
    const auto slope = [](const glm::dvec2& plan) { return std::optional(100.0 + 1.5 * plan.x); };
    const StandingBuildings made = standBuildings(oneHouse(), slope);
    ASSERT_EQ(made.buildings.size(), 1u);
    EXPECT_LT(made.buildings[0].floorM, 100.0 + 5.0);
    EXPECT_LT(made.buildings[0].footM, 100.0);
}

TEST(StandBuildings, WhatLiesBeyondTheGroundIsCounted)
{
    const auto none = [](const glm::dvec2& plan) { return plan.x < 5.0 ? std::optional(1.0) : std::nullopt; };
    const StandingBuildings made = standBuildings(oneHouse(), none);
    EXPECT_TRUE(made.buildings.empty());
    EXPECT_EQ(made.beyondGround, 1u);
}

/// A tower of 40 m² uphill, a hall of 96 m² downhill, and a bridge between them.
ShapeSet threeParts(const std::string& ofTower)
{
    ShapeSet set;
    const auto add = [&](std::int64_t id, double fromM, double toM, const std::string& whole, const char* low)
    {
        std::map<std::string, std::string, std::less<>> tags{
            {"building", "yes"}, {"height", "12"}, {"min_height", low}};
        if (!whole.empty()) tags.emplace(kWholeTag, whole);
        set.shapes.push_back({id, {}, {{{fromM, 0}, {toM, 0}, {toM, 8}, {fromM, 8}}}, tags});
    };
    add(1, 0.0, 12.0, "9", "0");
    add(2, 12.0, 15.0, "9", "5");
    add(3, 15.0, 20.0, ofTower, "0");
    return set;
}

TEST(StandBuildings, APartOverAPassageSharesTheFloorAndLeavesRoomForCars)
{
    // The street in the middle lies 1.5 m above the floor of the larger part.
    const auto ground = [](const glm::dvec2& plan)
    { return std::optional(plan.x > 11.9 && plan.x < 15.1 ? 102.5 : 100.0); };
    ShapeSet set = threeParts("9");
    for (const auto& [low, liftedM] : {std::pair("5", 0.0), std::pair("4", 4.0), std::pair("8", 8.0)})
    {
        set.shapes[1].tags["min_height"] = low;
        const StandingBuildings made = standBuildings(set, ground);
        ASSERT_EQ(made.buildings.size(), 3u);
        EXPECT_EQ(made.buildings[1].floorM, made.buildings[0].floorM);
        const double wantedM = liftedM > 0.0 ? liftedM : 102.5 + kPassedM - made.buildings[0].floorM;
        EXPECT_NEAR(made.buildings[1].building.liftedM, wantedM, 1e-9) << low;
    }
}

TEST(StandBuildings, PartsOfOneBuildingShareTheFloorOfTheLargestOnTheGround)
{
    const auto slope = [](const glm::dvec2& plan) { return std::optional(100.0 + 0.15 * plan.x); };
    const auto street = [](const glm::dvec3& from) { return std::optional(glm::dvec2(-20.0, from.y)); };
    const StandingBuildings made = standBuildings(threeParts("9"), slope, street);
    ASSERT_EQ(made.buildings.size(), 3u);
    // At the hall's door the ground lies at 100.0 m; 103.0 m at the other end is less than a storey above it.
    const double floorM = std::max(100.05, 103.0 - kMostWallSunkM);
    for (const StandingBuilding& part : made.buildings)
        EXPECT_NEAR(part.floorM, floorM, 1e-9);
    EXPECT_NEAR(made.buildings[0].footM, 99.5, 1e-9);
    EXPECT_NEAR(made.buildings[2].footM, 101.75, 1e-9) << "each has its own foot";
    // The control: of another building, or of none, it has its own.
    for (const char* other : {"8", ""})
        EXPECT_GT(standBuildings(threeParts(other), slope, street).buildings[2].floorM, floorM + 1.0)
            << other;
}

/// A passage through a building on a hillside parted it: what stood above the street lay 12 m in the ground.
TEST(StandBuildings, PartsUpASteepSlopeStandOnAFloorOfTheirOwnAndNoneLiesInTheGround)
{
    const auto slope = [](const glm::dvec2& plan) { return std::optional(100.0 + 1.5 * plan.x); };
    const auto street = [](const glm::dvec3& from) { return std::optional(glm::dvec2(-20.0, from.y)); };
    const StandingBuildings made = standBuildings(threeParts("9"), slope, street);
    ASSERT_EQ(made.buildings.size(), 3u);
    const StandingBuilding &hall = made.buildings[0], &bridge = made.buildings[1], &tower = made.buildings[2];
    // On the hall's floor the roof of the tower would lie below its lowest ground, and the bridge in the
    // street.
    EXPECT_LT(hall.floorM + hall.building.eavesM, 122.5 + kMostWallSunkM);
    EXPECT_GE(tower.floorM + tower.building.eavesM, 122.5 + kMostWallSunkM);
    EXPECT_EQ(bridge.floorM, tower.floorM) << "both are one building still";
    EXPECT_GE(bridge.floorM + bridge.building.liftedM, 122.5 + kPassedM - 1e-9);
    for (const StandingBuilding& part : made.buildings)
        EXPECT_LT(part.footM, part.groundM[0][0]) << "no wall floats";
}

} // namespace
