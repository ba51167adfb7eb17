// SPDX-License-Identifier: Apache-2.0
// The parts of which maps are made up, each by the smallest example.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/madeup/Airfield.h"
#include "worldmaking/madeup/Bridges.h"
#include "worldmaking/madeup/Contours.h"
#include "worldmaking/madeup/Lakes.h"
#include "worldmaking/madeup/OpenLand.h"
#include "worldmaking/madeup/Parcels.h"
#include "worldmaking/madeup/Plots.h"
#include "worldmaking/madeup/RoadPlan.h"
#include "worldmaking/madeup/SmoothPath.h"

namespace
{

using namespace worldmaking;

constexpr MapBox kBox{{-3000.0, -3000.0}, {3000.0, 3000.0}};

template<class Height>
GroundGrid gridOf(const Height& height, double cellM = 20.0)
{
    return GroundGrid(kBox, cellM,
                      [&](const glm::dvec2& place) -> std::optional<double> { return height(place); });
}

TEST(GroundGrid, IsBilinearBetweenItsPoints)
{
    const GroundGrid grid = gridOf([](const glm::dvec2& p) { return 100.0 + 0.03 * p.x - 0.02 * p.y; });
    EXPECT_NEAR(*grid.heightM({13.0, -27.0}), 100.0 + 0.39 + 0.54, 1e-3);
    EXPECT_NEAR(grid.gradient({50.0, 50.0}).x, 0.03, 1e-5);
    EXPECT_FALSE(grid.heightM({3010.0, 0.0}));
    EXPECT_TRUE(grid.isLand({0.0, 0.0}));
}

TEST(Drainage, ATroughCollectsTheWaterOfItsSides)
{
    const GroundGrid grid =
        gridOf([](const glm::dvec2& p) { return 100.0 + 0.05 * std::abs(p.x) + 0.01 * p.y; });
    const Drainage drainage(grid);
    EXPECT_GT(drainage.areaKm2({0.0, -2900.0}), 15.0);
    EXPECT_LT(drainage.areaKm2({1500.0, 0.0}), 1.0);
    const auto streams = drainage.streams(2.0);
    ASSERT_EQ(streams.size(), 1u);
    EXPECT_NEAR(streams.front().points[5].x, 0.0, 25.0);
    EXPECT_LT(streams.front().points.back().y, streams.front().points.front().y);
}

TEST(RoadSearch, GoesRoundWhatIsBlockedAndFollowsWhatIsThere)
{
    const GroundGrid grid = gridOf([](const glm::dvec2&) { return 50.0; });
    const auto toll = [](const glm::dvec2& p) { return std::abs(p.x) < 100.0 && p.y < 800.0 ? -1.0 : 1.0; };
    RoadSearch search(grid, 50.0, toll);
    const auto path = search.path({-1000.0, 0.0}, {1000.0, 0.0});
    ASSERT_GT(path.size(), 2u);
    for (const glm::dvec2& place : path)
        EXPECT_GT(toll(place), 0.0);
    search.use(path);
    EXPECT_TRUE(search.isUsed(path[path.size() / 2]));
    const auto other = search.path({-1000.0, -200.0}, {1000.0, -200.0});
    std::size_t shared = 0;
    for (const glm::dvec2& place : other)
        shared += search.isUsed(place);
    EXPECT_GT(2 * shared, other.size());
}

TEST(RoadSearch, NeverClimbsMoreThanItMay)
{
    const auto height = [](const glm::dvec2& p)
    { return 1000.0 + 0.06 * p.y + 33.0 * std::sin(p.x / 300.0); };
    const GroundGrid grid = gridOf(height);
    const auto path = RoadSearch(grid, 50.0, [](const glm::dvec2&) { return 1.0; })
                          .path({-2000.0, -1000.0}, {2000.0, 1000.0});
    ASSERT_GT(path.size(), 2u);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        EXPECT_LE(std::abs(height(path[i]) - height(path[i + 1])),
                  (RoadSearch::kSteepest + 1e-3) * glm::distance(path[i], path[i + 1]));
    const GroundGrid wall = gridOf([](const glm::dvec2& p) { return p.x > 0.0 ? 500.0 : 10.0; });
    EXPECT_TRUE(RoadSearch(wall, 50.0, [](const glm::dvec2&) { return 1.0; })
                    .path({-500.0, 0.0}, {500.0, 0.0})
                    .empty());
}

TEST(RoadPlan, NeighboursHangTogether)
{
    std::vector<Settlement> row;
    for (const double x : {0.0, 1000.0, 2000.0})
        row.push_back({SettlementKind::village, {x, 0.0}});
    const auto pairs = neighboursOf(row);
    ASSERT_EQ(pairs.size(), 2u); // the two ends have the middle one between them
    EXPECT_EQ(pairs[0], std::pair(std::size_t{0}, std::size_t{1}));
    EXPECT_EQ(pairs[1], std::pair(std::size_t{1}, std::size_t{2}));
}

TEST(WayWeb, WaysThatCrossGetAPointInCommon)
{
    WayWeb web;
    web.add({"tertiary", {{-100.0, 0.0}, {100.0, 0.0}}});
    web.add({"residential", {{10.0, -80.0}, {10.0, 80.0}}});
    web.add({"residential", {{-50.0, 0.0}, {-50.0, 60.0}}}); // ends on the first
    EXPECT_TRUE(web.crossesAnywhere());
    web.weave();
    EXPECT_FALSE(web.crossesAnywhere());
    ASSERT_EQ(web.ways()[0].points.size(), 4u);
    EXPECT_EQ(web.ways()[0].points[1], glm::dvec2(-50.0, 0.0));
    EXPECT_EQ(web.ways()[0].points[2], web.ways()[1].points[1]);
}

TEST(SmoothPath, KeepsItsEndsAndHasNoCorner)
{
    const std::vector<glm::dvec2> steps{{0.0, 0.0}, {500.0, 0.0}, {500.0, 500.0}};
    const auto path = smoothPath(steps);
    EXPECT_EQ(path.front(), steps.front());
    EXPECT_EQ(path.back(), steps.back());
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
        const glm::dvec2 in = glm::normalize(path[i] - path[i - 1]),
                         out = glm::normalize(path[i + 1] - path[i]);
        EXPECT_GT(glm::dot(in, out), 0.95);
    }
}

