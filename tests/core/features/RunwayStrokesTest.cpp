// SPDX-License-Identifier: Apache-2.0
#include "RunwayStrokes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "RoadChains.h"

namespace
{

using namespace osgTerrainROAM::core;

const RunwayFrame kEastward{{0.0, 0.0}, {2000.0, 0.0}, 45.0, ""};

/// Painted area, m².
double paintedM2(const std::vector<Stroke>& strokes, FeatureCells::Paint paint)
{
    double area = 0.0;
    for (const Stroke& stroke : strokes)
        if (stroke.paint == paint) area += glm::distance(stroke.a, stroke.b) * 2.0 * stroke.halfWidthM;
    return area;
}

} // namespace

TEST(RunwayStrokes, AllMarkingsLieOnTheRunway)
{
    for (const double widthM : {18.0, 23.0, 30.0, 45.0, 60.0})
        for (const double lengthM : {250.0, 900.0, 3000.0})
        {
            const RunwayFrame frame{{0.0, 0.0}, {lengthM, 0.0}, widthM, "09L/27R"};
            for (const Stroke& stroke : runwayStrokes(frame))
            {
                if (stroke.paint != FeatureCells::white) continue;
                const glm::dvec2 along = glm::normalize(stroke.b - stroke.a);
                const glm::dvec2 half = glm::abs(glm::dvec2(along.y, along.x)) * stroke.halfWidthM;
                const glm::dvec2 low = glm::min(stroke.a, stroke.b) - half,
                                 high = glm::max(stroke.a, stroke.b) + half;
                EXPECT_GE(low.x, -1e-6) << widthM << ' ' << lengthM;
                EXPECT_LE(high.x, lengthM + 1e-6);
                EXPECT_LE(std::max(-low.y, high.y), 0.5 * widthM + 1e-6) << widthM << ' ' << lengthM;
            }
        }
}

TEST(RunwayStrokes, HasTheThresholdBarsOfItsWidth)
{
    for (const auto& [widthM, bars] : {std::pair{18.0, 4}, {23.0, 6}, {30.0, 8}, {45.0, 12}, {60.0, 16}})
    {
        const auto strokes = runwayStrokes({{0.0, 0.0}, {2000.0, 0.0}, widthM, ""});
        const auto isBar = [](const Stroke& stroke)
        {
            return stroke.paint == FeatureCells::white && std::abs(stroke.a.x - 6.0) < 1e-9 &&
                   std::abs(stroke.b.x - 36.0) < 1e-9;
        };
        EXPECT_EQ(std::count_if(strokes.begin(), strokes.end(), isBar), bars) << widthM;
    }
}

TEST(RunwayStrokes, RubberLiesAroundTheAimingPointsOfLongRunways)
{
    const auto strokes = runwayStrokes({{0.0, 0.0}, {2500.0, 0.0}, 45.0, ""});
    int atFirst = 0, atSecond = 0;
    for (const Stroke& stroke : strokes)
    {
        if (stroke.paint != FeatureCells::rubber) continue;
        const double awayM = std::min(stroke.a.x, 2500.0 - stroke.a.x);
        EXPECT_GE(awayM, 300.0);
        EXPECT_LE(awayM, 700.0);
        EXPECT_LT(std::abs(stroke.a.y), 6.0);
        ++(stroke.a.x < 1250.0 ? atFirst : atSecond);
    }
    EXPECT_EQ(atFirst, 70) << "two tyres of 35 landings";
    EXPECT_EQ(atSecond, 70);
    const auto isRubber = [](const Stroke& stroke) { return stroke.paint == FeatureCells::rubber; };
    const auto onShort = runwayStrokes({{0.0, 0.0}, {700.0, 0.0}, 45.0, ""});
    EXPECT_TRUE(std::none_of(onShort.begin(), onShort.end(), isRubber));
    const auto onGrass = runwayStrokes({{0.0, 0.0}, {2500.0, 0.0}, 45.0, "", true, false});
    EXPECT_TRUE(std::none_of(onGrass.begin(), onGrass.end(), isRubber));
}

TEST(RunwayStrokes, TheDesignatorFollowsFromTheDirection)
{
    // 09 has fewer strokes than 08, by one; both ends count.
    const auto named = [](const std::string& name) {
        return runwayStrokes({{0.0, 0.0}, {2000.0, 0.0}, 45.0, name}).size();
    };
    EXPECT_EQ(runwayStrokes(kEastward).size(), named("09/27"));
    EXPECT_EQ(named("08/26"), named("09/27") + 1 + 3) << "8 has a stroke more than 9, 6 three more than 7";
    EXPECT_EQ(paintedM2(runwayStrokes(kEastward), FeatureCells::asphalt), 2000.0 * 45.0);
}

TEST(RunwayStrokes, AnAreaThatIsLongIsARunwayAndOneThatIsNotAnApron)
{
    RunwayFrame frame{{}, {}, 0.0, ""};
    ASSERT_TRUE(runwayOfArea({{{0, 0}, {700, 0}, {1500, 0}, {1500, 30}, {0, 30}}}, frame));
    EXPECT_NEAR(frame.widthM, 30.0, 1e-9);
    EXPECT_NEAR(glm::distance(frame.a, frame.b), 1500.0, 1e-9);
    EXPECT_FALSE(runwayOfArea({{{0, 0}, {200, 0}, {200, 100}, {0, 100}}}, frame));
}

TEST(RoadChains, RoadsThatGoOnAsOneAnotherAreOne)
{
    FeatureStyle road, river;
    river.kind = FeatureKind::river;
    const auto line = [](const FeatureStyle& style, std::vector<glm::dvec2> points) {
        return GroundFeature{style, false, {std::move(points)}};
    };
    const std::vector<GroundFeature> features{
        line(road, {{10, 0}, {20, 0}}), line(road, {{10, 0}, {0, 0}}), line(road, {{20, 0}, {30, 5}}),
        line(river, {{30, 5}, {40, 5}}),
        // Three meet at (100, 0).
        line(road, {{90, 0}, {100, 0}}), line(road, {{100, 0}, {110, 0}}), line(road, {{100, 0}, {100, 9}})};
    const auto chains = joinedLines(features);
    ASSERT_EQ(chains.size(), 5u);
    EXPECT_EQ(chains[0].points, (std::vector<glm::dvec2>{{0, 0}, {10, 0}, {20, 0}, {30, 5}}));
}

TEST(RoadChains, ARingOfRoadsEnds)
{
    FeatureStyle road;
    const std::vector<GroundFeature> ring{{road, false, {{{0, 0}, {10, 0}}}},
                                          {road, false, {{{10, 0}, {10, 10}, {0, 0}}}},
                                          {road, false, {{{50, 50}, {60, 50}, {60, 60}, {50, 50}}}}};
    const auto chains = joinedLines(ring);
    ASSERT_EQ(chains.size(), 2u);
    EXPECT_EQ(chains[0].points.size(), 4u);
}
