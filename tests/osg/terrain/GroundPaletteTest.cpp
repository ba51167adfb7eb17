// SPDX-License-Identifier: Apache-2.0
#include "material/GroundPalette.h"

#include <gtest/gtest.h>

#include <osg/Program>

#include <osgTerrainROAM/TerrainMaterial>

#include "SyntheticField.h"
#include "material/CoverTexture.h"

namespace
{

using namespace osgTerrainROAM;

constexpr double kJune = 5.5 / 12.0, kJanuary = 0.5 / 12.0, kJuly = 6.5 / 12.0, kOctober = 9.5 / 12.0;

Climate at(double latitudeDeg)
{
    return climateAt(latitudeDeg, 8.0);
}

} // namespace

TEST(GroundPalette, JuneIsTheEarlySummerThatNoSeasonMeans)
{
    const GroundPalette none = groundPalette(at(47.0), std::nullopt), june = groundPalette(at(47.0), kJune);
    EXPECT_NEAR((none.meadow - june.meadow).length(), 0.0, 1e-6);
    EXPECT_NEAR((none.forest - june.forest).length(), 0.0, 1e-6);
    EXPECT_NEAR((none.crops[0] - june.crops[0]).length(), 0.0, 1e-6);
    EXPECT_EQ(june.snowShiftM, 0.0f);
}

TEST(GroundPalette, SouthOfTheEquatorItIsTheOtherHalfOfTheYear)
{
    EXPECT_LT(groundPalette(at(47.0), kJanuary).snowShiftM, -1500.0f);
    EXPECT_GT(groundPalette(at(-47.0), kJanuary).snowShiftM, 100.0f);
    EXPECT_EQ(groundPalette(at(-47.0), kJanuary).meadow, groundPalette(at(47.0), kJuly).meadow);
    EXPECT_EQ(groundPalette(at(3.0), kJanuary).meadow, groundPalette(at(3.0), kJuly).meadow);
    EXPECT_EQ(groundPalette(at(3.0), kJanuary).snowShiftM, 0.0f);
}

TEST(GroundPalette, LeavesTurnAndCropsRipen)
{
    const GroundPalette june = groundPalette(at(50.0), kJune), july = groundPalette(at(50.0), kJuly);
    const GroundPalette october = groundPalette(at(50.0), kOctober);
    EXPECT_GT(october.forest.x(), october.forest.y()) << "redder than green";
    EXPECT_LT(june.forest.x(), june.forest.y());
    EXPECT_GT(july.crops[0].x(), 1.8f * june.crops[0].x());
}

TEST(GroundPalette, TheYearClosesWithoutAJump)
{
    for (double share = 0.0; share < 1.0; share += 1.0 / 400.0)
    {
        const GroundPalette a = groundPalette(at(50.0), share),
                            b = groundPalette(at(50.0), share + 1.0 / 400.0);
        EXPECT_LT(std::abs(a.snowShiftM - b.snowShiftM), 40.0f) << share;
        EXPECT_LT((a.crops[0] - b.crops[0]).length(), 0.02f) << share;
    }
}

TEST(TerrainMaterial, ASeasonChangesUniformsAlone)
{
    const auto tile = testsupport::planarTile(testsupport::hills(33, 33));
    const osg::ref_ptr<TerrainMaterial> material = new TerrainMaterial(tile->tile, at(47.0));
    const auto program = [&] { return material->stateSet()->getAttribute(osg::StateAttribute::PROGRAM); };
    const auto meadow = [&]
    {
        osg::Vec3f value;
        material->stateSet()->getUniform("terrainMeadow")->get(value);
        return value;
    };
    const auto* plain = program();
    const osg::Vec3f summer = meadow();
    ASSERT_TRUE(material->setSeason(kJanuary));
    const auto* seasonal = program();
    const osg::Vec3f winter = meadow();
    EXPECT_NE(seasonal, plain);
    EXPECT_NE(winter, summer);
    ASSERT_TRUE(material->setSeason(kOctober));
    EXPECT_EQ(program(), seasonal);
    EXPECT_NE(meadow(), winter);
    ASSERT_TRUE(material->setSeason(std::nullopt));
    EXPECT_EQ(meadow(), summer);
}

TEST(CoverImage, ACoarserTexelIsWhatMostOfItIs)
{
    using enum core::GroundKind;
    core::CoverMap map;
    map.width = 4;
    map.height = 2;
    map.kinds = {rock, rock, sand,  water, //
                 rock, sand, water, water};
    const auto image = coverImage(map);
    ASSERT_EQ(image->getNumMipmapLevels(), 3u);
    const unsigned char* level1 = image->getMipmapData(1);
    EXPECT_EQ(level1[0], static_cast<unsigned char>(rock));
    EXPECT_EQ(level1[1], static_cast<unsigned char>(water));
    EXPECT_EQ(*image->getMipmapData(2), static_cast<unsigned char>(rock))
        << "a mean would be meadow or shrub";
}