TEST(Airfield, LiesOnTheLevelAndNotOnAHill)
{
    const auto height = [](const glm::dvec2& p)
    {
        return p.x < 200.0 && std::abs(p.y) < 900.0
                   ? 100.0
                   : 100.0 + 30.0 * std::sin(p.x / 90.0) * std::sin(p.y / 70.0);
    };
    const auto field = airfieldOn(gridOf(height));
    ASSERT_TRUE(field);
    EXPECT_NEAR(glm::distance(field->from, field->to), Airfield::kLengthM, 1e-6);
    EXPECT_LT(field->unevenM, 0.5);
    EXPECT_LT(std::max(field->from.x, field->to.x), 250.0);
    EXPECT_FALSE(
        airfieldOn(gridOf([](const glm::dvec2& p) { return 0.2 * p.x + 40.0 * std::sin(p.y / 100.0); })));
}

/// A long slope of a half to the east, cut by gullies of 30 m, with a cliff across it.
double slopeWithCliff(const glm::dvec2& p)
{
    const double cliff = p.y > 1500.0 ? std::clamp(1.6 * (p.x + 400.0), 0.0, 400.0) : 0.0;
    return 800.0 + 0.25 * p.x + cliff +
           15.0 * std::sin(p.y / 60.0) * std::clamp((p.x + 3000.0) / 1000.0, 0.0, 1.0);
}

/// The standard deviation of the heights along outlines, away from the border of the box.
double spreadM(const std::vector<PlanRings>& areas)
{
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (const PlanRings& rings : areas)
        for (const auto& ring : rings)
            for (const glm::dvec2& at : ring)
            {
                if (std::max(std::abs(at.x), std::abs(at.y)) > 2900.0 || at.y > 1300.0) continue;
                const double height = slopeWithCliff(at);
                sum += height, squares += height * height, count += 1.0;
            }
    EXPECT_GT(count, 100.0);
    return std::sqrt(std::max(squares / count - sum * sum / (count * count), 0.0));
}

TEST(OpenLand, GrassEndsAtNoContour)
{
    const GroundGrid grid = gridOf(slopeWithCliff);
    constexpr double kTreeLineM = 700.0;
    EXPECT_GT(spreadM(openLandOn(grid, kTreeLineM, 1).grass), 50.0);
    // The mutation: grass up to a height.
    std::vector<float> below;
    for (int row = 0; row < grid.rows(); ++row)
        for (int column = 0; column < grid.columns(); ++column)
            below.push_back(static_cast<float>(kTreeLineM + 100.0 - grid.heightAt(column, row)));
    EXPECT_LT(spreadM(areasAbove(below, grid.columns(), kBox, grid.cellM(), 0.0, 1e5)), 10.0);
}

TEST(OpenLand, CliffsAreRockAndMeadowsAreGrass)
{
    const GroundGrid grid = gridOf(slopeWithCliff);
    const OpenLand open = openLandOn(grid, 1200.0, 1); // all of it lies below the line
    const auto share = [](const std::vector<PlanRings>& areas, double lowX, double highX, double lowY)
    {
        int within = 0, all = 0;
        for (double y = lowY; y < lowY + 1200.0; y += 40.0)
            for (double x = lowX; x < highX; x += 20.0, ++all)
                within += std::any_of(areas.begin(), areas.end(),
                                      [&](const PlanRings& area)
                                      { return scenery::isWithin(area, glm::dvec2(x, y)); });
        return static_cast<double>(within) / all;
    };
    EXPECT_GT(share(open.rock, -380.0, -180.0, 1600.0), 0.9);
    EXPECT_LT(share(open.grass, -380.0, -180.0, 1600.0), 0.1);
    EXPECT_GT(share(open.grass, -2500.0, -1500.0, -2000.0), 0.9);
    EXPECT_LT(share(open.rock, -2500.0, -1500.0, -2000.0), 0.05);
}

