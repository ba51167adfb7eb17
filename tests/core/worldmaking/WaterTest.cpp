// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "RoughLand.h"
#include "worldmaking/check/LevelCheck.h"
#include "worldmaking/earth/WaterLevels.h"
#include "worldmaking/earth/WaterWorks.h"

using osgTerrainROAM::core::Earthworks;
using roughland::falling;
using roughland::inDegrees;
using roughland::kDegree;
using worldmaking::LandMap;
using worldmaking::LandShape;
using worldmaking::ShapeForm;
using worldmaking::waterLevels;
using worldmaking::WaterNet;

namespace
{

/// Whether no level is higher than one upstream.
bool falls(const WaterNet& net, const std::vector<double>& levels)
{
    return std::all_of(net.flows.begin(), net.flows.end(),
                       [&](const auto& flow) { return levels[flow.second] <= levels[flow.first] + 1e-9; });
}

} // namespace

TEST(WaterLevels, FallAlongALineByHand)
{
    const WaterNet line{{10.0, 12.0, 8.0, 9.0}, {{0, 1}, {1, 2}, {2, 3}}, {}};
    const auto levels = waterLevels(line);
    // Cut: 10, 10, 8, 8. Filled: 12, 12, 9, 9.
    EXPECT_NEAR(levels[0], 0.95 * 10.0 + 0.05 * 12.0, 1e-12);
    EXPECT_NEAR(levels[1], 0.95 * 10.0 + 0.05 * 12.0, 1e-12);
    EXPECT_NEAR(levels[2], 0.95 * 8.0 + 0.05 * 9.0, 1e-12);
    EXPECT_FALSE(falls(line, line.groundM)) << "the ground itself does not fall";
}

TEST(WaterLevels, NeverRiseInAnyNet)
{
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round)
    {
        WaterNet net;
        for (int i = 0; i < 50; ++i)
            net.groundM.push_back(static_cast<double>(random() % 1000));
        for (int i = 0; i < 70; ++i) // circles, too
            net.flows.emplace_back(random() % 50, random() % 50);
        EXPECT_TRUE(falls(net, waterLevels(net)));
    }
}

TEST(WaterLevels, FallsAreSpreadUpstream)
{
    // Three metres in the last 25 m: spread over as much of the way as kRiverGrade needs.
    WaterNet step{{103.0, 103.0, 103.0, 100.0}, {{0, 1}, {1, 2}, {2, 3}}, {25.0, 25.0, 25.0}};
    const auto levels = worldmaking::spreadFalls(step, step.groundM);
    EXPECT_NEAR(levels[2], 100.0 + 25.0 * worldmaking::kRiverGrade, 1e-9);
    EXPECT_NEAR(levels[1], 103.0, 1e-9);
    EXPECT_NEAR(levels[0], 103.0, 1e-9);
    // A fall of 40 m stays: no bed is cut more than kMostSpreadM deep.
    step.groundM = {140.0, 140.0, 140.0, 100.0};
    const auto real = worldmaking::spreadFalls(step, step.groundM);
    EXPECT_NEAR(real[2], 140.0 - worldmaking::kMostSpreadM, 1e-9);
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round)
    {
        WaterNet net;
        for (int i = 0; i < 50; ++i)
            net.groundM.push_back(static_cast<double>(random() % 1000));
        for (int i = 0; i < 70; ++i)
        {
            net.flows.emplace_back(random() % 50, random() % 50);
            net.flowsM.push_back(1.0 + static_cast<double>(random() % 100));
        }
        EXPECT_TRUE(falls(net, worldmaking::spreadFalls(net, waterLevels(net))));
    }
}

TEST(WaterLevels, GroundThatFallsIsKept)
{
    const WaterNet net{{30.0, 20.0, 10.0}, {{0, 1}, {1, 2}}, {}};
    EXPECT_EQ(waterLevels(net), net.groundM);
}

namespace
{

/// A lake of 200 m, and a river from it to the east.
LandMap lakeWithRiver()
{
    LandMap map;
    map.shapes.push_back(
        {1, ShapeForm::area, {inDegrees({{0, 0}, {200, 0}, {200, 200}, {0, 200}})}, {{"natural", "water"}}});
    map.shapes.push_back(
        {2, ShapeForm::line, {inDegrees({{150, 100}, {250, 100}, {600, 100}})}, {{"waterway", "river"}}});
    map.shapes.push_back({3, ShapeForm::line, {inDegrees({{0, 400}, {300, 400}})}, {{"waterway", "stream"}}});
    return map;
}

} // namespace

TEST(WaterWorks, ALakeAndItsRiverLieAsWaterDoes)
{
    const LandMap map = lakeWithRiver();
    const auto plane = worldmaking::MapPlane::create(worldmaking::planeAbout(map), "made");
    ASSERT_TRUE(plane);
    worldmaking::WaterReport report;
    const auto works = worldmaking::waterWorks(map, *plane, falling, report);
    EXPECT_EQ(report.lakes, 1u);
    EXPECT_EQ(report.rivers, 1u) << "streams stay as the ground is";
    const Earthworks shaped(works, 0.0, falling);
    const auto lake = plane->toPlan(map.shapes[0].paths);
    ASSERT_TRUE(lake);
    const foundation::HeightInPlan after = [&](const glm::dvec2& place) -> std::optional<double>
    { return shaped.heightM(place, *falling(place)); };
    EXPECT_TRUE(worldmaking::isEvenWater(worldmaking::waterFigures(*lake, {}, after)));
    EXPECT_LT(worldmaking::waterFigures(*lake, {}, after).slope, 1e-9);
    EXPECT_FALSE(worldmaking::isEvenWater(worldmaking::waterFigures(*lake, {}, falling))) << "as it was";
    double before = 1e9;
    for (double x = 160.0; x < 590.0; x += 2.0) // along the river, out of the lake
    {
        const auto place = plane->toPlan(glm::dvec2(x, 100.0) / kDegree);
        const double level = *after(*place);
        EXPECT_LE(level, before + 1e-6) << x;
        before = level;
    }
}

TEST(WaterWorks, WaterBeyondTheGroundIsCounted)
{
    const LandMap map = lakeWithRiver();
    const auto plane = worldmaking::MapPlane::create(worldmaking::planeAbout(map), "made");
    worldmaking::WaterReport report;
    const auto works = worldmaking::waterWorks(
        map, *plane, [](const glm::dvec2&) { return std::optional<double>(); }, report);
    EXPECT_TRUE(works.empty());
    EXPECT_EQ(report.beyondGround, 1u);
}

TEST(LevelCheck, FindsRunwaysThatAreSteepBentOrTilted)
{
    const glm::dvec2 from(0.0, 0.0), to(800.0, 0.0);
    const auto figures = [&](auto height)
    {
        return worldmaking::runwayFigures(
            from, to, 30.0, [=](const glm::dvec2& place) -> std::optional<double> { return height(place); });
    };
    EXPECT_TRUE(
        isEvenRunway(figures([](const glm::dvec2& p) { return 5.0 + 0.015 * p.x - 0.015 * std::abs(p.y); })));
    EXPECT_FALSE(isEvenRunway(figures([](const glm::dvec2& p) { return 0.04 * p.x; })));
    EXPECT_FALSE(isEvenRunway(figures([](const glm::dvec2& p) { return 0.04 * p.y; })));
    EXPECT_FALSE(
        isEvenRunway(figures([](const glm::dvec2& p) { return p.x < 400.0 ? 0.0 : 0.02 * (p.x - 400.0); })));
}
