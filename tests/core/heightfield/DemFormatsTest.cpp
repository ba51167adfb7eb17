// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "RasterWriter.h"
#include "SetScaleY.h"

namespace
{

using namespace osgTerrainROAM::core;

/// Imports and expects exampleHeight in every sample.
void expectExample(const std::filesystem::path& file, int columns, int rows,
                   const DemImportOptions& options = {})
{
    const auto field = importDem(file, options);
    ASSERT_TRUE(field) << field.error().message();
    ASSERT_EQ(field->columns, columns);
    ASSERT_EQ(field->rows, rows);
    ASSERT_TRUE(field->isComplete());
    EXPECT_EQ(field->voids.count, 0u);
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            EXPECT_EQ(field->heightM(c, r), exampleHeight(c, r)) << c << ", " << r;
}

RasterSpec geographic(GDALDataType type)
{
    RasterSpec spec;
    spec.type = type;
    spec.geoTransform = northUp3Seconds(spec.rows);
    spec.epsg = 4326;
    return spec;
}

GeodeticNet::Node southWest(const std::filesystem::path& file, const DemImportOptions& options = {})
{
    const auto field = importDem(file, options);
    if (!field || !field->net) return {0.0, 0.0, 0.0};
    return field->net->node(0, 0);
}

TEST(DemFormats, GeoTiffsOfAllNumberTypesKeepEverySample)
{
    const TemporaryFolder folder;
    for (const GDALDataType type : {GDT_Byte, GDT_Int16, GDT_UInt16, GDT_Int32, GDT_Float32, GDT_Float64})
    {
        const auto file = folder / (std::string(GDALGetDataTypeName(type)) + ".tif");
        writeRaster(file, "GTiff", geographic(type));
        expectExample(file, 5, 4);
    }
}

TEST(DemFormats, SamplePositionsArePixelCentres)
{
    const TemporaryFolder folder;
    writeRaster(folder / "area.tif", "GTiff", geographic(GDT_Int16));
    const GeodeticNet::Node node = southWest(folder / "area.tif");
    EXPECT_NEAR(node.latitudeDeg, 46.0, 1e-10);
    EXPECT_NEAR(node.longitudeDeg, 8.0, 1e-10);

    // GDAL's transform, as written here, refers to pixel corners for area and point rasters alike.
    RasterSpec point = geographic(GDT_Int16);
    point.options = {"GEOTIFF_VERSION=1.1"};
    writeRaster(folder / "point.tif", "GTiff", point);
    EXPECT_NEAR(southWest(folder / "point.tif").latitudeDeg, 46.0, 1e-10);
}

TEST(DemFormats, SouthUpNorthUpAndMirroredColumnsGiveTheSameField)
{
    const TemporaryFolder folder;
    constexpr double kStep = 3.0 / 3600.0;
    RasterSpec spec = geographic(GDT_Float32);
    spec.geoTransform = {8.0 - 0.5 * kStep, kStep, 0.0, 46.0 - 0.5 * kStep, 0.0, kStep};
    writeRaster(folder / "south.tif", "GTiff", spec);
    expectExample(folder / "south.tif", 5, 4);
    EXPECT_NEAR(southWest(folder / "south.tif").latitudeDeg, 46.0, 1e-10);

    spec.geoTransform = {8.0 + 4.5 * kStep, -kStep, 0.0, 46.0 + 3.5 * kStep, 0.0, -kStep};
    spec.values.clear();
    for (int r = 3; r >= 0; --r)
        for (int c = 4; c >= 0; --c)
            spec.values.push_back(exampleHeight(c, r));
    writeRaster(folder / "west.tif", "GTiff", spec);
    expectExample(folder / "west.tif", 5, 4);
    EXPECT_NEAR(southWest(folder / "west.tif").longitudeDeg, 8.0, 1e-10);
}

/// The GeoTIFF specification has a negative ScaleY mean rows from south to north; GDAL takes it for north-up
/// unless it is asked not to. A transform of the same meaning gives the same field, and both are told.
TEST(DemFormats, ANegativeScaleIsSouthUp)
{
    const TemporaryFolder folder;
    constexpr double kStep = 3.0 / 3600.0;
    for (const bool isScale : {true, false})
    {
        RasterSpec spec = geographic(GDT_Float32);
        for (int r = 0; r < spec.rows; ++r)
            for (int c = 0; c < spec.columns; ++c)
                spec.values.push_back(exampleHeight(c, r));
        if (!isScale) spec.geoTransform = {8.0 - 0.5 * kStep, kStep, 0.0, 46.0 - 0.5 * kStep, 0.0, kStep};
        writeRaster(folder / "south.tif", "GTiff", spec);
        if (isScale) testsupport::setScaleY(folder / "south.tif", -kStep, 46.0 - 0.5 * kStep);
        expectExample(folder / "south.tif", 5, 4);
        EXPECT_NEAR(southWest(folder / "south.tif").latitudeDeg, 46.0, 1e-10);
        const auto field = importDem(folder / "south.tif");
        ASSERT_TRUE(field);
        ASSERT_EQ(field->notes.size(), 1u);
        EXPECT_NE(field->notes[0].find("from south to north"), std::string::npos) << field->notes[0];
    }
    writeRaster(folder / "north.tif", "GTiff", geographic(GDT_Float32));
    EXPECT_TRUE(importDem(folder / "north.tif")->notes.empty());
}

TEST(DemFormats, ProjectedRastersAreOnTheEarth)
{
    const TemporaryFolder folder;
    RasterSpec spec;
    spec.geoTransform = {499995.0, 10.0, 0.0, 5100040.0, 0.0, -10.0};
    spec.epsg = 32632;
    writeRaster(folder / "utm.tif", "GTiff", spec);
    expectExample(folder / "utm.tif", 5, 4);
    const auto field = importDem(folder / "utm.tif");
    // The central meridian of zone 32; scale 0.9996 there.
    EXPECT_NEAR(field->net->node(0, 0).longitudeDeg, 9.0, 1e-9);
    EXPECT_NEAR(field->net->node(0, 0).latitudeDeg, 46.05, 0.01);
    EXPECT_NEAR(field->spacingEastM, 10.0 / 0.9996, 1e-4);
    EXPECT_NEAR(field->spacingNorthM, 10.0 / 0.9996, 1e-4);
}

TEST(DemFormats, NodataNanAndImpossibleHeightsAreVoids)
{
    const TemporaryFolder folder;
    RasterSpec spec = geographic(GDT_Float32);
    spec.noData = 1.70141e38;
    spec.values.assign(20, 100.0);
    spec.values[6] = 1.70141e38;
    spec.values[7] = std::nan("");
    spec.values[8] = 1e6;
    spec.values[12] = -20000.0;
    writeRaster(folder / "voids.tif", "GTiff", spec);
    const auto field = importDem(folder / "voids.tif");
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_EQ(field->voids.count, 4u);
    EXPECT_DOUBLE_EQ(field->voids.share, 0.2);
    EXPECT_NE(field->voids.method.find("2 of them for heights outside"), std::string::npos);
    for (const float h : field->heightsM)
        EXPECT_EQ(h, 100.0f);
    int measured = 0;
    for (int row = 0; row < field->rows; ++row)
        measured += field->measured.countIn(row, 0, field->columns - 1);
    EXPECT_EQ(measured, 16);

    spec.values[6] = 100.0; // one void fewer must be noticed
    writeRaster(folder / "fewer.tif", "GTiff", spec);
    EXPECT_EQ(importDem(folder / "fewer.tif")->voids.count, 3u);
}

TEST(DemFormats, FeetAndScalesBecomeMetres)
{
    const TemporaryFolder folder;
    RasterSpec spec = geographic(GDT_Float32);
    spec.values.assign(20, 1000.0);
    spec.unit = "ft";
    writeRaster(folder / "feet.tif", "GTiff", spec);
    EXPECT_FLOAT_EQ(importDem(folder / "feet.tif")->heightM(2, 2), 304.8f);
}

TEST(DemFormats, TheGeoidIsEgm96)
{
    // The test points that NGA published with its EGM96 interpolation program.
    static constexpr double kPoints[][3] = {
        {38.6281550, 269.7791550, -31.628}, {-14.6212170, 305.0211140, -2.969},
        {46.8743190, 102.4487290, -43.575}, {-23.6174460, 133.8747120, 15.871},
        {38.6254730, 359.9995000, 50.066},  {-0.4667440, 0.0023000, 17.329}};
    const TemporaryFolder folder;
    constexpr double kStep = 3.0 / 3600.0;
    for (const auto& [latitude, longitude, undulation] : kPoints)
    {
        RasterSpec spec = geographic(GDT_Float32);
        const double west = std::remainder(longitude, 360.0);
        spec.geoTransform = {west - 0.5 * kStep, kStep, 0.0, latitude + 3.5 * kStep, 0.0, -kStep};
        writeRaster(folder / "point.tif", "GTiff", spec);
        EXPECT_NEAR(southWest(folder / "point.tif").geoidM, undulation, 0.25)
            << latitude << ", " << longitude;
    }
}

TEST(DemFormats, HeightsAreRaisedByTheGeoidUnlessTheFileOrTheCallerSaysEllipsoid)
{
    const TemporaryFolder folder;
    writeRaster(folder / "plain.tif", "GTiff", geographic(GDT_Float32));
    const double geoid = southWest(folder / "plain.tif").geoidM;
    EXPECT_GT(geoid, 45.0);
    DemImportOptions ellipsoid;
    ellipsoid.verticalDatum = VerticalDatum::ellipsoid;
    EXPECT_EQ(southWest(folder / "plain.tif", ellipsoid).geoidM, 0.0);

    RasterSpec spatial = geographic(GDT_Float32);
    spatial.epsg = 4979;
    spatial.options = {"GEOTIFF_VERSION=1.1"};
    writeRaster(folder / "spatial.tif", "GTiff", spatial);
    EXPECT_EQ(southWest(folder / "spatial.tif").geoidM, 0.0);
    EXPECT_NEAR(southWest(folder / "spatial.tif").latitudeDeg, 46.0, 1e-10);
    DemImportOptions egm96;
    egm96.verticalDatum = VerticalDatum::egm96;
    EXPECT_EQ(southWest(folder / "spatial.tif", egm96).geoidM, geoid);

    RasterSpec compound = geographic(GDT_Float32);
    compound.epsg = 0;
    compound.crs = "EPSG:4326+5773";
    writeRaster(folder / "compound.tif", "GTiff", compound);
    EXPECT_EQ(southWest(folder / "compound.tif").geoidM, geoid);
}

TEST(DemFormats, SrtmFilesOpenPlainZippedAndGzipped)
{
    const TemporaryFolder folder;
    const std::string bytes = hgtBytes();
    writeBytes(folder / "N46E008.hgt", bytes);
    writeGzip(folder / "S34W071.hgt.gz", bytes);
    writeZip(folder / "N46E008.hgt.zip", "N46E008.hgt", bytes);
    writeZip(folder / "inner.zip", "folder/N46W009.hgt", bytes);
    for (const char* name : {"N46E008.hgt", "S34W071.hgt.gz", "N46E008.hgt.zip", "inner.zip"})
    {
        const auto field = importDem(folder / name);
        ASSERT_TRUE(field) << field.error().message();
        EXPECT_EQ(field->columns, 1201);
        for (int i = 0; i < 1201; i += 7)
            EXPECT_EQ(field->heightM(i, (i * 31) % 1201),
                      static_cast<float>(static_cast<int>(exampleHeight(i, (i * 31) % 1201)) % 4000));
    }
    EXPECT_NEAR(southWest(folder / "S34W071.hgt.gz").latitudeDeg, -34.0, 1e-9);
    EXPECT_NEAR(southWest(folder / "inner.zip").longitudeDeg, -9.0, 1e-9);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 4)
        << "something was left beside";
}

