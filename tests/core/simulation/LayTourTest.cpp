// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/LayTour.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "simulation/player/ScenarioPlayer.h"
#include "simulation/tour/FlightPlan.h"
#include "simulation/tour/HeightProfile.h"
#include "simulation/tour/LayDrive.h"
#include "simulation/writer/WriteScenario.h"

namespace simulation
{
namespace
{

/// A plain with a lone mountain in the north-east, rough all over.
double mountain(double east, double north)
{
    const double away = std::hypot(east - 6000.0, north - 5000.0);
    return 200.0 + 1500.0 * std::exp(-away * away / 8e6) +
           15.0 * std::sin(east / 150.0) * std::cos(north / 170.0);
}

TourTerrain square(double halfSideM, std::function<double(double, double)> height, double spacingM)
{
    return {
        -halfSideM, -halfSideM, halfSideM, halfSideM, std::move(height), spacingM, Geodetic{46.5, 8.0, 0.0},
        "x.tif"};
}

/// The sizes that tours are laid over: a lidar tile, an island, a degree of mountains, a sea with a strip of
/// land, a flat sea, a ravine.
std::vector<std::pair<const char*, TourTerrain>> terrains()
{
    std::vector<std::pair<const char*, TourTerrain>> list;
    list.emplace_back("lidar", TourTerrain{-1000, -500, 1000, 500,
                                           [](double e, double n) {
                                               return 1300.0 + 20.0 * std::tanh(n / 60.0) + std::sin(e / 9.0);
                                           },
                                           1.0, Geodetic{38.0, -110.0, 0.0}, "x.tif"});
    list.emplace_back("island", square(12'000.0, mountain, 12.0));
    list.emplace_back("degree", square(
                                    50'000.0,
                                    [](double e, double n) {
                                        return 1500.0 + 900.0 * std::sin(e / 4000.0) * std::cos(n / 5200.0) +
                                               300.0 * std::sin(e / 900.0);
                                    },
                                    90.0));
    list.emplace_back("coast", square(
                                   50'000.0,
                                   [](double e, double n)
                                   { return n > 46'000.0 ? 80.0 * std::fabs(std::sin(e / 2000.0)) : 0.0; },
                                   30.0));
    list.emplace_back("sea", square(
                                 50'000.0, [](double, double) { return 0.0; }, 90.0));
    list.emplace_back("ravine",
                      TourTerrain{0, 0, 500, 380,
                                  [](double e, double)
                                  { return 100.0 - 30.0 * std::exp(-(e - 250.0) * (e - 250.0) / 400.0); },
                                  5.0, std::nullopt, "x.asc"});
    return list;
}

std::vector<EntityState> flown(const Tour& tour, const TourTerrain& terrain)
{
    PlayerOptions options;
    options.origin = terrain.origin;
    options.clock = FixedClock(48);
    auto player = ScenarioPlayer::create(tour.scenario, options);
    EXPECT_TRUE(player) << player.error().message();
    std::vector<EntityState> states;
    for (; player && !(*player)->isFinished(); (*player)->step())
        states.push_back((*player)->entities().at(0));
    return states;
}

TEST(LayTour, KeepsClearTurnsGentlyAndStaysInside)
{
    for (const auto& [name, terrain] : terrains())
    {
        const auto tour = layTour(terrain);
        ASSERT_TRUE(tour) << name << tour.error().message();
        const TourScale scale = TourScale::of(terrain, 20.0);
        const std::vector<EntityState> states = flown(*tour, terrain);
        ASSERT_EQ(states.size(), 20u * 48u) << name;
        for (std::size_t i = 0; i < states.size(); ++i)
        {
            const glm::dvec3 at = states[i].position;
            ASSERT_GE(at.z - terrain.heightM(at.x, at.y), scale.clearanceM - 0.01) << name << i;
            ASSERT_TRUE(at.x > terrain.westM && at.x < terrain.eastM && at.y > terrain.southM &&
                        at.y < terrain.northM)
                << name << i;
            ASSERT_LE(std::fabs(states[i].rollDeg), 30.0) << name << i;
            ASSERT_NEAR(states[i].speedMps, scale.speedMps, 0.06 * scale.speedMps) << name << i;
            if (i == 0) continue;
            const double turn = std::remainder(states[i].headingDeg - states[i - 1].headingDeg, 360.0) * 48.0;
            ASSERT_LE(std::fabs(turn), glm::degrees(scale.turnRateRadPerS) * 1.25) << name << i;
            const double climb =
                (at.z - states[i - 1].position.z) / glm::length(glm::dvec2(at - states[i - 1].position));
            ASSERT_LE(climb, scale.climbSlope * 1.05) << name << i;
            ASSERT_GE(climb, -scale.sinkSlope * 1.05) << name << i;
        }
    }
}

TEST(LayTour, ShowsThreeHeightsOverOpenLand)
{
    for (const auto& [name, terrain] : terrains())
    {
        if (std::string(name) != "coast" && std::string(name) != "sea" && std::string(name) != "lidar")
            continue;
        const TourScale scale = TourScale::of(terrain, 20.0);
        int low = 0;
        int medium = 0;
        int high = 0;
        for (const EntityState& state : flown(*layTour(terrain), terrain))
        {
            const double above = state.position.z - terrain.heightM(state.position.x, state.position.y);
            low += above < 0.8 * scale.mediumM;
            medium += above >= 0.8 * scale.mediumM && above < 1.3 * scale.mediumM;
            high += above >= 1.3 * scale.mediumM;
        }
        EXPECT_GT(low, 96) << name;
        EXPECT_GT(medium, 96) << name;
        EXPECT_GT(high, 96) << name;
    }
}

/// The share of a flight's places from which a point lies ahead, within 30 degrees and 8 km.
double shareFacing(const std::vector<EntityState>& states, const glm::dvec2& point)
{
    double facing = 0.0;
    for (const EntityState& state : states)
    {
        const glm::dvec2 to = point - glm::dvec2(state.position);
        const double headingDeg = glm::degrees(std::atan2(to.y, to.x));
        const bool isAhead = std::fabs(std::remainder(headingDeg - state.headingDeg, 360.0)) < 30.0;
        facing += isAhead && glm::length(to) < 8000.0 ? 1.0 : 0.0;
    }
    return facing / static_cast<double>(states.size());
}

TEST(LayTour, KeepsToMeasuredGroundAndSaysHowMuchItSeesIsFilled)
{
    TourTerrain terrain = square(12'000.0, mountain, 12.0);
    const auto measured = layTour(terrain);
    ASSERT_TRUE(measured);
    EXPECT_EQ(measured->filledShare, 0.0);
    EXPECT_GT(shareFacing(flown(*measured, terrain), {6000.0, 5000.0}), 0.3);
    // The mountain is the fill of a void.
    terrain.isMeasured = [](double east, double north)
    { return std::hypot(east - 6000.0, north - 5000.0) > 5000.0; };
    const auto tour = layTour(terrain);
    ASSERT_TRUE(tour);
    EXPECT_LT(tour->filledShare, 0.05);
    EXPECT_LT(shareFacing(flown(*tour, terrain), {6000.0, 5000.0}), 0.1);
    // Where all is filled, there is no choice, and it is said.
    terrain.isMeasured = [](double, double) { return false; };
    EXPECT_GT(layTour(terrain)->filledShare, 0.99);
}

TEST(LayTour, HeightsAndSpeedsFitTheExtent)
{
    const TourScale lidar = TourScale::of(terrains()[0].second, 20.0);
    EXPECT_NEAR(lidar.speedMps, 40.0, 1.0);
    EXPECT_GT(lidar.lowM, 40.0);
    EXPECT_LT(lidar.highM, 150.0);
    const TourScale degree = TourScale::of(terrains()[2].second, 20.0);
    EXPECT_GT(degree.speedMps, 150.0);
    EXPECT_LE(degree.speedMps, 250.0);
    EXPECT_GT(degree.lowM, 200.0);
}

TEST(LayTour, HeadsForTheMountainAndForTheLand)
{
    const auto island = layTour(terrains()[1].second);
    EXPECT_LT(glm::length(glm::dvec2(island->highlight) - glm::dvec2(6000.0, 5000.0)), 2500.0);
    const std::vector<EntityState> states = flown(*island, terrains()[1].second);
    const glm::dvec3 towards = island->highlight - states.back().position;
    const glm::dvec3 ahead = states.back().bodyToLocal()[0];
    EXPECT_GT((towards.x * ahead.x + towards.y * ahead.y) / std::hypot(towards.x, towards.y), 0.95);
    EXPECT_GT(layTour(terrains()[3].second)->highlight.y, 44'000.0);
}

TEST(LayTour, IsTheSameEveryTimeAndDiffersWithTheLand)
{
    const TourTerrain terrain = terrains()[1].second;
    EXPECT_EQ(layTour(terrain)->scenario, layTour(terrain)->scenario);
    TourTerrain mirrored = terrain;
    mirrored.heightM = [](double e, double n) { return mountain(-e, n); };
    EXPECT_NE(layTour(terrain)->scenario, layTour(mirrored)->scenario);
}

TEST(LayTour, ItsScenarioCanBeSaved)
{
    const auto text = scenarioText(layTour(terrains()[5].second)->scenario);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("WorldPosition"), std::string::npos);
    EXPECT_NE(scenarioText(layTour(terrains()[1].second)->scenario)->find("GeoPosition"), std::string::npos);
}

TEST(LayTour, BadTerrainsAndTimesAreErrors)
{
    TourTerrain terrain = terrains()[1].second;
    EXPECT_FALSE(layTour(terrain, {.durationS = 0.0}));
    EXPECT_FALSE(layTour(terrain, {.durationS = std::nan("")}));
    terrain.eastM = terrain.westM;
    EXPECT_FALSE(layTour(terrain));
    EXPECT_FALSE(layTour(square(
        1000.0, [](double, double) { return std::nan(""); }, 10.0)));
}

TEST(HeightProfile, ValidatorNoticesALowPlaceAndASteepOne)
{
    const TourTerrain terrain = terrains()[1].second;
    const TourScale scale = TourScale::of(terrain, 20.0);
    const FlightPlan plan = flightPlans(terrain, ReliefMap(terrain), scale).front();
    const HeightProfile good = heightProfile(plan, terrain, scale);
    EXPECT_TRUE(good.isWithin(scale));
    HeightProfile low = good;
    low.heightM[100] = low.groundM[100] + 0.5 * scale.clearanceM;
    EXPECT_FALSE(low.isWithin(scale));
    HeightProfile steep = good;
    for (std::size_t i = 100; i < steep.heightM.size(); ++i)
        steep.heightM[i] += 50.0;
    EXPECT_FALSE(steep.isWithin(scale));
}

TEST(LayDrive, GoesRoundTheHillOnTheGround)
{
    const auto hill = [](double e, double n) { return 40.0 * std::exp(-(e * e + n * n) / 5000.0); };
    const TourTerrain terrain = square(500.0, hill, 5.0);
    DriveOptions options;
    options.fromM = {-200.0, 0.0};
    options.toM = {200.0, 0.0};
    options.durationS = 60.0;
    const auto drive = layDrive(terrain, options);
    ASSERT_TRUE(drive) << drive.error().message();
    PlayerOptions stage;
    stage.origin = terrain.origin;
    stage.ground = [&](double e, double n) { return GroundSample{hill(e, n)}; };
    auto player = ScenarioPlayer::create(drive->scenario, stage);
    ASSERT_TRUE(player) << player.error().message();
    double nearest = 1e9;
    for (; !(*player)->isFinished(); (*player)->step())
    {
        const EntityState& car = (*player)->entities().at(0);
        ASSERT_TRUE(car.isOnGround);
        nearest = std::min(nearest, std::hypot(car.position.x, car.position.y));
        ASSERT_LT(car.speedMps, options.largestSpeedMps * 1.05);
        ASSERT_LT(std::fabs(car.pitchDeg), 12.0);
    }
    EXPECT_GT(nearest, 60.0);
    EXPECT_LT(glm::length(glm::dvec2((*player)->entities().at(0).position) - options.toM), 20.0);
    options.toM = {1000.0, 0.0};
    EXPECT_FALSE(layDrive(terrain, options));
}

TEST(LayDrive, AlongAWayItKeepsToTheLimitsAndStopsBeforeTheEnd)
{
    const TourTerrain terrain = square(
        500.0, [](double, double) { return 0.0; }, 5.0);
    std::vector<WayPoint> way;
    for (int i = 0; i <= 100; ++i) // a deck 7 m above the ground, faster from its middle on
        way.push_back({{double(i), 3.0, 7.0}, i < 50 ? 8.0 : 12.0});
    const auto drive = layDriveAlong(terrain, way, 60.0);
    ASSERT_TRUE(drive) << drive.error().message();
    PlayerOptions stage;
    stage.origin = terrain.origin;
    stage.ground = [](double, double, double from) { return GroundSample{from > 5.0 ? 7.0 : 0.0}; };
    auto player = ScenarioPlayer::create(drive->scenario, stage);
    ASSERT_TRUE(player) << player.error().message();
    double slowest = 1e9;
    for (; !(*player)->isFinished(); (*player)->step())
    {
        const EntityState& car = (*player)->entities().at(0);
        ASSERT_LT(car.speedMps, car.position.x < 46.0 ? 8.2 : 12.1) << car.position.x;
        ASSERT_NEAR(car.position.y, 3.0, 1e-3);
        ASSERT_NEAR(car.position.z, 7.0, 1e-3) << "off the deck";
        slowest = std::min(slowest, car.speedMps);
    }
    EXPECT_LT(slowest, 1.5);
    EXPECT_NEAR((*player)->entities().at(0).position.x, 85.0, 1.0) << "a tenth of the way is worn";
    EXPECT_FALSE(layDriveAlong(terrain, {{{0, 0, 0}, 9.0}, {{19, 0, 0}, 9.0}}, 60.0));
}

} // namespace
} // namespace simulation
