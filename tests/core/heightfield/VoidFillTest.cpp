// SPDX-License-Identifier: Apache-2.0
#include "VoidFill.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace
{

using namespace osgTerrainROAM::core;

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

struct Grid
{
    int columns, rows;
    std::vector<float> heightsM;

    float& at(int c, int r)
    {
        return heightsM[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + c];
    }

    void punch(int west, int south, int width, int height)
    {
        for (int r = south; r < south + height; ++r)
            for (int c = west; c < west + width; ++c)
                at(c, r) = kVoid;
    }
};

template<class F>
Grid gridOf(int columns, int rows, F height)
{
    Grid grid{columns, rows, std::vector<float>(static_cast<std::size_t>(columns * rows))};
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            grid.at(c, r) = static_cast<float>(height(c, r));
    return grid;
}

double worstDifference(const Grid& a, const Grid& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.heightsM.size(); ++i)
    {
        const double difference = std::abs(a.heightsM[i] - b.heightsM[i]);
        worst = std::max(worst, std::isnan(difference) ? 1e9 : difference);
    }
    return worst;
}

TEST(VoidFill, ASlopeIsContinuedThroughItsVoids)
{
    const Grid truth = gridOf(60, 50, [](int c, int r) { return 100.0 + 7.0 * c - 4.0 * r; });
    Grid grid = truth;
    grid.punch(20, 15, 17, 12);
    grid.punch(3, 40, 1, 1);
    const VoidReport report = fillVoids(grid.heightsM, grid.columns, grid.rows);
    EXPECT_EQ(report.count, 17u * 12u + 1u);
    EXPECT_NEAR(report.share, (17.0 * 12.0 + 1.0) / 3000.0, 1e-12);
    EXPECT_FALSE(report.method.empty());
    EXPECT_LT(worstDifference(grid, truth), 0.5);
}

TEST(VoidFill, ARoundHillIsRebuiltBetterThanByAFlatLid)
{
    const auto hill = [](int c, int r)
    { return 800.0 * std::exp(-((c - 30) * (c - 30) + (r - 25) * (r - 25)) / 300.0); };
    const Grid truth = gridOf(60, 50, hill);
    Grid grid = truth;
    grid.punch(33, 20, 10, 10); // on its flank
    fillVoids(grid.heightsM, grid.columns, grid.rows);
    EXPECT_LT(worstDifference(grid, truth), 25.0);
}

TEST(VoidFill, KnownHeightsStayAndNothingLeavesTheRimsRange)
{
    std::mt19937 random(5);
    Grid grid = gridOf(120, 90,
                       [&](int c, int r)
                       { return 1000.0 + 300.0 * std::sin(0.2 * c) * std::cos(0.15 * r) + random() % 80; });
    const Grid before = grid;
    grid.punch(0, 0, 40, 30);   // a corner
    grid.punch(70, 60, 50, 30); // another
    grid.punch(50, 20, 25, 25); // inland
    grid.punch(90, 5, 1, 40);   // a line
    const Grid punched = grid;
    fillVoids(grid.heightsM, grid.columns, grid.rows);
    float low = 1e9f, high = -1e9f;
    for (const float h : before.heightsM)
    {
        low = std::min(low, h);
        high = std::max(high, h);
    }
    for (std::size_t i = 0; i < grid.heightsM.size(); ++i)
    {
        if (!std::isnan(punched.heightsM[i]))
            EXPECT_EQ(grid.heightsM[i], punched.heightsM[i]);
        else
        {
            EXPECT_GE(grid.heightsM[i], low);
            EXPECT_LE(grid.heightsM[i], high);
        }
    }
}

TEST(VoidFill, AVoidLakeBetweenMountainsStaysAboveItsShore)
{
    // Slopes that fall towards the void would go below the shore if extrapolated without limit.
    Grid grid = gridOf(
        80, 80, [](int c, int r) { return 200.0 + 40.0 * std::max(0.0, std::hypot(c - 40, r - 40) - 20.0); });
    for (int r = 0; r < 80; ++r)
        for (int c = 0; c < 80; ++c)
            if (std::hypot(c - 40, r - 40) < 22.0) grid.at(c, r) = kVoid;
    float shore = 1e9f;
    for (const float h : grid.heightsM)
        if (!std::isnan(h)) shore = std::min(shore, h);
    fillVoids(grid.heightsM, grid.columns, grid.rows);
    for (const float h : grid.heightsM)
        EXPECT_GE(h, shore);
}

TEST(VoidFill, HalfAGridMissingGivesNeitherSpikesNorStreaks)
{
    std::mt19937 random(9);
    Grid grid = gridOf(128, 128, [&](int, int) { return 500.0 + random() % 200; });
    grid.punch(0, 64, 128, 64);
    fillVoids(grid.heightsM, grid.columns, grid.rows);
    // No streaks (rows of cells that differ from their neighbours across): far inside, the surface is smooth.
    for (int r = 80; r < 127; ++r)
        for (int c = 0; c < 127; ++c)
        {
            EXPECT_LT(std::abs(grid.at(c + 1, r) - grid.at(c, r)), 15.0f);
            EXPECT_LT(std::abs(grid.at(c, r + 1) - grid.at(c, r)), 15.0f);
        }
}

TEST(VoidFill, EveryVoidIsFilledWhateverItsShapeAndTwiceTheSame)
{
    std::mt19937 random(21);
    for (int trial = 0; trial < 40; ++trial)
    {
        const int columns = 2 + static_cast<int>(random() % 40), rows = 2 + static_cast<int>(random() % 40);
        Grid grid =
            gridOf(columns, rows,
                   [&](int, int) { return random() % 3 ? static_cast<float>(random() % 1000) : kVoid; });
        grid.at(static_cast<int>(random()) % 2 ? 0 : columns - 1, 0) = 5.0f;
        Grid again = grid;
        fillVoids(grid.heightsM, columns, rows);
        fillVoids(again.heightsM, columns, rows);
        EXPECT_EQ(worstDifference(grid, again), 0.0) << columns << " x " << rows;
    }
}

TEST(VoidFill, NothingToFillIsNoReport)
{
    Grid grid = gridOf(4, 4, [](int c, int r) { return c + r; });
    const VoidReport report = fillVoids(grid.heightsM, 4, 4);
    EXPECT_EQ(report.count, 0u);
    EXPECT_TRUE(report.method.empty());
}

} // namespace
