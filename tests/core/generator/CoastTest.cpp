// SPDX-License-Identifier: Apache-2.0
#include "Coast.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "LandEvolution.h"
#include "SurfaceDetail.h"
#include "ValleyFloors.h"

namespace islandgen
{

namespace
{

constexpr int kCoastSide = 33;

/// Land 5 m high and more in the west, 2 m deep water in the east.
struct Shore
{
    Grid<float> heightM{kCoastSide, -2.0f};
    Grid<std::uint8_t> isSea{kCoastSide, 1};

    Shore()
    {
        for (int row = 0; row < kCoastSide; ++row)
        {
            for (int column = 0; column < 10; ++column)
            {
                heightM.at(column, row) = 5.0f + static_cast<float>(10 - column);
                isSea.at(column, row) = 0;
            }
        }
    }

    DrainageNetwork network() const
    {
        Grid<float> flooded = heightM;
        for (float& height : flooded.cells)
            height = std::max(height, 0.0f);
        return routeDrainage(flooded, isSea, Noise(1), 0.0f);
    }
};

} // namespace

TEST(Deltas, AsMuchSeaBecomesLandAsTheSedimentFillsAndTheNearestFirst)
{
    const Shore shore;
    Grid<float> sedimentM(kCoastSide);
    sedimentM.at(4, 16) = 30.0f; // 3 m a cell, up to 1 m above the sea: ten cells
    Grid<std::uint8_t> isSea = shore.isSea;
    buildDeltas(isSea, shore.heightM, shore.network(), sedimentM, Noise(1));
    int filled = 0;
    for (int cell = 0; cell < isSea.count(); ++cell)
    {
        if (isSea[cell] == shore.isSea[cell]) continue;
        ++filled;
        const float dx = static_cast<float>(cell % kCoastSide) - 10.0f;
        const float dy = std::floor(static_cast<float>(cell) / kCoastSide) - 16.0f;
        EXPECT_LT(dx * dx + dy * dy, 36.0f);
    }
    EXPECT_EQ(filled, 10);
}

TEST(Deltas, WithoutSedimentTheShoreStays)
{
    const Shore shore;
    Grid<std::uint8_t> isSea = shore.isSea;
    buildDeltas(isSea, shore.heightM, shore.network(), Grid<float>(kCoastSide), Noise(1));
    EXPECT_EQ(isSea.cells, shore.isSea.cells);
}

TEST(Coast, TheSeaIsOnePieceAtZeroAndLandStandsAboveIt)
{
    const Noise noise(4);
    const Land land = evolveLand(makeIslandPlan(129, noise), 129, noise);
    Grid<std::uint8_t> open(129, 0);
    std::vector<int> stack{0};
    open[0] = 1;
    while (!stack.empty())
    {
        const int cell = stack.back();
        stack.pop_back();
        for (const int step : {-1, 1, -129, 129})
        {
            const int next = cell + step;
            if (next < 0 || next >= open.count() || open[next] || !land.isSea[next]) continue;
            open[next] = 1;
            stack.push_back(next);
        }
    }
    for (int cell = 0; cell < open.count(); ++cell)
    {
        ASSERT_EQ(open[cell], land.isSea[cell]);
        if (land.isSea[cell])
            ASSERT_EQ(land.heightM[cell], 0.0f);
        else
            ASSERT_GT(land.heightM[cell], 0.0f);
    }
}

TEST(ValleyFloors, AreCutAroundRiversOnlyAndNeverRaised)
{
    // A V-shaped valley that drains to the south along column 16.
    Grid<float> heightM(kCoastSide);
    Grid<std::uint8_t> isSea(kCoastSide, 0);
    for (int row = 0; row < kCoastSide; ++row)
    {
        for (int column = 0; column < kCoastSide; ++column)
        {
            heightM.at(column, row) =
                10.0f * static_cast<float>(row) + 40.0f * std::abs(static_cast<float>(column - 16));
        }
    }
    for (int column = 0; column < kCoastSide; ++column)
        isSea.at(column, 0) = 1;
    const Grid<float> before = heightM;
    DrainageNetwork network = routeDrainage(heightM, isSea, Noise(1), 0.0f);
    planeValleyFloors(heightM, network, isSea, 100.0f);
    EXPECT_EQ(heightM.cells, before.cells) << "10 km² have a floor of one cell of 100 m";
    for (float& area : network.areaCells.cells)
        area *= 36.0f;
    planeValleyFloors(heightM, network, isSea, 100.0f);
    EXPECT_LT(heightM.at(17, 2), before.at(17, 2) - 30.0f);
    EXPECT_EQ(heightM.at(28, 20), before.at(28, 20));
    for (int cell = 0; cell < heightM.count(); ++cell)
        ASSERT_LE(heightM[cell], before[cell]);
}

TEST(SurfaceDetail, LeavesGentleGroundAloneAndRoughensSteepGround)
{
    for (const float slope : {0.15f, 0.9f})
    {
        Grid<float> heightM(kCoastSide);
        for (int row = 0; row < kCoastSide; ++row)
        {
            for (int column = 0; column < kCoastSide; ++column)
            {
                heightM.at(column, row) = 500.0f + slope * 12.0f * static_cast<float>(row);
            }
        }
        const Grid<float> before = heightM;
        roughenSlopes(heightM, 12.0f, Noise(1));
        EXPECT_EQ(heightM.cells == before.cells, slope < 0.2f) << slope;
        for (int cell = 0; cell < heightM.count(); ++cell)
            ASSERT_NEAR(heightM[cell], before[cell], 9.0f);
    }
}

} // namespace islandgen
