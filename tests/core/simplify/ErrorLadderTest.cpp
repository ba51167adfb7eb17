// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgPMObjects/core/simplify/ErrorLadder.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;

using Levels = std::vector<MeasuredLevel>;

TEST(ErrorLadder, ThatIsOutOfOrderOrNotFiniteIsNone)
{
    const Levels levels = {{0, {}}, {3, {1.0f, 0.5f}}, {9, {0.5f, 0.25f}}};
    const auto areWith = [&](auto change)
    {
        Levels changed = levels;
        change(changed);
        return areMeasured(changed);
    };
    EXPECT_TRUE(areWith([](Levels&) {}));
    EXPECT_TRUE(areWith([](Levels& l) { l.clear(); }));
    EXPECT_FALSE(areWith([](Levels& l) { l.erase(l.begin()); }));
    EXPECT_FALSE(areWith([](Levels& l) { l[2].steps = 3; }));
    EXPECT_FALSE(areWith([](Levels& l) { l[1].error.maximum = std::nanf(""); }));
    EXPECT_FALSE(areWith([](Levels& l) { l[1].error.rootMeanSquare = -1.0f; }));
    EXPECT_FALSE(areWith([](Levels& l) { l[2].error.maximum = INFINITY; }));
}

TEST(ErrorLadder, HasNeighboursWithinTheRatioWhereNoStepRemovesMore)
{
    std::vector<std::uint32_t> faces;
    testsupport::Random random(3);
    for (std::uint32_t left = 5000; left > 0; left -= std::min(left, random.below(4)))
        faces.push_back(left);
    faces.insert(faces.end(), 5, 0u);
    for (const double ratio : {1.05, 1.125, 1.25})
    {
        const auto steps = ladderSteps(faces, ratio);
        ASSERT_FALSE(steps.empty());
        EXPECT_EQ(steps.front(), 0u);
        EXPECT_GT(faces[steps.back()], 0u);
        EXPECT_EQ(faces[steps.back() + 1], 0u) << "the last level with faces";
        for (std::size_t i = 1; i < steps.size(); ++i)
        {
            ASSERT_LT(faces[steps[i]], faces[steps[i - 1]]);
            if (faces[steps[i - 1]] > faces[steps[i]] * ratio)
            {
                EXPECT_LE(faces[steps[i - 1]] - faces[steps[i]], 3u) << "a single step";
            }
        }
        const double all = std::log(5000.0) / std::log(ratio);
        EXPECT_LT(static_cast<double>(steps.size()), 1.2 * all + 4.0) << "no more levels than needed";
    }
    EXPECT_TRUE(ladderSteps(std::vector<std::uint32_t>{0}, 1.25).empty());
}

/// Returns the answer by looking at every number of steps.
std::uint32_t coarsestByLooking(const ErrorLadder& ladder, double tolerance, ErrorKind kind,
                                std::uint32_t most)
{
    for (std::uint32_t steps = std::min(most, ladder.levels().back().steps); steps > 0; --steps)
        if (ladder.errorAfter(steps, kind) <= tolerance) return steps;
    return 0;
}

TEST(ErrorLadder, FindsTheCoarsestLevelThoughErrorsFall)
{
    testsupport::Random random(4);
    for (int round = 0; round < 50; ++round)
    {
        Levels levels = {{0, {}}};
        for (std::uint32_t i = 1; i < 30; ++i)
            levels.push_back(
                {levels.back().steps + 1 + random.below(5),
                 {static_cast<float>(i + 12.0 * random.unit()), static_cast<float>(random.unit())}});
        const ErrorLadder ladder(levels);
        for (const ErrorKind kind : {ErrorKind::maximum, ErrorKind::rootMeanSquare})
            for (int ask = 0; ask < 40; ++ask)
            {
                const double tolerance = (kind == ErrorKind::maximum ? 45.0 : 1.0) * random.unit();
                const std::uint32_t most = random.below(100);
                ASSERT_EQ(ladder.coarsestWithin(tolerance, kind),
                          coarsestByLooking(ladder, tolerance, kind, ~0u));
                ASSERT_EQ(ladder.coarsestWithin(tolerance, kind, most),
                          coarsestByLooking(ladder, tolerance, kind, most));
            }
    }
}

TEST(ErrorLadder, TakesTheErrorOfTheCoarserNeighbour)
{
    const ErrorLadder ladder(Levels{{0, {}}, {4, {1.0f, 0.5f}}, {8, {3.0f, 0.7f}}});
    EXPECT_EQ(ladder.errorAfter(0, ErrorKind::maximum), 0.0f);
    EXPECT_EQ(ladder.errorAfter(1, ErrorKind::maximum), 1.0f);
    EXPECT_EQ(ladder.errorAfter(5, ErrorKind::maximum), 3.0f);
    EXPECT_EQ(ladder.errorAfter(8, ErrorKind::rootMeanSquare), 0.7f);
    EXPECT_TRUE(std::isinf(ladder.errorAfter(9, ErrorKind::maximum)));
}

TEST(LadderSettings, OutOfRangeAreNamed)
{
    EXPECT_TRUE(checkSettings(LadderSettings{}));
    EXPECT_EQ(checkSettings(LadderSettings{.ratio = 1.0}).error().place, "ladder.ratio");
    EXPECT_EQ(checkSettings(LadderSettings{.ratio = 1.3}).error().place, "ladder.ratio");
    EXPECT_EQ(checkSettings(LadderSettings{.samples = 1}).error().place, "ladder.samples");
}

} // namespace