TEST(Lakes, HaveALevelShore)
{
    const auto height = [](const glm::dvec2& p)
    { return 200.0 + 1e-5 * glm::dot(p, p) + (p.y < -500.0 ? 20.0 : 0.0); };
    const GroundGrid grid = gridOf(height);
    const Drainage drainage(grid);
    const auto lakes = lakesOn(grid, drainage, 1, 3, {});
    ASSERT_FALSE(lakes.empty());
    double low = 1e9, high = -1e9;
    for (const glm::dvec2& place : lakes.front().front())
        low = std::min(low, height(place)), high = std::max(high, height(place));
    EXPECT_LE(high - low, 2.0 * kMostShoreM);
    AreaSet all;
    all.add({{{-3000.0, -3000.0}, {3000.0, -3000.0}, {3000.0, 3000.0}, {-3000.0, 3000.0}}});
    EXPECT_TRUE(lakesOn(grid, drainage, 1, 3, all).empty());
}

TEST(Parcels, ACutLosesNothing)
{
    const std::vector<glm::dvec2> square{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}};
    const auto [left, right] = cutRing(square, {3.0, 0.0}, {0.0, 1.0});
    EXPECT_NEAR(std::abs(scenery::turnedAreaOf(left)) + std::abs(scenery::turnedAreaOf(right)), 100.0, 1e-9);
    EXPECT_NEAR(std::abs(scenery::turnedAreaOf(left)), 30.0, 1e-9);
}

TEST(Parcels, SteepGroundIsLeftAndTakenGroundIsSpared)
{
    const auto wish = [](const glm::dvec2&) { return 1.0; };
    const PlanArea road = PlanArea::around({{-3000.0, 310.0}, {3000.0, 310.0}}, 8.0);
    const auto taken = [&](const MapBox&) { return road; };
    const GroundGrid level = gridOf([](const glm::dvec2& p) { return 100.0 + 0.03 * p.x; });
    const auto fields = parcelsOn({level, wish, taken, 1});
    ASSERT_GT(fields.size(), 200u);
    for (const PlanRings& field : fields)
        EXPECT_FALSE(PlanArea(field).grown(-0.01).meets(road));
    const GroundGrid steep = gridOf([](const glm::dvec2& p) { return 100.0 + 0.2 * p.x; });
    EXPECT_TRUE(parcelsOn({steep, wish, taken, 1}).empty());
}

TEST(TakenPlots, ARectangleIsTakenOnce)
{
    TakenPlots plots;
    EXPECT_TRUE(plots.take(rectangleOf({0.0, 0.0}, {1.0, 0.0}, 10.0, 8.0), 3.0));
    EXPECT_FALSE(plots.take(rectangleOf({11.0, 0.0}, {1.0, 0.0}, 10.0, 8.0), 3.0));
    EXPECT_TRUE(plots.take(rectangleOf({13.5, 0.0}, {1.0, 0.0}, 10.0, 8.0), 3.0));
    EXPECT_TRUE(plots.isFree(rectangleOf({0.0, 13.0}, glm::normalize(glm::dvec2(1.0, 1.0)), 8.0, 6.0), 1.0));
}

TEST(Bridges, ReachFromBankToBank)
{
    const GroundGrid grid =
        gridOf([](const glm::dvec2& p) { return 100.0 + std::min(8.0, 0.2 * std::abs(p.x)); });
    const std::vector<Stream> streams{{{{0.0, -500.0}, {0.0, 500.0}}, 10.0}};
    const MadeWay way{"tertiary", {{-200.0, 0.0}, {-70.0, 0.0}, {200.0, 0.0}}};
    const auto parts = bridgedParts(way, streams, grid, {});
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_TRUE(parts[1].isBridge);
    EXPECT_EQ(parts[0].points.back(), parts[1].points.front());
    EXPECT_EQ(parts[1].points.back(), parts[2].points.front());
    EXPECT_GE(*grid.heightM(parts[1].points.front()), 100.0 + kBankM - 0.7);
    EXPECT_EQ(bridgedParts(way, streams, grid, {{0.0, 0.0}}).size(), 1u); // a crossing there
    EXPECT_EQ(bridgedParts(way, {}, grid, {}).size(), 1u);
}

TEST(Contours, AHillIsOneAreaWithItsHole)
{
    const int columns = 60;
    std::vector<float> values;
    for (int row = 0; row < columns; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const double away = 10.0 * std::hypot(column - 29.5, row - 29.5);
            values.push_back(away > 80.0 && away < 200.0 ? 1.0F : -1.0F);
        }
    const auto areas = areasAbove(values, columns, {{0.0, 0.0}, {600.0, 600.0}}, 10.0, 0.0, 100.0);
    ASSERT_EQ(areas.size(), 1u);
    EXPECT_EQ(areas.front().size(), 2u);
    EXPECT_NEAR(scenery::areaOf(areas.front()), std::numbers::pi * (200.0 * 200.0 - 80.0 * 80.0), 6000.0);
    EXPECT_TRUE(scenery::isWithin(areas.front(), {300.0 + 140.0, 300.0}));
    EXPECT_FALSE(scenery::isWithin(areas.front(), {300.0, 300.0}));
}

} // namespace
