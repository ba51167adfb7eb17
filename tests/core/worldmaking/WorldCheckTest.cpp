// SPDX-License-Identifier: Apache-2.0
// A small world without faults, and each fault in turn.
#include "worldmaking/check/WorldCheck.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "MadeStreets.h"

namespace
{

using namespace worldmaking;
using osgRoads::core::PlacedNetwork;

PlanRings box(const glm::dvec2& low, double sideM)
{
    return {{low, low + glm::dvec2(sideM, 0), low + glm::dvec2(sideM, sideM), low + glm::dvec2(0, sideM)}};
}

/// A street of 400 m on level ground, two houses and two trees beside it, a lake, a runway.
struct World
{
    std::unique_ptr<PlacedNetwork> roads;
    WorldThings things;
    glm::dvec2 street{0.0}; ///< a place in its middle
    double groundM = 499.5; ///< the bed of the street

    World()
    {
        MadeMap map;
        map.way({map.node(-200, 0), map.node(200, 0)});
        auto streets = streetsOf(map, [](double, double) { return 500.0; });
        roads = std::make_unique<PlacedNetwork>(
            std::make_shared<osgRoads::core::RoadNetwork>(std::move(streets.network)));
        street = glm::dvec2(roads->surfacePoint(0, 200.0, 0.0));
        things.roads = roads.get();
        things.groundM = [this](const glm::dvec2&) { return std::optional(groundM); };
        things.houses = {house(street + glm::dvec2(0, 20)), house(street + glm::dvec2(40, 20))};
        things.plants = {street + glm::dvec2(0, -20), street + glm::dvec2(20, -20)};
        things.waters = {box(street + glm::dvec2(-100, 50), 30.0)};
        things.runways = {box(street + glm::dvec2(100, 50), 30.0)};
    }

    static scenery::StandingBuilding house(const glm::dvec2& low)
    {
        scenery::StandingBuilding standing;
        standing.building.rings = box(low, 10.0);
        standing.floorM = 499.5;
        standing.footM = 499.0;
        return standing;
    }

    void moveHouse(std::size_t i, const glm::dvec2& by)
    {
        for (glm::dvec2& corner : things.houses[i].building.rings[0])
            corner += by;
    }

