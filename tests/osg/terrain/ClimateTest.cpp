// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/Climate>

using namespace osgTerrainROAM;

TEST(Climate, PutsDesertsWhereTheyAre)
{
    EXPECT_GT(climateAt(39.0, -110.0).aridity, 0.7) << "Utah";
    EXPECT_GT(climateAt(25.0, 10.0).aridity, 0.9) << "Sahara";
    EXPECT_GT(climateAt(-32.5, -70.5).aridity, 0.6) << "Aconcagua";
    EXPECT_GT(climateAt(-45.5, -65.5).aridity, 0.5) << "Patagonia";
    EXPECT_LT(climateAt(46.5, 8.5).aridity, 0.2) << "Alps";
    EXPECT_LT(climateAt(35.4, 138.7).aridity, 0.2) << "Fuji";
    EXPECT_LT(climateAt(44.5, -71.5).aridity, 0.2) << "White Mountains";
}

TEST(Climate, LinesFallTowardsThePolesAndSnowLiesAboveTrees)
{
    EXPECT_NEAR(climateAt(46.5, 8.5).treeLineM, 2100.0, 200.0);
    for (int latitude = 30; latitude < 85; ++latitude)
    {
        const Climate here = climateAt(latitude, -30.0);
        const Climate farther = climateAt(latitude + 1.0, -30.0);
        EXPECT_GE(here.treeLineM, farther.treeLineM);
        EXPECT_GE(here.snowLineM, farther.snowLineM);
        EXPECT_GE(here.snowLineM, here.treeLineM - 100.0) << latitude;
    }
}

TEST(Climate, IsContinuous)
{
    for (int longitude = -180; longitude < 180; ++longitude)
        for (int latitude = -89; latitude < 89; ++latitude)
        {
            const double a = climateAt(latitude, longitude).aridity;
            EXPECT_LT(std::abs(a - climateAt(latitude + 0.01, longitude).aridity), 0.02);
            EXPECT_LT(std::abs(a - climateAt(latitude, longitude + 0.01).aridity), 0.02);
        }
}

TEST(Climate, TheFilesWordCountsMost)
{
    core::HeightField field;
    field.columns = field.rows = 3;
    field.spacingEastM = field.spacingNorthM = 1.0;
    field.heightsM.assign(9, 0.0f);
    const core::PlacedTile tile(field, core::Placement::planar);
    core::LandParameters land;
    land.aridity = 0.5;
    land.snowLineM = 1234.0;
    const Climate climate = climateOf(tile, land);
    EXPECT_EQ(climate.aridity, 0.5);
    EXPECT_EQ(climate.snowLineM, 1234.0);
    EXPECT_GT(climate.treeLineM, 1000.0);
}
