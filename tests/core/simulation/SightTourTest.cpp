// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "simulation/player/ScenarioPlayer.h"
#include "simulation/tour/LayTour.h"
#include "simulation/tour/SightPlans.h"
#include "simulation/tour/Sights.h"

namespace simulation
{
namespace
{

constexpr double kSeaM = -2000.0; ///< south of it there is the sea
const glm::dvec2 kTown(-3000.0, 1000.0), kVillage(-1500.0, 2800.0), kFarVillage(8000.0, 8000.0);

/// Land that rises from a straight shore, with a range in the north-east.
double landM(double, double north)
{
    return north < kSeaM ? 0.0 : 2.0 + 0.01 * (north - kSeaM);
}

double mountainousM(double east, double north)
{
    return landM(east, north) +
           1500.0 * std::exp(-(std::pow(east - 7000.0, 2) + std::pow(north - 2000.0, 2)) / 6e6);
}

TourTerrain countryOf(double (*height)(double, double))
{
    return {-12'000.0, -12'000.0, 12'000.0, 12'000.0, height, 12.0, std::nullopt, "x.tif"};
}

/// Houses in rows around a middle.
void addHouses(std::vector<glm::dvec2>& houses, const glm::dvec2& middle, int side)
{
    for (int i = 0; i < side * side; ++i)
        houses.push_back(middle +
                         30.0 * glm::dvec2(i % side - 0.5 * (side - 1), i / side - 0.5 * (side - 1)));
}

std::vector<glm::dvec2> houses()
{
    std::vector<glm::dvec2> list{{9000.0, -1000.0}, {9100.0, -1000.0}}; // two farms
    addHouses(list, kTown, 24);
    addHouses(list, kVillage, 7);
    addHouses(list, kFarVillage, 6);
    return list;
}

TourTerrain inhabited()
{
    TourTerrain terrain = countryOf(mountainousM);
    terrain.sights = settlementSights(houses());
    for (const Sight& shore : shoreSights(terrain, 0.0))
        terrain.sights.push_back(shore);
    return terrain;
}

std::vector<EntityState> flownPast(const Tour& tour)
{
    PlayerOptions options;
    options.clock = FixedClock(24);
    auto player = ScenarioPlayer::create(tour.scenario, options);
    EXPECT_TRUE(player) << player.error().message();
    std::vector<EntityState> states;
    for (; player && !(*player)->isFinished(); (*player)->step())
        states.push_back((*player)->entities().at(0));
    return states;
}

/// How long a place lies within 30 degrees ahead and within 3 km, seconds, in the first so many.
double seenS(const std::vector<EntityState>& states, const glm::dvec2& place, double untilS)
{
    double seen = 0.0;
    for (std::size_t i = 0; i < states.size() && static_cast<double>(i) < 24.0 * untilS; ++i)
    {
        const glm::dvec2 to = place - glm::dvec2(states[i].position);
        const double aside =
            std::remainder(glm::degrees(std::atan2(to.y, to.x)) - states[i].headingDeg, 360.0);
        seen += std::fabs(aside) < 30.0 && glm::length(to) < 3000.0 ? 1.0 / 24.0 : 0.0;
    }
    return seen;
}

TEST(Sights, GroupsOfHousesAreSettlementsByTheirSize)
{
    const std::vector<Sight> sights = settlementSights(houses());
    ASSERT_EQ(sights.size(), 3U) << "two farms are none";
    EXPECT_LT(glm::distance(sights[0].place, kTown), 1.0);
    EXPECT_LT(glm::distance(sights[1].place, kVillage), 1.0);
    EXPECT_LT(glm::distance(sights[2].place, kFarVillage), 1.0);
    EXPECT_NEAR(sights[0].weight, 0.25 * std::log(576.0 / 3.5), 1e-9);
    EXPECT_GT(sights[0].radiusM, 3.0 * sights[1].radiusM);
    EXPECT_TRUE(settlementSights({}).empty());
}

TEST(Sights, TheShoreIsWhereLandMeetsTheSea)
{
    const TourTerrain terrain = countryOf(landM);
    const std::vector<Sight> shores = shoreSights(terrain, 0.0);
    ASSERT_GE(shores.size(), 10U);
    for (const Sight& shore : shores)
        EXPECT_NEAR(shore.place.y, kSeaM, 200.0);
    EXPECT_TRUE(shoreSights(countryOf([](double, double) { return 300.0; }), 0.0).empty());
    EXPECT_TRUE(shoreSights(terrain, -50.0).empty());
}

TEST(SightTour, TheFirstTenSecondsShowTheTown)
{
    const TourTerrain terrain = inhabited();
    const auto tour = layTour(terrain);
    ASSERT_TRUE(tour) << tour.error().message();
    const std::vector<EntityState> states = flownPast(*tour);
    EXPECT_GT(seenS(states, kTown, 10.0), 6.0);
    EXPECT_GT(seenS(states, kVillage, 20.0), 4.0);
    EXPECT_LE(tour->speedMps, 110.0);
    // The control: relief alone leads to the mountain.
    TourTerrain empty = terrain;
    empty.sights.clear();
    EXPECT_LT(seenS(flownPast(*layTour(empty)), kTown, 10.0), 3.0);
}

TEST(SightTour, KeepsClearTurnsGentlyAndStaysInside)
{
    const TourTerrain terrain = inhabited();
    for (const double durationS : {20.0, 120.0})
    {
        const auto tour = layTour(terrain, {.durationS = durationS});
        ASSERT_TRUE(tour) << tour.error().message();
        const TourScale scale = TourScale::of(terrain, durationS);
        const std::vector<EntityState> states = flownPast(*tour);
        ASSERT_EQ(states.size(), static_cast<std::size_t>(24.0 * durationS));
        for (std::size_t i = 1; i < states.size(); ++i)
        {
            const glm::dvec3 at = states[i].position;
            ASSERT_GE(at.z - terrain.heightM(at.x, at.y), scale.clearanceM - 0.01) << i;
            ASSERT_TRUE(at.x > terrain.westM && at.x < terrain.eastM && at.y > terrain.southM &&
                        at.y < terrain.northM)
                << i;
            ASSERT_LE(std::fabs(states[i].rollDeg), 30.0) << i;
            const double turn = std::remainder(states[i].headingDeg - states[i - 1].headingDeg, 360.0) * 24.0;
            ASSERT_LE(std::fabs(turn), glm::degrees(scale.turnRateRadPerS) * 1.25) << i;
        }
    }
}

/// Passengers want few turns: those of more than 6 degrees of bank that follow another to the other side.
TEST(SightTour, DoesNotRollFromSideToSide)
{
    int turns = 0;
    double side = 0.0;
    for (const EntityState& state : flownPast(*layTour(inhabited())))
        if (std::fabs(state.rollDeg) > 6.0 && state.rollDeg * side <= 0.0)
        {
            side = state.rollDeg;
            ++turns;
        }
    EXPECT_LE(turns, 3);
}

TEST(SightTour, AMountainInFrontOfATownHidesIt)
{
    TourTerrain terrain = countryOf(landM);
    terrain.sights = {{kTown, 400.0, 1.0}};
    const TourScale scale = TourScale::of(terrain, 20.0);
    FlightPlan plan;
    HeightProfile profile;
    for (int i = 0; i <= 240; ++i)
    {
        plan.places.push_back(kTown + glm::dvec2(-2500.0 + 4.0 * i, 0.0));
        plan.headingsRad.push_back(0.0);
        profile.heightM.push_back(300.0);
    }
    const double open = shownSights(plan, profile, terrain, scale, 20.0);
    EXPECT_GT(open, 0.5);
    terrain.heightM = [](double east, double north)
    { return landM(east, north) + (std::fabs(east - kTown.x + 1000.0) < 300.0 ? 400.0 : 0.0); };
    EXPECT_LT(shownSights(plan, profile, terrain, scale, 20.0), 0.3 * open);
}

} // namespace
} // namespace simulation
