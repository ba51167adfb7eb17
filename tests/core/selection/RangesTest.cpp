// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/AreaRows.h>
#include <osgPMObjects/core/selection/OverlappingRanges.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

const Ranges kRanges{{10.0, 20.0, 40.0, 90.0}, {0, 100, 200, 300, 400}};

TEST(Ranges, BeginAtTheirBoundary)
{
    const auto at = [](double d) { return rangeAt(kRanges.boundariesM, d); };
    EXPECT_EQ(at(0.0), 0u);
    EXPECT_EQ(at(9.999), 0u);
    EXPECT_EQ(at(10.0), 1u);
    EXPECT_EQ(at(89.0), 3u);
    EXPECT_EQ(at(90.0), 4u);
    EXPECT_EQ(at(1e9), 4u);
    EXPECT_EQ(rangeAt({}, 5.0), 0u);
}

TEST(Ranges, OutOfOrderAreNone)
{
    EXPECT_TRUE(isRanges(kRanges));
    EXPECT_TRUE(isRanges({{}, {7}}));
    EXPECT_FALSE(isRanges({{}, {}}));
    EXPECT_FALSE(isRanges({{10.0, 10.0}, {0, 1, 2}}));
    EXPECT_FALSE(isRanges({{0.0}, {0, 1}}));
    EXPECT_FALSE(isRanges({{10.0}, {1, 0}}));
    EXPECT_FALSE(isRanges({{10.0}, {0, 1, 2}}));
}

TEST(OverlappingRanges, OutOfOrderAreNone)
{
    EXPECT_TRUE(isOverlappingRanges(OverlappingRanges::around(kRanges)));
    EXPECT_FALSE(isOverlappingRanges({{{10.0, 10.0}}, {0, 1}}));
    EXPECT_FALSE(isOverlappingRanges({{{10.0, 12.0}, {9.0, 14.0}}, {0, 1, 2}}));
    EXPECT_FALSE(isOverlappingRanges({{{10.0, 12.0}, {11.0, 12.0}}, {0, 1, 2}}));
    EXPECT_FALSE(isOverlappingRanges({{{10.0, 12.0}}, {0}}));
}

TEST(OverlappingRanges, TheFarDistanceHoldsWhileRecedingTheNearOneWhileApproaching)
{
    const OverlappingRanges ranges{{{8.0, 12.0}, {18.0, 22.0}}, {0, 1, 2}};
    HeldLevel held;
    const auto at = [&](double d) { return held.level = overlappingRangeAt(ranges, d, held); };
    EXPECT_EQ(at(11.9), 0u);
    EXPECT_EQ(at(12.0), 1u);
    EXPECT_EQ(at(8.0), 1u);
    EXPECT_EQ(at(7.9), 0u);
    EXPECT_EQ(at(100.0), 2u); // two at once
    EXPECT_EQ(at(18.0), 2u);
    EXPECT_EQ(at(17.9), 1u);
    EXPECT_EQ(at(1.0), 0u);
}

/// Returns the most switches at any boundary for distances that vary by ±5 % about it. `row(distance, held)`.
template<class Row>
int mostSwitches(std::span<const double> boundaries, const Row& row)
{
    Random random(9);
    int most = 0;
    for (const double boundary : boundaries)
        for (double offset = 0.9; offset <= 1.1; offset += 0.01)
            for (const std::uint32_t start : {HeldLevel::kNone, 0u, 4u})
            {
                HeldLevel held{start};
                const auto level = [&](double d) { return held.level = row(d, held); };
                most = std::max(most, testsupport::switchesWhileTrembling(boundary * offset, 0.05, 5, level));
                most = std::max(
                    most, testsupport::switchesWhileWalking(random, boundary * offset, 0.05, 400, level));
            }
    return most;
}

