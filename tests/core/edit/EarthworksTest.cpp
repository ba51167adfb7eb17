// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/ShapeGround.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "TestFolder.h"

using osgTerrainROAM::core::Earthwork;
using osgTerrainROAM::core::Earthworks;

namespace
{

/// A slope of 5 % that falls to the east, from 100 m.
double hillside(const glm::dvec2& place)
{
    return 100.0 - 0.05 * place.x;
}

std::optional<double> known(const glm::dvec2& place)
{
    return hillside(place);
}

Earthwork lake(double levelM, double riseM = 0.3)
{
    Earthwork work;
    work.isArea = true;
    work.paths = {{{0, 0}, {100, 0}, {100, 80}, {0, 80}}};
    work.heightsM = {std::vector<double>(4, levelM)};
    work.slope = 0.5;
    work.riseM = riseM;
    return work;
}

Earthwork river(double fromM, double toM)
{
    Earthwork work;
    work.paths = {{{50, 40}, {100, 40}, {300, 40}}};
    work.heightsM = {{fromM, fromM, toM}};
    work.widthM = 8.0;
    return work;
}

Earthwork runway()
{
    Earthwork work;
    work.paths = {{{-100, 0}, {900, 0}}};
    work.heightsM = {{80.0, 70.0}};
    work.widthM = 30.0;
    work.crossfall = 0.015;
    work.stripM = 25.0;
    work.stripFall = 0.02;
    work.slope = 1.0 / 3.0;
    return work;
}

/// A river of two pieces that falls by 7 %, 40 m wide, and a brook from the side, whose end lies in it.
std::vector<Earthwork> widePieces(int number, int brook)
{
    std::vector<Earthwork> works;
    for (const double from : {0.0, 150.0})
    {
        Earthwork work;
        work.paths = {{{from, 0}, {from + 150.0, 0}}};
        work.heightsM = {{90.0 - 0.07 * from, 90.0 - 0.07 * (from + 150.0)}};
        work.widthM = from > 0.0 ? 60.0 : 40.0;
        work.river = number;
        works.push_back(work);
    }
    Earthwork side;
    side.paths = {{{150, 100}, {150, 0}}};
    side.heightsM = {{85.0, 79.5}};
    side.widthM = 6.0;
    side.river = brook;
    works.push_back(side);
    return works;
}

/// The highest step over a metre in the bed of the river.
double highestStepM(const std::vector<Earthwork>& made)
{
    const Earthworks works(made, 0.0, known);
    double worst = 0.0;
    for (double east = 20.0; east < 280.0; east += 1.0)
        for (const double side : {-15.0, -5.0, 5.0})
            worst = std::max(
                worst, std::abs(works.heightM({east, side}, 0.0) - works.heightM({east + 1.0, side}, 0.0)));
    return worst;
}

/// Looks around a lake whether its shore is higher than its water.
bool holdsWater(const Earthworks& works, double levelM)
{
    for (double out = 0.5; out < 4.0; out += 0.5)
        for (double along = 5.0; along < 80.0; along += 5.0)
            for (const glm::dvec2 place :
                 {glm::dvec2(-out, along), {100.0 + out, along}, {along, -out}, {along, 80.0 + out}})
                if (works.heightM(place, hillside(place)) < levelM + 0.09 * std::min(out, 3.0)) return false;
    return true;
}

} // namespace

TEST(Earthworks, ARiverHasNoStepWhereItsPiecesMeet)
{
    EXPECT_LT(highestStepM(widePieces(1, 2)), 0.08);
    // The control: works that nobody calls one river.
    EXPECT_GT(highestStepM(widePieces(0, 0)), 0.5);
}

TEST(Earthworks, ALakeIsLevelAndItsShoreHoldsIt)
{
    const Earthworks works({lake(97.0)}, 0.0, known);
    for (double x = 1.0; x < 100.0; x += 7.0)
        EXPECT_NEAR(works.heightM({x, 40.0}, hillside({x, 40.0})), 97.0, 1e-9);
    EXPECT_TRUE(holdsWater(works, 97.0));
    EXPECT_EQ(works.heightM({-400.0, 40.0}, 120.0), 120.0) << "far away the ground stays";
    const Earthworks dry({lake(97.0, 0.0)}, 0.0, known); // without a rise the water runs off to the east
    EXPECT_FALSE(holdsWater(dry, 97.0));
}