TEST(DemFormats, Dted)
{
    const TemporaryFolder folder;
    RasterSpec spec = geographic(GDT_Int16);
    constexpr double kStep = 30.0 / 3600.0;
    spec.columns = spec.rows = 121;
    spec.geoTransform = {8.0 - 0.5 * kStep, kStep, 0.0, 47.0 + 0.5 * kStep, 0.0, -kStep};
    writeRaster(folder / "n46.dt0", "DTED", spec);
    expectExample(folder / "n46.dt0", 121, 121);
    EXPECT_NEAR(southWest(folder / "n46.dt0").latitudeDeg, 46.0, 1e-9);
}

TEST(DemFormats, EsriAsciiIsAPlaneUnlessItsNumbersAreDegrees)
{
    const TemporaryFolder folder;
    const std::string rows = "61 64 67\n44 47 50\n27 30 33\n10 13 16\n";
    writeBytes(folder / "plane.asc",
               "ncols 3\nnrows 4\nxllcorner 500000\nyllcorner 4000000\ncellsize 5\n" + rows);
    expectExample(folder / "plane.asc", 3, 4);
    auto field = importDem(folder / "plane.asc");
    EXPECT_FALSE(field->net);
    EXPECT_EQ(field->spacingEastM, 5.0);

    writeBytes(
        folder / "degrees.asc",
        "ncols 3\nnrows 4\nxllcenter -105.5\nyllcenter 40.25\ncellsize 0.000833333333\nNODATA_value 0\n" +
            rows);
    field = importDem(folder / "degrees.asc");
    ASSERT_TRUE(field->net);
    EXPECT_NEAR(field->net->node(0, 0).latitudeDeg, 40.25, 1e-9);
    EXPECT_NEAR(field->spacingNorthM, 92.5, 0.2);

    // A flume of 1 cm cells, and a survey of 30 m whose numbers happen to be small.
    writeBytes(folder / "flume.asc", "ncols 3\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 0.01\n" + rows);
    EXPECT_EQ(importDem(folder / "flume.asc")->spacingEastM, 0.01);
    writeBytes(folder / "small.asc", "ncols 3\nnrows 4\nxllcorner 10\nyllcorner 10\ncellsize 20\n" + rows);
    EXPECT_EQ(importDem(folder / "small.asc")->spacingEastM, 20.0);
}

