// SPDX-License-Identifier: Apache-2.0
// Houses of small made maps: what stands on roads, over each other or in water, and what the measures say of
// one that does.
#include "worldmaking/land/Houses.h"

#include <gtest/gtest.h>

#include <osgRoads/core/network/RoadNetwork.h>

#include "MadeStreets.h"
#include "TestFolder.h"
#include "scenery/buildings/Outline.h"
#include "worldmaking/land/Passages.h"
#include "worldmaking/map/ReadLand.h"

namespace
{

using namespace worldmaking;

/// A street from west to east, and what a test puts beside it.
struct Village
{
    MadeMap map;

    Village() { map.way({map.node(-200, 0), map.node(200, 0)}); }

    void box(double eastM, double northM, double lengthM, double widthM, const char* key = "building",
             const char* value = "house")
    {
        const int first = map.node(eastM, northM);
        const int b = map.node(eastM + lengthM, northM), c = map.node(eastM + lengthM, northM + widthM),
                  d = map.node(eastM, northM + widthM);
        map.way({first, b, c, d, first}, {{key, value}});
    }
};

/// The houses of a village on level ground.
struct Built
{
    Streets streets;
    LandMap land;
    HouseReport report;
    std::vector<House> houses;
    double leastRoomM = 100.0;

    explicit Built(const Village& village, const std::vector<PlanRings>& strips = {})
        : streets(streetsOf(village.map, [](double, double) { return 500.0; }))
    {
        const testsupport::TestFolder folder("houses");
        const auto read = readLand(folder.write("map.osm", village.map.text()));
        EXPECT_TRUE(read) << (read ? "" : read.error().message());
        land = *read;
        const auto plane = MapPlane::create(streets.network.header, "made");
        const RoadRoom room(streets.network);
        houses = housesOf(land, *plane, {room, strips, [](const glm::dvec2&) { return true; }}, report);
        for (const House& house : houses)
            leastRoomM = std::min(leastRoomM, room.distanceM(house.building.rings, 100.0));
    }
};

TEST(Houses, OneThatReachesOntoTheStreetIsCutBack)
{
    Village village;
    village.box(0, 2, 12, 10); // the street is some 5.5 m wide
    const Built built(village);
    ASSERT_EQ(built.houses.size(), 1u);
    EXPECT_EQ(built.report.cutBack, 1u);
    EXPECT_GE(built.leastRoomM, kHouseRoomM - 1e-6);
    EXPECT_LT(scenery::areaOf(built.houses[0].building.rings), 118.0);
    EXPECT_GT(scenery::areaOf(built.houses[0].building.rings), 80.0);
}

/// Adds an area with tags. `at`: its corner; `sizeM`: east and north.
void addBox(MadeMap& map, const glm::dvec2& at, const glm::dvec2& sizeM,
            std::initializer_list<std::pair<const char*, const char*>> tags)
{
    const int a = map.node(at.x, at.y), b = map.node(at.x + sizeM.x, at.y),
              c = map.node(at.x + sizeM.x, at.y + sizeM.y), d = map.node(at.x, at.y + sizeM.y);
    map.way({a, b, c, d, a}, tags);
}

/// The lowest and highest height of the building over a place, and how many there are.
struct Standing
{
    double lowM = 1e9, topM = 0.0, areaM2 = 0.0;
    std::size_t count = 0;

