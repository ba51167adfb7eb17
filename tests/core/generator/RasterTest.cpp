// SPDX-License-Identifier: Apache-2.0
#include "Raster.h"

#include <cmath>

#include <gtest/gtest.h>

#include "HeightQueue.h"
#include "Noise.h"
#include "Resample.h"

namespace islandgen
{

namespace
{

float bruteForceDistance(const Grid<std::uint8_t>& marked, int column, int row)
{
    float nearest = 4.0f * static_cast<float>(marked.side);
    for (int r = 0; r < marked.side; ++r)
    {
        for (int c = 0; c < marked.side; ++c)
        {
            if (!marked.at(c, r)) continue;
            const auto d2 = static_cast<float>((c - column) * (c - column) + (r - row) * (r - row));
            nearest = std::min(nearest, std::sqrt(d2));
        }
    }
    return nearest;
}

} // namespace

TEST(Raster, DistanceIsTheBruteForceOne)
{
    Grid<std::uint8_t> marked(33, 0);
    const Noise noise(5);
    for (int cell = 0; cell < marked.count(); ++cell)
        marked[cell] = noise.at(cell) < 0.02f;
    const Grid<float> distance = distanceTo(marked);
    for (int row = 0; row < marked.side; ++row)
    {
        for (int column = 0; column < marked.side; ++column)
        {
            ASSERT_FLOAT_EQ(distance.at(column, row), bruteForceDistance(marked, column, row));
        }
    }
}

TEST(Raster, DistanceWithoutAnyMarkIsFarOffTheGrid)
{
    const Grid<float> distance = distanceTo(Grid<std::uint8_t>(9, 0));
    for (const float cells : distance.cells)
        EXPECT_FLOAT_EQ(cells, 36.0f);
}

TEST(Raster, BlurKeepsAConstantAndSpreadsAPeak)
{
    const Grid<float> flat = blurred(Grid<float>(17, 3.0f), 2);
    for (const float value : flat.cells)
        EXPECT_FLOAT_EQ(value, 3.0f);
    Grid<float> peak(17);
    peak.at(8, 8) = 81.0f;
    const Grid<float> spread = blurred(peak, 1);
    EXPECT_FLOAT_EQ(spread.at(8, 8), 9.0f); // the tent's middle weight is 1/3 along each axis
    EXPECT_FLOAT_EQ(spread.at(10, 8), 3.0f);
    EXPECT_FLOAT_EQ(spread.at(11, 8), 0.0f);
}

TEST(Resample, KeepsSamplesOfTheCoarseGrid)
{
    Grid<float> coarse(9);
    const Noise noise(3);
    for (int cell = 0; cell < coarse.count(); ++cell)
        coarse[cell] = noise.at(cell);
    const Grid<float> fine = resampled(coarse, 17);
    for (int row = 0; row < coarse.side; ++row)
    {
        for (int column = 0; column < coarse.side; ++column)
        {
            EXPECT_FLOAT_EQ(fine.at(2 * column, 2 * row), coarse.at(column, row));
        }
    }
}

TEST(HeightQueue, GivesEntriesInOrderAlsoWhenSomeArriveWhileItEmpties)
{
    HeightQueue queue(0.0f, 100.0f, 64);
    const Noise noise(9);
    for (int cell = 0; cell < 1000; ++cell)
        queue.push({100.0f * noise.at(cell), cell});
    HeightQueue::Entry entry{};
    float last = 0.0f;
    int taken = 0;
    while (queue.pop(entry))
    {
        ASSERT_GE(entry.heightM, last);
        last = entry.heightM;
        if (++taken <= 500) queue.push({last + 30.0f * noise.at(10000 + taken), 1000 + taken});
    }
    EXPECT_EQ(taken, 1500);
}

TEST(Noise, StaysInItsRangeAndDependsOnTheSeed)
{
    const Noise one(1);
    const Noise two(2);
    double sum = 0.0;
    int same = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const float x = 0.37f * static_cast<float>(i % 100) - 17.0f;
        const float y = 0.41f * static_cast<float>(i) / 100.0f - 20.0f;
        const float value = one.gradient(x, y);
        ASSERT_LT(std::abs(value), 1.8f);
        sum += value;
        same += value == two.gradient(x, y) && value != 0.0f;
        const float ridge = one.ridged(x, y, 4);
        ASSERT_TRUE(ridge >= -1.0f && ridge <= 1.0f);
    }
    EXPECT_LT(std::abs(sum / 10000.0), 0.1);
    EXPECT_EQ(same, 0);
}

} // namespace islandgen
