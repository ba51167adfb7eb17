// SPDX-License-Identifier: Apache-2.0
#include "Erosion.h"

#include <cmath>

#include <gtest/gtest.h>

namespace islandgen
{

namespace
{

constexpr int kErosionSide = 41;

Grid<std::uint8_t> southIsBase()
{
    Grid<std::uint8_t> isBase(kErosionSide, 0);
    for (int column = 0; column < kErosionSide; ++column)
        isBase.at(column, 0) = 1;
    return isBase;
}

ErosionRates rates(float upliftM, float riverErosion, float criticalSlope)
{
    return {Grid<float>(kErosionSide, upliftM),
            Grid<float>(kErosionSide, riverErosion),
            Grid<float>(kErosionSide, 0.0f),
            Grid<float>(kErosionSide, criticalSlope),
            10.0f,
            0.0f};
}

/// Straight rivers to the south: the smallest network that can be solved by hand.
DrainageNetwork straightRivers()
{
    DrainageNetwork network{Grid<std::int32_t>(kErosionSide), Grid<float>(kErosionSide), {}};
    for (int row = 0; row < kErosionSide; ++row)
    {
        for (int column = 0; column < kErosionSide; ++column)
        {
            const int cell = network.receiver.index(column, row);
            network.receiver[cell] = row == 0 ? cell : cell - kErosionSide;
            network.areaCells[cell] = static_cast<float>(kErosionSide - row);
            network.downstreamFirst.push_back(cell);
        }
    }
    return network;
}

} // namespace

TEST(ErodeRivers, EndsAtTheSteadySlopeOfStreamPower)
{
    Grid<float> heightM(kErosionSide, 0.0f);
    const DrainageNetwork network = straightRivers();
    const ErosionRates r = rates(2.0f, 0.5f, 1e6f);
    for (int step = 0; step < 2000; ++step)
        erodeRivers(heightM, network, r);
    for (int row = 1; row < kErosionSide; ++row)
    {
        // uplift = K·dt·√A·drop: every reach drops by uplift / (K·dt·√A)
        const float drop = heightM.at(7, row) - heightM.at(7, row - 1);
        EXPECT_NEAR(drop, 2.0f / (0.5f * std::sqrt(static_cast<float>(kErosionSide - row))), 2e-3f);
    }
}

TEST(ErodeRivers, SedimentRaisesTheSteadySlopeByOnePlusG)
{
    Grid<float> heightM(kErosionSide, 0.0f);
    const DrainageNetwork network = straightRivers();
    ErosionRates r = rates(2.0f, 0.5f, 1e6f);
    r.deposition = 0.4f;
    for (int step = 0; step < 4000; ++step)
        erodeRivers(heightM, network, r);
    // Near the mouth, where nearly all of the drained area lies upstream of the cell (Yuan et al., equation
    // 12).
    const float drop = heightM.at(7, 2) - heightM.at(7, 1);
    const float without = 2.0f / (0.5f * std::sqrt(static_cast<float>(kErosionSide - 2)));
    EXPECT_NEAR(drop / without, 1.4f, 0.03f);
}

TEST(ErodeRivers, NothingStandsSteeperThanTheCriticalSlope)
{
    Grid<float> heightM(kErosionSide, 0.0f);
    const Grid<std::uint8_t> isBase = southIsBase();
    const ErosionRates r = rates(50.0f, 1e-4f, 0.5f);
    for (int step = 0; step < 50; ++step)
    {
        erodeRivers(heightM, routeDrainage(heightM, isBase, Noise(step), 0.0f), r);
    }
    for (int row = 1; row < kErosionSide; ++row)
    {
        EXPECT_LE(heightM.at(20, row) - heightM.at(20, row - 1), 0.5f * 10.0f + 0.01f);
    }
    EXPECT_GT(heightM.at(20, kErosionSide - 1), 100.0f); // the critical slope is reached
}

TEST(Creep, KeepsAPlaneAndMeltsAPeakWithoutUndershoot)
{
    Grid<std::uint8_t> isBase(kErosionSide, 0);
    for (int row = 0; row < kErosionSide; ++row)
        isBase.at(0, row) = isBase.at(kErosionSide - 1, row) = 1;
    Grid<float> plane(kErosionSide);
    for (int row = 0; row < kErosionSide; ++row)
    {
        for (int column = 0; column < kErosionSide; ++column)
            plane.at(column, row) = static_cast<float>(column);
    }
    creep(plane, Grid<float>(kErosionSide, 25.0f), isBase);
    for (int column = 0; column < kErosionSide; ++column)
        EXPECT_NEAR(plane.at(column, 20), column, 1e-3);

    Grid<float> peak(kErosionSide, 0.0f);
    peak.at(20, 20) = 100.0f;
    creep(peak, Grid<float>(kErosionSide, 25.0f), isBase);
    for (const float heightM : peak.cells)
        EXPECT_GE(heightM, 0.0f);
    EXPECT_LT(peak.at(20, 20), 10.0f);
    EXPECT_NEAR(peak.at(21, 20), peak.at(20, 21), 0.05f); // nearly the same in both directions
}

} // namespace islandgen
