// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/BenefitCurve.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

TEST(CostModel, AddsTrianglesVerticesAndTheDraw)
{
    EXPECT_EQ(CostModel{}.of(1000, 500), 1000u);
    EXPECT_EQ((CostModel{2.0, 3.0, 100.0}).of(10, 5), 135u);
    EXPECT_EQ((CostModel{0.5, 0.0, 0.0}).of(3, 0), 2u); // rounded up
}

TEST(BenefitCurve, IsTheUpperHullOfAnyPoints)
{
    Random random(14);
    for (int round = 0; round < 500; ++round)
    {
        std::vector<BenefitPoint> points;
        for (std::uint32_t i = 0; i < 1 + random.below(20); ++i)
            points.push_back({i, random.below(50), random.below(40) * 0.025});
        const BenefitCurve curve = BenefitCurve::hullOf(points);
        ASSERT_TRUE(isBenefitCurve(curve));
        for (const BenefitPoint& p : points)
            for (std::size_t i = 1; i < curve.points.size(); ++i)
            { // no point above any edge's line
                const BenefitPoint &a = curve.points[i - 1], &b = curve.points[i];
                const double slope = (b.gain - a.gain) / (double(b.cost) - double(a.cost));
                if (p.cost < curve.points.front().cost) continue;
                EXPECT_LE(p.gain, a.gain + slope * (double(p.cost) - double(a.cost)) + 1e-12);
            }
    }
}

TEST(BenefitCurve, ThatBendsTheWrongWayIsNone)
{
    EXPECT_TRUE(isBenefitCurve({{{2, 10, 0.0}, {1, 20, 0.6}, {0, 40, 1.0}}}));
    EXPECT_FALSE(isBenefitCurve({{{2, 10, 0.0}, {1, 20, 0.2}, {0, 40, 1.0}}}));
    EXPECT_FALSE(isBenefitCurve({{{2, 10, 0.0}, {1, 10, 0.2}}}));
    EXPECT_FALSE(isBenefitCurve({{{2, 10, 0.0}, {1, 20, 0.0}}}));
    EXPECT_FALSE(isBenefitCurve({}));
}

TEST(BenefitCurve, OfAModelGoesFromItsCoarsestLevelToItsFirstWithoutError)
{
    LevelTable table = testsupport::levelTable(1000);
    table.errors[1] = table.errors[2] = {}; // two steps for nothing
    const BenefitCurve curve = BenefitCurve::of(table, 1.0, {}, {}, 1000);
    ASSERT_TRUE(isBenefitCurve(curve));
    EXPECT_EQ(curve.points.front().steps, table.mostSteps());
    EXPECT_EQ(curve.points.front().cost, 4u);
    EXPECT_EQ(curve.points.back().steps, 2u);
    EXPECT_GT(curve.points.size(), 20u);
    EXPECT_LE(BenefitCurve::of(table, 1.0, {}).points.size(), 32u);
    EXPECT_GT(BenefitCurve::of(table, 1.0, {}).points.size(), 15u);
}

TEST(BenefitCurve, OfASingleLevelIsOnePoint)
{
    LevelTable table;
    table.faces = {12};
    table.errors = {{}};
    table.positions = 8;
    const BenefitCurve curve = BenefitCurve::of(table, 1.0, {});
    ASSERT_EQ(curve.points.size(), 1u);
    EXPECT_EQ(curve.points[0].cost, 12u);
}

} // namespace
