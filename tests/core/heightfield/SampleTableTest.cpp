// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/SampleTable.h>

#include "Random.h"

namespace
{

using namespace osgTerrainROAM::core;

/// Heights from -400 to 8800 m that are multiples of no step, as interpolated ones are.
std::vector<float> wideHeights()
{
    testsupport::Random random(5);
    std::vector<float> heights{-400.0f, 8800.0f};
    for (int i = 0; i < 5000; ++i)
        heights.push_back(static_cast<float>(-400.0 + 9200.0 * random.unit()));
    return heights;
}

double largestErrorM(const SampleTable& table, const std::vector<float>& heights)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < heights.size(); ++i)
        largest = std::max(largest, std::abs(double{table.heightM(i)} - double{heights[i]}));
    return largest;
}

TEST(SampleTable, KeepsACentimetreOverTheRangeOfTheEarthWithRoomForEdits)
{
    const std::vector<float> heights = wideHeights();
    const SampleTable table(heights, Storage::compact, kEditHeadroom);
    EXPECT_LE(largestErrorM(table, heights), 0.005);
    EXPECT_LE(largestErrorM(table, heights), 0.5 * table.heightQuantumM() + 1e-6);
    EXPECT_EQ(table.memoryBytes() / heights.size(), 6u);
    // A table of 16 bits would be off by more.
    std::vector<float> coarse = heights;
    for (float& h : coarse)
        h = 0.25f * std::round(h / 0.25f);
    EXPECT_GT(largestErrorM(SampleTable(coarse, Storage::compact), heights), 0.1);
}

TEST(SampleTable, KeepsWholeMetresExactly)
{
    std::vector<float> heights;
    for (int i = -400; i <= 8800; ++i)
        heights.push_back(static_cast<float>(i));
    EXPECT_EQ(largestErrorM(SampleTable(heights, Storage::compact, kEditHeadroom), heights), 0.0);
}

TEST(SampleTable, AHeightAndItsFlagDoNotTouchEachOther)
{
    std::vector<float> heights = wideHeights();
    SampleTable table(heights, Storage::compact);
    const float before = table.heightM(7);
    table.setElsewhere(7, true);
    EXPECT_TRUE(table.isElsewhere(7));
    EXPECT_EQ(table.heightM(7), before);
    table.setHeight(7, -123.456f);
    EXPECT_TRUE(table.isElsewhere(7));
    EXPECT_NEAR(table.heightM(7), -123.456f, 0.005);
    table.setElsewhere(7, false);
    EXPECT_FALSE(table.isElsewhere(7));
    EXPECT_NEAR(table.heightM(7), -123.456f, 0.005);
    SampleTable::Sample sample{};
    EXPECT_TRUE(table.read(7, sample));
    EXPECT_EQ(sample.heightM, table.heightM(7));
}

} // namespace
