// SPDX-License-Identifier: Apache-2.0
// Where houses stand close the ground between them is paved.
#include "worldmaking/land/Yards.h"

#include <vector>

#include <gtest/gtest.h>

namespace
{

using namespace worldmaking;

PlanRings rectangleAt(double eastM, double northM, double wideM, double deepM)
{
    std::vector<glm::dvec2> ring;
    ring.emplace_back(eastM, northM);
    ring.emplace_back(eastM + wideM, northM);
    ring.emplace_back(eastM + wideM, northM + deepM);
    ring.emplace_back(eastM, northM + deepM);
    return PlanRings(1, ring);
}

/// Two rows of houses along a street of 8 m to the east, from `eastM` on for 200 m.
void addRows(std::vector<House>& houses, double eastM, double wideM, double deepM, double gapM)
{
    House house;
    for (double at = eastM; at + wideM <= eastM + 200.0; at += wideM + gapM)
    {
        house.building.rings = rectangleAt(at, 104.0, wideM, deepM);
        houses.push_back(house);
        house.building.rings = rectangleAt(at, 96.0 - deepM, wideM, deepM);
        houses.push_back(house);
    }
}

/// A settlement of 600 × 200 m: row houses without gaps in the west, houses in gardens in the east.
struct Town
{
    CoverRaster cover = CoverRaster(MapBox{glm::dvec2(0.0), glm::dvec2(600.0, 200.0)}, 10.0);
    std::vector<House> houses;

    Town()
    {
        cover.paint(rectangleAt(0.0, 0.0, 600.0, 200.0), Cover::garden);
        addRows(houses, 0.0, 10.0, 12.0, 0.0);
        addRows(houses, 400.0, 11.0, 9.0, 12.0);
    }
};

} // namespace

TEST(Yards, LieWhereHousesStandCloseAndNowhereElse)
{
    Town town;
    const std::size_t gardens = town.cover.count(Cover::garden);
    const std::size_t yards = layYards(town.cover, town.houses);
    // Rows of 200 m: 24 of the 50 m across are houses wherever both rows lie in the square.
    EXPECT_GT(yards, 40u);
    EXPECT_LT(yards, 120u);
    EXPECT_EQ(town.cover.count(Cover::yard), yards);
    EXPECT_EQ(town.cover.count(Cover::garden), gardens - yards);
    EXPECT_EQ(town.cover.at({100.0, 100.0}), Cover::yard);
    EXPECT_EQ(town.cover.at({100.0, 20.0}), Cover::garden) << "80 m behind the row";
    EXPECT_EQ(town.cover.at({300.0, 100.0}), Cover::garden) << "no house there";
    for (double eastM = 405.0; eastM < 600.0; eastM += 10.0)
        EXPECT_EQ(town.cover.at({eastM, 105.0}), Cover::garden) << eastM;
}

TEST(Yards, AreMadeOfGardensAloneAndNotBelowWhatIsLifted)
{
    Town town;
    town.cover.paint(rectangleAt(0.0, 0.0, 200.0, 200.0), Cover::grass);
    EXPECT_EQ(layYards(town.cover, town.houses), 0u) << "a park between row houses stays one";
    Town lifted;
    for (House& house : lifted.houses)
        house.building.liftedM = 4.5;
    EXPECT_EQ(layYards(lifted.cover, lifted.houses), 0u);
}
