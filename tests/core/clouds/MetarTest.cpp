// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/Metar.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace simulation;

TEST(Metar, TellsLayersWindAndAir)
{
    const auto report = readMetar(
        "METAR LOWI 241150Z 25012G20KT 4000 -RA FEW040 SCT080 BKN250 M02/M05 Q1018 NOSIG OVC001", "here");
    ASSERT_TRUE(report) << report.error().message();
    ASSERT_EQ(report->clouds.size(), 3U) << "trends do not count";
    EXPECT_EQ(report->clouds[0].kind, CloudKind::cumulus);
    EXPECT_EQ(report->clouds[0].oktas, 2);
    EXPECT_NEAR(report->clouds[0].baseM, 1219.2, 0.1);
    EXPECT_EQ(report->clouds[1].oktas, 4);
    EXPECT_EQ(report->clouds[2].kind, CloudKind::cirrus);
    const Weather& weather = report->weather;
    EXPECT_EQ(weather.fogVisualRangeM, 4000.0);
    EXPECT_NEAR(*weather.temperatureK, 271.15, 1e-9);
    EXPECT_EQ(weather.seaPressurePa, 101800.0);
    ASSERT_TRUE(weather.precipitation);
    EXPECT_EQ(weather.precipitation->type, "rain");
    EXPECT_LT(*weather.precipitation->intensity, 2.0);
    ASSERT_TRUE(weather.wind);
    EXPECT_NEAR(weather.wind->speedMps, 6.173, 0.01);
    EXPECT_GT(std::cos(weather.wind->directionRad), 0.9) << "from west-south-west it blows to the east";
}

TEST(Metar, ReadsTheFormsOfTheAmericas)
{
    const auto report = readMetar("KSFO 010056Z 00000KT 1/2SM VV002 12/11 A2992 RMK AO2", "here");
    ASSERT_TRUE(report);
    EXPECT_NEAR(*report->weather.fogVisualRangeM, 804.7, 0.1);
    EXPECT_NEAR(*report->weather.seaPressurePa, 101321.0, 5.0);
    ASSERT_EQ(report->clouds.size(), 1U);
    EXPECT_EQ(report->clouds[0].oktas, 8);
}

TEST(Metar, GoodVisibilityAndNoCloudSayNothingMore)
{
    const auto report = readMetar("EDDF 010050Z VRB02KT CAVOK 20/10 Q1020=", "here");
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->clouds.empty());
    EXPECT_FALSE(report->weather.fogVisualRangeM);
}

TEST(Metar, TellsWhatFallsAndHowMuch)
{
    const auto fall = [](const char* text) { return readMetar(text, "here")->weather.precipitation; };
    EXPECT_EQ(fall("RA"), (Precipitation{"rain", 4.0}));
    EXPECT_EQ(fall("+TSRAGR"), (Precipitation{"rain", 45.0})) << "hail counts before rain";
    EXPECT_EQ(fall("RASN"), (Precipitation{"snow", 1.5}));
    EXPECT_EQ(fall("-FZDZ")->type, "rain");
    EXPECT_LT(*fall("-FZDZ")->intensity, *fall("-RA")->intensity);
    EXPECT_EQ(fall("SG"), (Precipitation{"snow", 0.5}));
    EXPECT_EQ(fall("FEW020 BR"), std::nullopt);
}

TEST(Metar, LayersNeverShareHeights)
{
    const auto report = readMetar("SCT020CB BKN025 OVC030 OVC031", "here");
    ASSERT_TRUE(report);
    for (std::size_t i = 1; i < report->clouds.size(); ++i)
        EXPECT_GE(report->clouds[i].baseM, report->clouds[i - 1].topM);
}

TEST(Metar, TextWithoutWeatherIsRefused)
{
    for (const char* text : {"", "hello world", "METAR", "SCT", "99999", "/////KT"})
        EXPECT_FALSE(readMetar(text, "here")) << text;
}
