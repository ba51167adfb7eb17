// SPDX-License-Identifier: Apache-2.0
#include "Terrain.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "DrainageNetwork.h"

namespace islandgen
{

namespace
{

constexpr int kTerrainSide = 257;

const Terrain& island()
{
    static const Terrain kIsland = std::move(generateTerrain(kDefaultSeed, kTerrainSide).value());
    return kIsland;
}

/// Counts land cells without a lower neighbour, where water would stand.
int pits(const Grid<float>& heightM)
{
    int count = 0;
    for (int row = 0; row < heightM.side; ++row)
    {
        for (int column = 0; column < heightM.side; ++column)
        {
            if (heightM.at(column, row) <= 0.0f) continue;
            bool drains = false;
            for (const NeighbourStep& step : kNeighbours)
            {
                drains |= heightM.clamped(column + step.column, row + step.row) < heightM.at(column, row);
            }
            count += !drains;
        }
    }
    return count;
}

/// Slope along the steepest of the eight directions.
float steepest(const Terrain& terrain, int column, int row)
{
    float slope = 0.0f;
    for (const NeighbourStep& step : kNeighbours)
    {
        const float drop =
            terrain.heightM.at(column, row) - terrain.heightM.clamped(column + step.column, row + step.row);
        slope = std::max(slope, drop / (step.distance * terrain.cellM));
    }
    return slope;
}

int cellAtKm(const Terrain& terrain, float km)
{
    return static_cast<int>(std::lround(km * 1000.0f / terrain.cellM));
}

} // namespace

TEST(Terrain, HasTheCommittedHash)
{
    ASSERT_TRUE(expectedHash(kDefaultSeed, kTerrainSide));
    EXPECT_EQ(terrainHash(island().heightM), *expectedHash(kDefaultSeed, kTerrainSide));
}

TEST(Terrain, AnotherSeedOrOneChangedSampleHasAnotherHash)
{
    const auto other = generateTerrain(kDefaultSeed + 1, kTerrainSide);
    ASSERT_TRUE(other);
    EXPECT_NE(terrainHash(other->heightM), terrainHash(island().heightM));
    Grid<float> changed = island().heightM;
    changed.at(128, 128) += kHeightStepM;
    EXPECT_NE(terrainHash(changed), terrainHash(island().heightM));
}

TEST(Terrain, IsTheSameWhenMadeAgain)
{
    EXPECT_EQ(generateTerrain(kDefaultSeed, kTerrainSide)->heightM.cells, island().heightM.cells);
}

TEST(Terrain, DrainsToTheSeaWithoutPits)
{
    EXPECT_EQ(pits(island().heightM), 0);
}

TEST(Terrain, ThePitCheckNoticesADugHole)
{
    Grid<float> dug = island().heightM;
    dug.at(cellAtKm(island(), 10.0f), cellAtKm(island(), 8.0f)) = 1.0f;
    EXPECT_GT(pits(dug), 0);
}

TEST(Terrain, HeightsAreFiniteWholeStepsAndLandStandsOutOfTheSea)
{
    for (const float heightM : island().heightM.cells)
    {
        ASSERT_TRUE(std::isfinite(heightM));
        ASSERT_EQ(heightM / kHeightStepM, std::floor(heightM / kHeightStepM));
        ASSERT_TRUE(heightM == 0.0f || heightM >= 0.25f);
        ASSERT_LT(heightM, 2600.0f);
    }
}

TEST(Terrain, TheBorderIsSea)
{
    const Grid<float>& heightM = island().heightM;
    for (int i = 0; i < kTerrainSide; ++i)
    {
        EXPECT_EQ(heightM.at(i, 0), 0.0f);
        EXPECT_EQ(heightM.at(i, kTerrainSide - 1), 0.0f);
        EXPECT_EQ(heightM.at(0, i), 0.0f);
        EXPECT_EQ(heightM.at(kTerrainSide - 1, i), 0.0f);
    }
}

TEST(Terrain, HasSeaPlainHillsAndMountains)
{
    const Grid<float>& heightM = island().heightM;
    int sea = 0;
    int low = 0;
    int hilly = 0;
    int high = 0;
    for (const float height : heightM.cells)
    {
        sea += height == 0.0f;
        low += height > 0.0f && height < 100.0f;
        hilly += height >= 100.0f && height < 500.0f;
        high += height >= 900.0f;
    }
    const double all = heightM.count();
    EXPECT_TRUE(sea / all > 0.15 && sea / all < 0.45) << sea / all;
    EXPECT_GT(low / all, 0.15);
    EXPECT_GT(hilly / all, 0.10);
    EXPECT_GT(high / all, 0.03);
    EXPECT_GT(*std::max_element(heightM.cells.begin(), heightM.cells.end()), 1500.0f);
}

TEST(Terrain, ThePlainIsFitForDriving)
{
    // The middle of the plain, 2 by 5 km, of the default drive.
    int steep = 0;
    int cells = 0;
    for (int row = cellAtKm(island(), 6.0f); row < cellAtKm(island(), 11.0f); ++row)
    {
        for (int column = cellAtKm(island(), 9.0f); column < cellAtKm(island(), 11.0f); ++column)
        {
            ++cells;
            steep += steepest(island(), column, row) > 0.12f;
            ASSERT_LT(island().heightM.at(column, row), 150.0f);
            ASSERT_GT(island().heightM.at(column, row), 0.0f);
        }
    }
    EXPECT_LT(steep, cells / 50) << steep << " of " << cells;
    // Mutation: the same measure fails in the mountains.
    EXPECT_GT(steepest(island(), cellAtKm(island(), 14.0f), cellAtKm(island(), 16.2f)), 0.12f);
}

TEST(Terrain, RefusesASideThatIsNoPowerOfTwoPlusOne)
{
    for (const int side : {-1, 0, 1, 2, 65, 128, 256, 258, 16385})
    {
        const auto terrain = generateTerrain(kDefaultSeed, side);
        ASSERT_FALSE(terrain) << side;
        EXPECT_NE(terrain.error().message().find(std::to_string(side)), std::string::npos);
    }
    EXPECT_TRUE(generateTerrain(kDefaultSeed, 129));
}

TEST(Terrain, OtherSeedsAndSidesAreSoundIslandsToo)
{
    for (const std::uint64_t seed : {0ull, 2ull, 3ull, 1234567ull, ~0ull})
    {
        const auto terrain = generateTerrain(seed, 129);
        ASSERT_TRUE(terrain);
        const Grid<float>& heightM = terrain->heightM;
        EXPECT_EQ(pits(heightM), 0) << seed;
        const auto sea = std::count(heightM.cells.begin(), heightM.cells.end(), 0.0f);
        EXPECT_TRUE(sea > heightM.count() * 0.15 && sea < heightM.count() * 0.45) << seed << ": " << sea;
        for (int i = 0; i < heightM.side; ++i)
        {
            ASSERT_EQ(heightM.at(i, 0) + heightM.at(0, i), 0.0f) << seed;
            ASSERT_EQ(heightM.at(i, heightM.side - 1) + heightM.at(heightM.side - 1, i), 0.0f) << seed;
        }
    }
}

TEST(Terrain, OnlyCommittedTerrainsHaveAnExpectedHash)
{
    EXPECT_TRUE(expectedHash(kDefaultSeed, kDefaultSide));
    EXPECT_FALSE(expectedHash(kDefaultSeed + 1, kDefaultSide));
    EXPECT_FALSE(expectedHash(kDefaultSeed, 1025));
}

} // namespace islandgen
