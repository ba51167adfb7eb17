// SPDX-License-Identifier: Apache-2.0
#include "FeatureTags.h"

#include <map>

#include <gtest/gtest.h>

namespace
{

using namespace osgTerrainROAM::core;

using Tags = std::map<std::string, std::string>;

std::optional<FeatureStyle> styleOf(const Tags& tags, const std::string& layer = "lines")
{
    return featureStyle(
        [&](const char* name)
        {
            const auto found = tags.find(name);
            return found == tags.end() ? std::string() : found->second;
        },
        layer);
}

} // namespace

TEST(FeatureTags, OpenStreetMapsTagsHaveTheirKinds)
{
    EXPECT_EQ(styleOf({{"highway", "secondary"}})->kind, FeatureKind::road);
    EXPECT_EQ(styleOf({{"waterway", "stream"}})->kind, FeatureKind::river);
    EXPECT_EQ(styleOf({{"natural", "water"}})->kind, FeatureKind::river);
    EXPECT_EQ(styleOf({{"landuse", "farmland"}, {"crop", "maize"}})->crop, Crop::rowCrop);
    EXPECT_EQ(styleOf({{"aeroway", "runway"}, {"ref", "09/27"}})->designator, "09/27");
    EXPECT_EQ(styleOf({{"highway", "track"}})->pavement, Pavement::gravel);
    EXPECT_FALSE(styleOf({{"highway", "track"}})->marked);
}

TEST(FeatureTags, AircraftTaxiAlongSomeWays)
{
    EXPECT_EQ(styleOf({{"aeroway", "taxiway"}})->taxiing, Taxiing::taxiway);
    EXPECT_EQ(styleOf({{"aeroway", "taxiway"}, {"width", "7.5"}})->taxiing, Taxiing::taxiway);
    EXPECT_EQ(styleOf({{"aeroway", "taxilane"}})->taxiing, Taxiing::taxilane);
    EXPECT_EQ(styleOf({{"aeroway", "parking_position"}})->taxiing, Taxiing::taxilane);
    EXPECT_EQ(styleOf({{"highway", "service"}})->taxiing, Taxiing::none);
}

TEST(FeatureTags, ACropThatTheMapNamesIsKnown)
{
    EXPECT_TRUE(styleOf({{"landuse", "farmland"}, {"crop", "wheat"}})->isCropKnown);
    EXPECT_TRUE(styleOf({{"kind", "maize"}})->isCropKnown);
    EXPECT_FALSE(styleOf({{"landuse", "farmland"}})->isCropKnown);
    EXPECT_FALSE(styleOf({{"landuse", "farmland"}, {"crop", "lotus"}})->isCropKnown);
}

TEST(FeatureTags, AnExplicitKindAndWidthWin)
{
    const auto style = styleOf({{"kind", "River"}, {"highway", "primary"}, {"width", "12.5 m"}});
    ASSERT_TRUE(style);
    EXPECT_EQ(style->kind, FeatureKind::river);
    EXPECT_EQ(style->widthM, 12.5);
}

TEST(FeatureTags, LanesWidenARoadThatHasNoWidth)
{
    EXPECT_NEAR(styleOf({{"highway", "primary"}, {"lanes", "4"}})->widthM, 16.0, 1e-9);
    EXPECT_EQ(styleOf({{"highway", "primary"}, {"lanes", "4"}, {"width", "13"}})->widthM, 13.0);
    EXPECT_EQ(styleOf({{"highway", "primary"}, {"lanes", "many"}})->lanes, 2);
}

TEST(FeatureTags, TheLayersNameIsTheLastResort)
{
    EXPECT_EQ(styleOf({}, "Main_Roads")->kind, FeatureKind::road);
    EXPECT_EQ(styleOf({}, "farmland")->kind, FeatureKind::field);
    EXPECT_FALSE(styleOf({}, "lines"));
    EXPECT_FALSE(styleOf({{"highway", "steps"}}, "roads")) << "a tag that says what it is, is not overruled";
    EXPECT_FALSE(styleOf({{"kind", "castle"}}, "roads"));
}

TEST(FeatureTags, LengthsHaveUnits)
{
    EXPECT_EQ(metresIn("7"), 7.0);
    EXPECT_EQ(metresIn("7.5 m"), 7.5);
    EXPECT_NEAR(*metresIn("24 ft"), 7.3152, 1e-9);
    EXPECT_NEAR(*metresIn("24'"), 7.3152, 1e-9);
    for (const char* text : {"", "wide", "7 parsec", "nan", "-3", "0", "1e9", "inf"})
        EXPECT_FALSE(metresIn(text)) << text;
}

TEST(FeatureTags, OtherTagsAreFoundInOneText)
{
    const std::string text = R"("lanes"=>"2","surface"=>"gravel")";
    EXPECT_EQ(hstoreValue(text, "surface"), "gravel");
    EXPECT_EQ(hstoreValue(text, "lane"), "");
    EXPECT_EQ(hstoreValue(R"("surface"=>"gra)", "surface"), "");
}