    explicit Standing(const std::vector<House>& houses)
    {
        for (const House& house : houses)
        {
            ++count;
            lowM = std::min(lowM, house.building.liftedM);
            topM = std::max(topM, house.building.eavesM + house.building.roofM);
            areaM2 += scenery::areaOf(house.building.rings);
        }
    }
};

TEST(Houses, PartsTakeThePlaceOfTheirBuilding)
{
    Village all; // parts cover all of it
    addBox(all.map, {0, 20}, {40, 20}, {{"building", "office"}, {"height", "60"}});
    addBox(all.map, {0, 20}, {20, 20}, {{"building:part", "yes"}, {"height", "10 m"}});
    addBox(all.map, {20, 20}, {20, 20}, {{"building:part", "yes"}, {"height", "82 ft"}});
    const Built whole(all);
    EXPECT_EQ(Standing(whole.houses).count, 2u);
    EXPECT_NEAR(Standing(whole.houses).topM, 25.0, 0.01) << "not the outline's 60 m";
    EXPECT_EQ(whole.report.parts, 2u);
    Village some; // a part covers a quarter
    addBox(some.map, {0, 20}, {40, 20}, {{"building", "yes"}, {"height", "9"}, {"roof:shape", "flat"}});
    addBox(some.map, {0, 20}, {10, 20}, {{"building:part", "yes"}, {"building:levels", "10"}});
    const Built left(some);
    EXPECT_EQ(Standing(left.houses).count, 2u);
    EXPECT_NEAR(Standing(left.houses).areaM2, 800.0, 6.0) << "what the part leaves stays, none twice";
    Village stacked; // a tower on a base, and one that crosses it without a lower end
    addBox(stacked.map, {0, 20}, {40, 20}, {{"building", "yes"}, {"height", "30"}});
    addBox(stacked.map, {0, 20}, {40, 20}, {{"building:part", "yes"}, {"height", "6"}});
    addBox(stacked.map, {5, 25}, {10, 10},
           {{"building:part", "yes"}, {"min_height", "6 m"}, {"height", "30"}});
    addBox(stacked.map, {25, 25}, {10, 10}, {{"building:part", "yes"}, {"height", "20"}});
    const Built tower(stacked);
    EXPECT_EQ(Standing(tower.houses).count, 3u);
    EXPECT_NEAR(Standing(tower.houses).areaM2, 900.0, 6.0) << "the base ends below the third";
    EXPECT_EQ(tower.report.overlapping, 0u);
    Village alone; // without an outline, and a bridge between two houses
    addBox(alone.map, {0, 20}, {10, 10},
           {{"building:part", "yes"}, {"building:levels", "7"}, {"building:min_level", "4"}});
    addBox(alone.map, {30, 20}, {10, 10}, {{"building:part", "no"}});
    const Standing one(Built(alone).houses);
    EXPECT_EQ(one.count, 1u);
    EXPECT_NEAR(one.lowM, 12.0, 0.6) << "four storeys";
    Village inherits;
    addBox(inherits.map, {0, 20}, {40, 20},
           {{"building", "yes"}, {"height", "33"}, {"building:colour", "#ff0000"}});
    addBox(inherits.map, {0, 20}, {40, 20}, {{"building:part", "yes"}});
    const Built same(inherits);
    ASSERT_EQ(same.houses.size(), 1u);
    EXPECT_NEAR(Standing(same.houses).topM, 33.0, 0.01);
    EXPECT_NEAR(same.houses[0].building.wallTint.r, 1.0F, 0.01F);
    EXPECT_NEAR(same.houses[0].building.wallTint.g, 0.0F, 0.01F);
}

TEST(Houses, OneOnTheStreetIsLeftOut)
{
    Village village;
    village.box(0, -4, 12, 8);
    village.box(50, 10, 12, 8);
    const Built built(village);
    EXPECT_EQ(built.houses.size(), 1u);
    EXPECT_EQ(built.report.onRoad, 1u);
}

TEST(Houses, OfTwoOverEachOtherTheLargerStays)
{
    Village village;
    village.box(0, 20, 12, 10);
    village.box(6, 24, 20, 10);
    village.box(26, 24, 10, 10); // shares a wall with the second
    const Built built(village);
    EXPECT_EQ(built.houses.size(), 2u);
    EXPECT_EQ(built.report.overlapping, 1u);
}

TEST(Houses, OneInALakeIsLeftOut)
{
    Village village;
    village.box(0, 20, 12, 10);
    village.box(-40, 15, 80, 40, "natural", "water");
    const Built built(village);
    EXPECT_TRUE(built.houses.empty());
    EXPECT_EQ(built.report.inWater, 1u);
}

TEST(Houses, OneOnARunwaysStripIsLeftOut)
{
    Village village;
    village.box(0, 20, 12, 10);
    village.box(80, 20, 12, 10);
    const glm::dvec2 middle = Built(village).houses[0].building.rings[0][0];
    const Built built(village, {{{middle - 20.0, middle + glm::dvec2(20, -20), middle + 20.0,
                                  middle + glm::dvec2(-20, 20)}}});
    EXPECT_EQ(built.houses.size(), 1u);
    EXPECT_EQ(built.report.onRunway, 1u);
}

TEST(Houses, TheMeasuresSeeAHouseThatIsMovedOntoTheStreetOrItsNeighbour)
{
    Village village;
    village.box(0, 10, 12, 10);
    village.box(20, 10, 12, 10);
    const Built built(village);
    ASSERT_EQ(built.houses.size(), 2u);
    const RoadRoom room(built.streets.network);
    PlanRings onStreet = built.houses[0].building.rings, onOther = onStreet;
    for (glm::dvec2& corner : onStreet[0])
        corner.y -= 12.0;
    for (glm::dvec2& corner : onOther[0])
        corner.x += 15.0;
    EXPECT_GT(room.distanceM(built.houses[0].building.rings, 100.0), 5.0);
    EXPECT_EQ(room.distanceM(onStreet, 100.0), 0.0);
    const auto& neighbour = built.houses[1].building.rings;
    EXPECT_EQ(commonAreaOf(built.houses[0].building.rings, neighbour), 0.0);
    EXPECT_GT(commonAreaOf(onOther, neighbour), 50.0);
}

/// A house of 30 m across a street of which the part through it has a tag, and the areas on and over it.
struct Passage
{
    std::size_t beside = 0, over = 0, passages = 0;
    double overM2 = 0.0;
    bool areOne = false; ///< building

