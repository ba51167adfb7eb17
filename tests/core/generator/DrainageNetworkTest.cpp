// SPDX-License-Identifier: Apache-2.0
#include "DrainageNetwork.h"

#include <gtest/gtest.h>

namespace islandgen
{

namespace
{

Grid<std::uint8_t> borderIsBase(int side)
{
    Grid<std::uint8_t> isBase(side, 0);
    for (int row = 0; row < side; ++row)
    {
        for (int column = 0; column < side; ++column)
            isBase.at(column, row) = isBase.onEdge(column, row);
    }
    return isBase;
}

Grid<float> randomLand(int side)
{
    Grid<float> heightM(side);
    const Noise noise(11);
    for (int cell = 0; cell < heightM.count(); ++cell)
        heightM[cell] = 100.0f * noise.at(cell);
    return heightM;
}

} // namespace

TEST(FillDepressions, RaisesAPitToItsOutletAndLeavesTheRest)
{
    Grid<float> heightM(5, 9.0f);
    const Grid<std::uint8_t> isBase = borderIsBase(5);
    for (int cell = 0; cell < heightM.count(); ++cell)
        heightM[cell] = isBase[cell] ? 0.0f : 9.0f;
    heightM.at(2, 2) = 1.0f;
    heightM.at(3, 2) = 4.0f; // the lowest way out of the pit
    fillDepressions(heightM, isBase, 0.5f);
    EXPECT_FLOAT_EQ(heightM.at(2, 2), 4.5f);
    EXPECT_FLOAT_EQ(heightM.at(3, 2), 4.0f);
    EXPECT_FLOAT_EQ(heightM.at(1, 1), 9.0f);
    EXPECT_FLOAT_EQ(heightM.at(0, 0), 0.0f);
}

TEST(DrainageNetwork, EveryCellOfRandomLandDrains)
{
    Grid<float> heightM = randomLand(65);
    const Grid<std::uint8_t> isBase = borderIsBase(65);
    const DrainageNetwork network = routeDrainage(heightM, isBase, Noise(1), 0.6f);
    EXPECT_TRUE(drainsEverywhere(network, isBase));
    for (int cell = 0; cell < heightM.count(); ++cell)
    {
        if (isBase[cell]) continue;
        ASSERT_LT(heightM[network.receiver[cell]], heightM[cell]);
    }
}

TEST(DrainageNetwork, TheCheckNoticesACellThatKeepsItsWater)
{
    Grid<float> heightM = randomLand(33);
    const Grid<std::uint8_t> isBase = borderIsBase(33);
    DrainageNetwork network = routeDrainage(heightM, isBase, Noise(1), 0.0f);
    ASSERT_TRUE(drainsEverywhere(network, isBase));
    const int cell = heightM.index(16, 16);
    network.receiver[cell] = cell;
    EXPECT_FALSE(drainsEverywhere(network, isBase));
}

TEST(DrainageNetwork, TheCheckNoticesACycle)
{
    Grid<float> heightM = randomLand(33);
    const Grid<std::uint8_t> isBase = borderIsBase(33);
    DrainageNetwork network = routeDrainage(heightM, isBase, Noise(1), 0.0f);
    const int cell = heightM.index(16, 16);
    network.receiver[network.receiver[cell]] = cell;
    EXPECT_FALSE(drainsEverywhere(network, isBase));
}

TEST(DrainageNetwork, BaseCellsReceiveEveryCellOnce)
{
    Grid<float> heightM = randomLand(65);
    const Grid<std::uint8_t> isBase = borderIsBase(65);
    const DrainageNetwork network = routeDrainage(heightM, isBase, Noise(2), 0.6f);
    double total = 0.0;
    for (int cell = 0; cell < heightM.count(); ++cell)
        total += isBase[cell] ? network.areaCells[cell] : 0.0f;
    EXPECT_EQ(total, heightM.count());
}

} // namespace islandgen