TEST(Earthworks, BanksHaveTheirSlope)
{
    const Earthworks works({lake(97.0)}, 0.0, known);
    // To the west the ground is 3 m higher: cut at 1 in 2.
    EXPECT_NEAR(works.heightM({-2.0, 40.0}, hillside({-2.0, 40.0})), 98.0, 1e-9);
    // To the east it is 2 m lower: 0.3 m of shore, a metre of crest, then down at 1 in 2.
    EXPECT_NEAR(works.heightM({106.0, 40.0}, hillside({106.0, 40.0})), 97.3 - 0.5 * (6.0 - 4.0), 1e-9);
}

TEST(Earthworks, GroundSteeperThanTheSlopesIsMetWithoutAWall)
{
    const auto cliff = [](const glm::dvec2& place) -> std::optional<double> { return 100.0 - 0.9 * place.x; };
    const Earthworks works({lake(97.0)}, 0.0, cliff);
    double before = 97.0;
    for (double out = 0.5; out < 400.0; out += 0.5)
    {
        const double height = works.heightM({-out, 40.0}, *cliff({-out, 40.0}));
        EXPECT_LT(height - before, 2.5) << out;
        EXPECT_GE(height - before, -1e-9) << out;
        before = height;
    }
    EXPECT_NEAR(before, *cliff({-399.5, 40.0}), 1e-9) << "the slope has ended";
}

TEST(Earthworks, ALakeDoesNotDamItsRiver)
{
    const Earthworks works({lake(97.0), river(97.0, 88.0)}, 0.0, known);
    double before = 1e9;
    for (double x = 90.0; x < 300.0; x += 1.0)
    {
        const double bed = works.heightM({x, 40.0}, hillside({x, 40.0}));
        EXPECT_LE(bed, before + 1e-9) << x;
        before = bed;
    }
    const Earthworks lakeAlone({lake(97.0)}, 0.0, known);
    EXPECT_GT(lakeAlone.heightM({103.0, 40.0}, hillside({103.0, 40.0})), 97.2) << "the dam that is meant";
}

TEST(Earthworks, ARunwayIsCrownedWithAStripBesideIt)
{
    const Earthworks works({runway()}, 0.0, known);
    const auto at = [&](double x, double y) { return works.heightM({x, y}, hillside({x, y})); };
    EXPECT_NEAR(at(400.0, 0.0), 75.0, 1e-9);
    EXPECT_NEAR(at(400.0, 15.0), 75.0 - 0.015 * 15.0, 1e-9);
    EXPECT_NEAR(at(400.0, -40.0), 75.0 - 0.015 * 15.0 - 0.02 * 25.0, 1e-9);
    // Beyond the strip the hillside, 80 m here, is cut at 1 in 3.
    EXPECT_TRUE(works.bedM({400.0, 39.0}));
    EXPECT_FALSE(works.bedM({400.0, 41.0}));
    EXPECT_NEAR(at(400.0, 43.0), 75.0 - 0.225 - 0.5 + 1.0, 1e-9);
}

TEST(Earthworks, ALineOfManyPiecesHasNoStepWherePiecesMeet)
{
    Earthwork work = runway();
    work.paths.front().clear();
    work.heightsM.front().clear();
    for (int i = 0; i <= 100; ++i)
    {
        work.paths.front().emplace_back(10.0 * i, 0.0);
        work.heightsM.front().push_back(80.0 - 0.1 * i);
    }
    const Earthworks works({work}, 0.0, known);
    for (double x = 1.0; x < 999.0; x += 0.5)
        EXPECT_NEAR(works.heightM({x, 10.0}, 0.0), 80.0 - 0.01 * x - 0.15, 1e-6) << x;
}

TEST(Earthworks, WorksWithoutHeightsOrPointsCountAsNone)
{
    Earthwork bare = lake(97.0), point = river(1.0, 2.0);
    bare.heightsM.clear();
    point.paths = {{{0.0, 0.0}}};
    point.heightsM = {{1.0}};
    EXPECT_TRUE(Earthworks({bare, point}, 0.0, known).isEmpty());
}

namespace
{

/// A hillside of 64 by 64 samples, 30 m apart, on a plane; grid points as fine as 3.75 m.
std::shared_ptr<osgTerrainROAM::core::RoamTile> hillTile()
{
    osgTerrainROAM::core::HeightField field;
    field.columns = field.rows = 64;
    field.spacingEastM = field.spacingNorthM = 30.0;
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column)
            field.heightsM.push_back(static_cast<float>(200.0 - 1.5 * column + std::sin(0.9 * row) * 4.0));
    osgTerrainROAM::core::PlacedTileOptions options;
    options.placement = osgTerrainROAM::core::Placement::planar;
    options.gridExponent = 3;
    return std::make_shared<osgTerrainROAM::core::RoamTile>(
        osgTerrainROAM::core::PlacedTile(std::move(field), options));
}