    WorldFaults faults() const { return checkWorld(things); }
};

TEST(WorldCheck, FindsNothingWhereEverythingStandsRight)
{
    const WorldFaults faults = World().faults();
    EXPECT_EQ(faults.total(), 0u);
    EXPECT_EQ(faults.objects, 4u);
    EXPECT_NEAR(faults.roadsKm, 0.4, 0.01);
}

TEST(WorldCheck, SeesAHouseOrATreeOnTheStreet)
{
    World house;
    house.moveHouse(0, {0, -25});
    EXPECT_EQ(house.faults().onRoad, 1u);
    World tree;
    tree.things.plants[0] = tree.street;
    EXPECT_EQ(tree.faults().onRoad, 1u);
}

TEST(WorldCheck, SeesWhatStandsInWaterOrOnARunway)
{
    World world;
    world.moveHouse(0, {-95, 40});
    world.moveHouse(1, {60, 40});
    EXPECT_EQ(world.faults().inWater, 1u);
    EXPECT_EQ(world.faults().onRunway, 1u);
    world.things.plants = {world.street + glm::dvec2(-90, 60), world.street + glm::dvec2(110, 60)};
    EXPECT_EQ(world.faults().inWater, 2u);
    EXPECT_EQ(world.faults().onRunway, 2u);
}

TEST(WorldCheck, SeesHousesOverEachOtherAndATreeInAHouse)
{
    World world;
    world.moveHouse(1, {-35, 0});
    world.things.plants[0] = world.street + glm::dvec2(2, 22);
    EXPECT_EQ(world.faults().overlapping, 2u);
}

TEST(WorldCheck, SeesASunkHouseAndOneThatFloats)
{
    using Flaw = HouseFault::Flaw;
    World world;
    const auto sink = [&](double byM)
    {
        world.things.houses[0].floorM -= byM;
        world.things.houses[0].footM -= byM;
    };
    sink(3.0);
    EXPECT_EQ(world.faults().floating, 0u) << "a part up the slope of a building whose walls are 6 m high";
    sink(1.5);
    EXPECT_EQ(world.faults().floating, 1u);
    world.things.houses[1].footM += 1.0;
    const WorldFaults faults = world.faults();
    EXPECT_EQ(faults.floating, 2u);
    ASSERT_EQ(faults.houseFaults.size(), 2u) << "each is told with its place";
    const HouseFault &sunk = faults.houseFaults[0], &floats = faults.houseFaults[1];
    EXPECT_EQ(sunk.flaw, Flaw::sunk);
    EXPECT_NEAR(sunk.byM, 1.5, 1e-9);
    EXPECT_LT(glm::distance(glm::dvec2(sunk.place), world.street + glm::dvec2(5, 25)), 1e-6);
    EXPECT_EQ(floats.flaw, Flaw::floats);
    EXPECT_NEAR(floats.byM, 0.5, 1e-9);
    world.things.groundM = [&](const glm::dvec2& place)
    { return place.x < world.street.x + 45.0 ? std::optional(499.5) : std::nullopt; };
    EXPECT_EQ(world.faults().houseFaults[1].flaw, Flaw::beyond);
}

TEST(WorldCheck, SeesARoadThatTheGroundLeavesOrCovers)
{
    World world;
    world.groundM = 497.0;
    EXPECT_EQ(world.faults().floatingRoads, 1u);
    world.groundM = 500.3;
    EXPECT_EQ(world.faults().sunkRoads, 1u);
}

/// Four streets of 200 m that meet, on ground of a slope.
osgRoads::core::RoadNetwork meetingStreets(double slope)
{
    MadeMap map;
    const int middle = map.node(0, 0);
    for (const auto& [eastM, northM] : {std::pair(200.0, 0.0), {-200.0, 0.0}, {0.0, 200.0}, {0.0, -200.0}})
        map.way({middle, map.node(eastM, northM)});
    return streetsOf(map, [&](double eastM, double) { return 500.0 + slope * eastM; }).network;
}

osgRoads::core::CubicProfile changed(const osgRoads::core::CubicProfile& profile, double times, double plusM)
{
    auto pieces = profile.pieces();
    for (auto& piece : pieces)
        piece.a = times * piece.a + plusM, piece.b *= times, piece.c *= times, piece.d *= times;
    return osgRoads::core::CubicProfile(pieces);
}

std::vector<JunctionFault> faultsOfJunctions(osgRoads::core::RoadNetwork network)
{
    return junctionFaults(PlacedNetwork(std::make_shared<osgRoads::core::RoadNetwork>(std::move(network))));
}

TEST(JunctionCheck, SeesAStepAndALean)
{
    const osgRoads::core::RoadNetwork sound = meetingStreets(0.08);
    EXPECT_TRUE(faultsOfJunctions(sound).empty());
    osgRoads::core::RoadNetwork stepped = sound;
    const auto turn = std::find_if(stepped.roads.begin(), stepped.roads.end(),
                                   [](const auto& road) { return !road.junctionId.empty(); });
    ASSERT_NE(turn, stepped.roads.end());
    turn->elevation = changed(turn->elevation, 1.0, 0.2);
    const auto faults = faultsOfJunctions(stepped);
    ASSERT_FALSE(faults.empty());
    for (const JunctionFault& fault : faults)
    {
        EXPECT_EQ(fault.flaw, JunctionFlaw::step);
        EXPECT_NEAR(fault.by, 0.2, 0.05);
        EXPECT_GE(fault.other, 0);
    }
    osgRoads::core::RoadNetwork steep = sound;
    for (auto& road : steep.roads)
        road.elevation = changed(road.elevation, 10.0, 0.0);
    const auto leaning = faultsOfJunctions(steep);
    EXPECT_TRUE(std::any_of(leaning.begin(), leaning.end(),
                            [](const JunctionFault& fault)
                            { return fault.flaw == JunctionFlaw::steep && fault.by > 0.5; }));
}

} // namespace
