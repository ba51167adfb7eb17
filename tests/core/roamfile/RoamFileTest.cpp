// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/RoamFile.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr const char* kWhole = R"(# a place
dem = heights/dem.tif
imagery = /far/image.tif   # absolute
features = roads.gpkg
features = /far/fields.geojson
buildings = houses.gpkg
buildings = towers.gpkg
objects = trees.gpkg
land_cover = cover.tif
land_cover_classes = corine
season = october
origin = 46.5 8.25 1200
placement = curved
spacing = 30
vertical_datum = ellipsoid
finest_spacing = 0.5
error_tolerance = 1.5
max_triangles = 60000
view_margin = 7.5
adapt_time_us = 1500
aridity = 0.4
tree_line = 1900
snow_line = 2500
sea_level = -1.5
water = none
sun = 230 40
visibility = 35000
moonlight = 0.5
ground = snow 5; cleared
roads = town.xodr
roads_origin = 46.5 8.25 30
roads_heights = ground
)";

std::string messageOf(const std::string& text)
{
    const auto file = parseRoamFile(text, "folder/place.roam");
    return file ? "" : file.error().message();
}

} // namespace

TEST(RoamFile, HasEveryKey)
{
    const auto file = parseRoamFile(kWhole, "folder/place.roam");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_EQ(file->dems, std::vector<std::filesystem::path>{"folder/heights/dem.tif"});
    ASSERT_EQ(file->imagery.size(), 1u);
    EXPECT_EQ(file->imagery[0], std::filesystem::path("/far/image.tif"));
    ASSERT_TRUE(file->origin);
    EXPECT_EQ(file->origin->latitudeDeg, 46.5);
    EXPECT_EQ(file->origin->longitudeDeg, 8.25);
    EXPECT_EQ(file->origin->heightM, 1200.0);
    EXPECT_EQ(file->placement, Placement::curved);
    EXPECT_EQ(file->import.spacingM, 30.0);
    EXPECT_EQ(file->import.verticalDatum, VerticalDatum::ellipsoid);
    EXPECT_EQ(file->finestSpacingM, 0.5);
    EXPECT_EQ(file->errorTolerancePx, 1.5);
    EXPECT_EQ(file->maxTriangles, 60000u);
    EXPECT_EQ(file->viewMarginDeg, 7.5);
    EXPECT_EQ(file->adaptTimeUs, 1500.0);
    EXPECT_EQ(file->land.aridity, 0.4);
    EXPECT_EQ(file->land.water, WaterRule::none);
    EXPECT_EQ(file->land.treeLineM, 1900.0);
    EXPECT_EQ(file->land.snowLineM, 2500.0);
    EXPECT_EQ(file->land.seaLevelM, -1.5);
    EXPECT_EQ(file->sunAzimuthDeg, 230.0);
    EXPECT_EQ(file->sunElevationDeg, 40.0);
    EXPECT_EQ(file->visibilityM, 35000.0);
    EXPECT_EQ(file->moonlight, 0.5);
    EXPECT_EQ(file->ground, "snow 5; cleared");
    EXPECT_EQ(file->roads.filename(), "town.xodr");
    ASSERT_TRUE(file->roadsOrigin);
    EXPECT_EQ(file->roadsOrigin->latitudeDeg, 46.5);
    EXPECT_EQ(file->roadsOrigin->longitudeDeg, 8.25);
    EXPECT_EQ(file->roadsOrigin->headingDeg, 30.0);
    EXPECT_TRUE(file->roadsOnGround);
    ASSERT_EQ(file->features.size(), 2u);
    EXPECT_EQ(file->features[0], std::filesystem::path("folder/roads.gpkg"));
    EXPECT_EQ(file->features[1], std::filesystem::path("/far/fields.geojson"));
    EXPECT_EQ(file->buildings,
              (std::vector<std::filesystem::path>{"folder/houses.gpkg", "folder/towers.gpkg"}));
    EXPECT_EQ(file->objects, std::vector<std::filesystem::path>{"folder/trees.gpkg"});
    EXPECT_EQ(file->landCover, std::filesystem::path("folder/cover.tif"));
    EXPECT_EQ(file->landCoverClasses, std::filesystem::path("corine"));
    EXPECT_NEAR(file->seasonOfYear.value_or(0.0), 9.5 / 12.0, 1e-12);
}