/// A lake of 400 by 300 m with an island.
Earthwork islandLake()
{
    Earthwork work = lake(150.0);
    work.paths = {{{600, 600}, {1000, 600}, {1000, 900}, {600, 900}},
                  {{780, 730}, {780, 800}, {850, 800}, {850, 730}}};
    work.heightsM = {std::vector<double>(4, 150.0), std::vector<double>(4, 150.0)};
    return work;
}

/// The farthest of the ground within the lake from its level.
double worstM(const osgTerrainROAM::core::RoamTile& tile)
{
    double worst = 0.0;
    for (double x = 600.5; x < 1000.0; x += 3.3)
        for (double y = 600.5; y < 900.0; y += 3.3)
        {
            if (x > 779.0 && x < 851.0 && y > 729.0 && y < 801.0) continue;
            worst = std::max(worst, std::abs(groundAt(tile.tile, x, y)->position.z - 150.0));
        }
    return worst;
}

} // namespace

TEST(ShapeGround, ALakeWithAnIslandIsLevelEverywhereInTheTile)
{
    const auto tile = hillTile();
    EXPECT_GT(worstM(*tile), 10.0);
    const auto report = shapeGround({islandLake()}, tile);
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_GT(report->samplesChanged, 0u);
    EXPECT_LT(worstM(*tile), 1e-3);
    EXPECT_GT(groundAt(tile->tile, 815.0, 765.0)->position.z, 151.0) << "the island stays above the water";
    EXPECT_NEAR(groundAt(tile->tile, 1700.0, 1700.0)->position.z,
                groundAt(hillTile()->tile, 1700.0, 1700.0)->position.z, 1e-9);
}

TEST(ImportEarthworks, AShapeWithoutHeightsIsToldWithItsPlace)
{
    const auto file = std::filesystem::temp_directory_path() / "flat-earthworks.geojson";
    std::ofstream(file)
        << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"width":"8"},
        "geometry":{"type":"LineString","coordinates":[[10,10],[500,10]]}}]})";
    const auto tile = hillTile();
    const auto read = osgTerrainROAM::core::importEarthworks(file, tile->tile);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message().find("flat-earthworks.geojson"), std::string::npos);
    EXPECT_NE(read.error().what.find("has no heights"), std::string::npos);
    std::filesystem::remove(file);
}

/// A table whose columns are of a type that GDAL does not know.
TEST(ImportEarthworks, WhatGdalWarnsOfIsANoteOfTheTile)
{
    const testsupport::TestFolder folder("earthworks");
    const auto file = folder.write("works.csv", "WKT,width\n\"LINESTRING Z (800 800 150,1200 800 150)\",8\n");
    const auto tile = hillTile();
    const auto notes = [&] { return tile->tile.field().notes; };
    ASSERT_TRUE(shapeGround(std::vector<std::filesystem::path>{file}, tile));
    EXPECT_TRUE(notes().empty()) << notes()[0];
    folder.write("works.csvt", "\"String\",\"Number\"\n");
    for (int i = 0; i < 2; ++i)
    {
        ASSERT_TRUE(shapeGround(std::vector<std::filesystem::path>{file}, tile));
        ASSERT_EQ(notes().size(), 1u) << "told once";
        EXPECT_NE(notes()[0].find("works.csv: GDAL warns: Unknown type : Number"), std::string::npos)
            << notes()[0];
    }
}

TEST(ImportEarthworks, ReadsHeightsAndFigures)
{
    const auto file = std::filesystem::temp_directory_path() / "earthworks.geojson";
    std::ofstream(file) << R"({"type":"FeatureCollection","features":[{"type":"Feature",
        "properties":{"width":"8","crossfall":"0.01","strip":"5","strip_fall":"0.02","slope":"0.4","rise":"0.3"},
        "geometry":{"type":"LineString","coordinates":[[10,10,150],[500,10,140]]}}]})";
    const auto tile = hillTile();
    const auto read = osgTerrainROAM::core::importEarthworks(file, tile->tile);
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->works.size(), 1u);
    const Earthwork& work = read->works.front();
    EXPECT_EQ(work.heightsM, (std::vector<std::vector<double>>{{150.0, 140.0}}));
    EXPECT_EQ(work.widthM, 8.0);
    EXPECT_EQ(work.stripM, 5.0);
    EXPECT_EQ(work.riseM, 0.3);
    std::filesystem::remove(file);
}