TEST(OverlappingRanges, SwitchAtMostOnceWhileTheDistanceTremblesByFivePerCent)
{
    const auto ranges = OverlappingRanges::around(kRanges);
    const auto overlapping = [&](double d, HeldLevel held) { return overlappingRangeAt(ranges, d, held); };
    EXPECT_EQ(mostSwitches(kRanges.boundariesM, overlapping), 1);
    // Mutations: no overlap, and an overlap that is too small.
    const auto plain = [&](double d, HeldLevel) { return rangeAt(kRanges.boundariesM, d); };
    EXPECT_GT(mostSwitches(kRanges.boundariesM, plain), 1);
    const auto narrow = OverlappingRanges::around(kRanges, 1.08);
    const auto narrowly = [&](double d, HeldLevel held) { return overlappingRangeAt(narrow, d, held); };
    EXPECT_GT(mostSwitches(kRanges.boundariesM, narrowly), 1);
}

TEST(OverlappingRanges, SwitchOnceACrossingOnLongWalks)
{
    // Over everything: between two switches of one boundary the walk has been at both of its ends.
    Random random(10);
    const auto ranges = OverlappingRanges::around(kRanges);
    HeldLevel held;
    double log = std::log(15.0);
    std::uint32_t last = overlappingRangeAt(ranges, 15.0, held);
    int switches = 0;
    for (int i = 0; i < 100'000; ++i)
    {
        log = glm::clamp(log + testsupport::between(random, -0.03, 0.03), std::log(5.0), std::log(200.0));
        const double d = std::exp(log);
        const std::uint32_t row = held.level = overlappingRangeAt(ranges, d, held);
        for (std::uint32_t boundary = 0; boundary < ranges.boundaries.size(); ++boundary)
        {
            const bool recedes = row > boundary && last <= boundary;
            const bool approaches = row <= boundary && last > boundary;
            EXPECT_TRUE(!recedes || d >= ranges.boundaries[boundary].farM);
            EXPECT_TRUE(!approaches || d < ranges.boundaries[boundary].nearM);
        }
        switches += row != last;
        last = row;
    }
    EXPECT_GT(switches, 20);
}

TEST(AreaRows, AreLeftAtLessThanTheyComeBackAt)
{
    const AreaRows rows{{1000.0, 100.0}, {0, 1, 2}};
    ASSERT_TRUE(isAreaRows(rows));
    HeldLevel held;
    const auto at = [&](double area) { return held.level = areaRowAt(rows, area, 1.2, held); };
    EXPECT_EQ(at(1000.0), 0u);
    EXPECT_EQ(at(1000.0 / 1.43), 0u);
    EXPECT_EQ(at(1000.0 / 1.45), 1u);
    EXPECT_EQ(at(999.0), 1u);
    EXPECT_EQ(at(1000.0), 0u);
    EXPECT_EQ(at(0.0), 2u);
    EXPECT_EQ(at(std::numeric_limits<double>::infinity()), 0u);
    EXPECT_FALSE(isAreaRows({{100.0, 1000.0}, {0, 1, 2}}));
    EXPECT_FALSE(isAreaRows({{100.0, 0.0}, {0, 1, 2}}));
}

TEST(AreaRows, SwitchAtMostOnceWhileTheDistanceTremblesByFivePerCent)
{
    const AreaRows rows{{1e6 / 100, 1e6 / 400, 1e6 / 1600, 1e6 / 8100}, {0, 1, 2, 3, 4}};
    const auto with = [&](double band)
    {
        return mostSwitches(kRanges.boundariesM, [&, band](double d, HeldLevel held)
                            { return areaRowAt(rows, 1e6 / (d * d), band, held); });
    };
    EXPECT_EQ(with(kDefaultBand), 1);
    EXPECT_GT(with(1.0), 1);
    EXPECT_GT(with(1.08), 1);
}

TEST(AreaRows, HalvingGivesEachTriangleItsPixels)
{
    const LevelTable table = testsupport::levelTable(1000);
    const AreaRows rows = AreaRows::halving(table, 2.0);
    ASSERT_TRUE(isAreaRows(rows));
    EXPECT_EQ(rows.steps.size(), 8u); // 1996 faces … 15
    for (std::size_t row = 0; row < rows.leastPx.size(); ++row)
    {
        const double seen = 0.5 * table.faces[rows.steps[row]];
        EXPECT_NEAR(rows.leastPx[row] / seen, 2.0, 0.15) << row;
    }
}

} // namespace