TEST(RoamFile, ASeasonIsAMonthOrAShareOfTheYear)
{
    EXPECT_EQ(parseRoamFile("dem = a\nseason = 0.25\n", "p.roam")->seasonOfYear, 0.25);
    EXPECT_EQ(parseRoamFile("dem = a\nland_cover_classes = my.txt\n", "x/p.roam")->landCoverClasses,
              std::filesystem::path("x/my.txt"));
    EXPECT_THAT(messageOf("dem = a\nseason = summer\n"),
                testing::HasSubstr("place.roam:2: season = 'summer' is unknown"));
    EXPECT_THAT(messageOf("dem = a\nseason = 1.5\n"),
                testing::HasSubstr("place.roam:2: season = 1.5 is out of range"));
    const std::string four = "dem = a\nimagery = a\nimagery = b\nimagery = c\nimagery = d\n";
    EXPECT_EQ(messageOf(four), "");
    EXPECT_THAT(messageOf(four + "imagery = e\n"),
                testing::HasSubstr("place.roam:6: is one imagery more than the 4"));
    EXPECT_THAT(messageOf("dem = a\nroads_origin = 95 8\n"),
                testing::HasSubstr("place.roam:2: roads_origin = 95 8 is no place for roads"));
    EXPECT_THAT(messageOf("dem = a\nroads_heights = sea\n"), testing::HasSubstr("use one of: file, ground"));
    EXPECT_THAT(messageOf("dem = a\nmoonlight = 2\n"),
                testing::HasSubstr("place.roam:2: moonlight = 2 is out of range"));
    EXPECT_THAT(messageOf("dem = a\nland_cover = a\nland_cover = b\n"),
                testing::HasSubstr("place.roam:3: 'land_cover' stands"));
}

TEST(RoamFile, NeedsOnlyADem)
{
    const auto file = parseRoamFile("dem=/vsigzip/a.hgt.gz\r\n", "place.roam");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_EQ(file->dems.front(), std::filesystem::path("/vsigzip/a.hgt.gz"));
    EXPECT_FALSE(file->origin);
    EXPECT_FALSE(file->land.aridity);
    EXPECT_EQ(messageOf("dem = a b.tif"), "") << "names may have blanks";
}

TEST(RoamFile, AFolderStandsForTheWorldInIt)
{
    const auto folder = std::filesystem::temp_directory_path() / "osgtrainer-a-world";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "ground.tif") << "heights";
    std::ofstream(folder / "world.roam") << "dem = ground.tif\n";
    const auto world = describeTerrain(folder);
    ASSERT_TRUE(world) << world.error().message();
    EXPECT_EQ(world->dems.front(), folder / "ground.tif");
    std::filesystem::remove(folder / "world.roam");
    const auto none = describeTerrain(folder);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->dems.front(), folder) << "a raster by name, whose reader refuses folders";
    std::filesystem::remove_all(folder);
}