    Passage(const char* key, const char* value, const char* heightM)
    {
        Village village;
        village.map = MadeMap();
        const int a = village.map.node(-200, 0), b = village.map.node(-6, 0), c = village.map.node(6, 0),
                  d = village.map.node(200, 0);
        village.map.way({a, b});
        village.map.way({b, c}, {{"highway", "residential"}, {key, value}});
        village.map.way({c, d});
        const int first = village.map.node(-6, -15), e = village.map.node(6, -15),
                  f = village.map.node(6, 15), g = village.map.node(-6, 15);
        village.map.way({first, e, f, g, first}, {{"building", "yes"}, {"height", heightM}});
        const Built built(village);
        passages = built.report.passages;
        areOne = !built.houses.empty();
        for (const House& house : built.houses)
            areOne = areOne && house.whole != 0 && house.whole == built.houses.front().whole;
        for (const House& house : built.houses)
            if (house.building.liftedM > 0.0)
            {
                ++over;
                overM2 += scenery::areaOf(house.building.rings);
                EXPECT_EQ(house.building.liftedM, kPassageM);
            }
            else
                ++beside;
    }
};

TEST(Houses, AStreetRunsThroughAHouseWithAPassage)
{
    const Passage passage("tunnel", "building_passage", "12");
    EXPECT_EQ(passage.passages, 1u);
    EXPECT_EQ(passage.beside, 2u);
    EXPECT_EQ(passage.over, 1u);
    EXPECT_TRUE(passage.areOne) << "with one floor";
    EXPECT_NEAR(passage.overM2, 12.0 * 6.5, 6.0); // two lanes of 2.75 m, half a metre beside each
    const Passage covered("covered", "yes", "9");
    EXPECT_EQ(covered.over, 1u);
    const Passage low("tunnel", "building_passage", "4"); // too low for a car: a gap
    EXPECT_EQ(low.beside, 2u);
    EXPECT_EQ(low.over, 0u);
    const Passage none("lit", "yes", "12"); // cut back as before
    EXPECT_EQ(none.passages, 0u);
    EXPECT_FALSE(none.areOne);
    EXPECT_EQ(none.over, 0u);
}

} // namespace