TEST(DemFormats, GrassAsciiKeepsItsNullsApartFromZero)
{
    const TemporaryFolder folder;
    const std::string grid = "north: 4000120\nsouth: 4000000\neast: 500090\nwest: 500000\nrows: 4\ncols: 3\n"
                             "61 64 67\n44 0 50\n27 * 33\n10 13 16\n";
    writeBytes(folder / "grass.asc", grid);
    writeGzip(folder / "grass.asc.gz", grid);
    for (const char* name : {"grass.asc", "grass.asc.gz"})
    {
        const auto field = importDem(folder / name);
        ASSERT_TRUE(field) << field.error().message();
        EXPECT_EQ(field->voids.count, 1u);
        EXPECT_EQ(field->heightM(1, 2), 0.0f);
        EXPECT_GT(field->heightM(1, 1), 0.0f);
        EXPECT_EQ(field->spacingEastM, 30.0);
    }
}

TEST(DemFormats, PicturesNeedASpacing)
{
    const TemporaryFolder folder;
    RasterSpec spec;
    spec.type = GDT_Byte;
    writeRaster(folder / "heights.png", "PNG", spec);
    const auto refused = importDem(folder / "heights.png");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message().find("--spacing"), std::string::npos);
    DemImportOptions options;
    options.spacingM = 12.5;
    expectExample(folder / "heights.png", 5, 4, options);
    EXPECT_EQ(importDem(folder / "heights.png", options)->spacingNorthM, 12.5);
}