TEST(RoamFile, ErrorsNameFileAndLine)
{
    using testing::HasSubstr;
    EXPECT_THAT(messageOf("# nothing\n"), HasSubstr("place.roam:2: no dem is named"));
    EXPECT_THAT(messageOf("dem = a.tif\n\ncolour = red\n"),
                HasSubstr("folder/place.roam:3: unknown key 'colour'"));
    EXPECT_THAT(messageOf("dem = a.tif\nspacing = 3x\n"), HasSubstr("place.roam:2: '3x' is not a number"));
    EXPECT_THAT(messageOf("dem = a.tif\nspacing = nan\n"), HasSubstr("place.roam:2: 'nan' is not a number"));
    EXPECT_THAT(messageOf("dem = a.tif\nspacing = -3\n"), HasSubstr("out of range"));
    EXPECT_THAT(messageOf("dem = a.tif\nspacing = 1 2\n"), HasSubstr("2 numbers"));
    EXPECT_THAT(messageOf("dem = a.tif\norigin = 46\n"), HasSubstr("place.roam:2: origin has 1 numbers"));
    EXPECT_THAT(messageOf("dem = a.tif\norigin = 96 8\n"), HasSubstr("no place on Earth"));
    EXPECT_THAT(messageOf("dem = a.tif\nspacing = 3\nspacing = 4\n"),
                HasSubstr("place.roam:3: 'spacing' stands here a second time"));
    EXPECT_THAT(messageOf("dem = a.tif\nvoids = dig\n"), HasSubstr("use one of: fill, keep"));
    EXPECT_THAT(messageOf("dem = a.tif\nplacement = round\n"), HasSubstr("use one of: curved, planar"));
    EXPECT_THAT(messageOf("dem = a.tif\nmethod = magic\n"), HasSubstr("roam"));
    EXPECT_THAT(messageOf("dem = a.tif\nsun = 10 100\n"), HasSubstr("place.roam:2"));
    EXPECT_THAT(messageOf("dem = a.tif\nmax_triangles =\n"), HasSubstr("has no value"));
    EXPECT_THAT(messageOf("dem a.tif\n"), HasSubstr("place.roam:1: not of the form key = value"));
}

TEST(RoamFile, AMissingDemIsNamedWithItsLine)
{
    const auto folder = std::filesystem::temp_directory_path() / "osgtrainer-roamfile-test";
    std::filesystem::create_directories(folder);
    const auto path = folder / "place.roam";
    std::ofstream(path) << "# here\nspacing = 3\ndem = missing.tif\n";
    const auto file = readRoamFile(path);
    ASSERT_FALSE(file);
    EXPECT_THAT(file.error().place, testing::EndsWith("place.roam:3"));
    EXPECT_THAT(file.error().what, testing::HasSubstr("missing.tif' does not exist"));
    std::ofstream(folder / "dem.asc") << "here";
    std::ofstream(path) << "dem = dem.asc\nfeatures = dem.asc\n# there\nfeatures = none.gpkg\n";
    EXPECT_THAT(readRoamFile(path).error().place, testing::EndsWith("place.roam:4"))
        << "the second of its kind";
    std::ofstream(path) << "dem = dem.asc\n# another\ndem = none.tif\n";
    EXPECT_THAT(readRoamFile(path).error().place, testing::EndsWith("place.roam:3"));
    std::ofstream(path) << "dem = dem.asc\nland_cover_classes = none.txt\n";
    EXPECT_THAT(readRoamFile(path).error().message(), testing::HasSubstr("place.roam:2: land_cover_classes"));
    EXPECT_THAT(readRoamFile(folder / "none.roam").error().message(),
                testing::HasSubstr("none.roam: cannot be read"));
    std::ofstream(folder / "binary.roam") << std::string("dem = a\0b", 9);
    EXPECT_FALSE(readRoamFile(folder / "binary.roam"));
    std::filesystem::remove_all(folder);
}

TEST(RoamFile, ATextDamagedAtRandomIsReadOrRefusedWithItsPlace)
{
    testsupport::Random random(2024);
    const std::string whole = kWhole;
    int refused = 0;
    for (int round = 0; round < 20000; ++round)
    {
        std::string text = whole;
        for (std::uint32_t change = 0; change <= random.below(4); ++change)
        {
            const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
            switch (random.below(4))
            {
            case 0:
                text[at] = static_cast<char>(random.below(256));
                break;
            case 1:
                text.erase(at, 1 + random.below(12));
                break;
            case 2:
                text.insert(at, 1, static_cast<char>(random.below(256)));
                break;
            default:
                text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), 20));
                break;
            }
            if (text.empty()) text = "x";
        }
        const auto file = parseRoamFile(text, "folder/place.roam");
        if (file)
        {
            EXPECT_FALSE(file->dems.empty());
            continue;
        }
        ++refused;
        EXPECT_THAT(file.error().place, testing::MatchesRegex("folder/place\\.roam:[0-9]+"));
        EXPECT_FALSE(file.error().remedy.empty());
    }
    EXPECT_GT(refused, 5000) << "damage must show";
    EXPECT_LT(refused, 20000) << "and not everything is damage";
}