TEST(DemFormats, TheSmallestGridIsPlaced)
{
    const TemporaryFolder folder;
    RasterSpec spec = geographic(GDT_Float32);
    spec.columns = spec.rows = 2;
    spec.geoTransform = northUp3Seconds(2);
    writeRaster(folder / "four.tif", "GTiff", spec);
    expectExample(folder / "four.tif", 2, 2);
    const PlacedTile tile(*importDem(folder / "four.tif"));
    EXPECT_EQ(tile.grid().side(), 3);
    EXPECT_NEAR(glm::distance(tile.position(0, 0), tile.position(0, 1)), std::hypot(92.6, 17.0), 0.1);
}

TEST(DemFormats, GridsAtThePoleAndAcrossTheAntimeridianAreWhole)
{
    const TemporaryFolder folder;
    constexpr double kStep = 30.0 / 3600.0;
    RasterSpec spec = geographic(GDT_Float32);
    spec.columns = spec.rows = 40;
    spec.geoTransform = {179.8 - 0.5 * kStep, kStep, 0.0, 90.0 + 0.5 * kStep, 0.0, -kStep};
    writeRaster(folder / "pole.tif", "GTiff", spec);
    const auto field = importDem(folder / "pole.tif");
    ASSERT_TRUE(field) << field.error().message();
    const PlacedTile tile(*field);
    for (int r = 0; r < 39; ++r)
        for (int c = 0; c < 39; ++c)
        {
            const double height = exampleHeight(c, r + 1) - exampleHeight(c, r);
            EXPECT_NEAR(glm::distance(tile.position(c, r), tile.position(c, r + 1)),
                        std::hypot(930.8, height), 0.5);
            const double around = 930.8 * (39 - r) * kStep * 3.14159265 / 180.0;
            EXPECT_NEAR(glm::distance(tile.position(c, r), tile.position(c + 1, r)), std::hypot(around, 3.0),
                        0.01);
        }
}

} // namespace
