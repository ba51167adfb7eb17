// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterWriter.h"
#include "UnsortedTags.h"

namespace
{

using namespace osgTerrainROAM::core;
using testing::HasSubstr;

/// The one-line message of an import that must fail. Checks that it names the file and a remedy.
std::string refusal(const std::filesystem::path& file, const DemImportOptions& options = {})
{
    testing::internal::CaptureStderr();
    const auto field = importDem(file, options);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "GDAL's words belong into the error";
    if (field) return "was accepted";
    EXPECT_FALSE(field.error().remedy.empty());
    EXPECT_EQ(field.error().message().find('\n'), std::string::npos);
    EXPECT_THAT(field.error().message(), HasSubstr(file.filename().string()));
    return field.error().message();
}

RasterSpec example()
{
    RasterSpec spec;
    spec.geoTransform = northUp3Seconds(spec.rows);
    spec.epsg = 4326;
    return spec;
}

TEST(DemErrors, AMissingFileAFolderAndAForeignFormatAreNamed)
{
    const TemporaryFolder folder;
    EXPECT_THAT(refusal(folder / "none.tif"), HasSubstr("no such file"));
    EXPECT_THAT(refusal(folder.path()), HasSubstr("is a folder"));
    writeBytes(folder / "notes.txt", "no raster at all\n");
    EXPECT_THAT(refusal(folder / "notes.txt"), HasSubstr("no format that GDAL reads"));
    writeBytes(folder / "empty.tif", "");
    EXPECT_THAT(refusal(folder / "empty.tif"), HasSubstr("damaged or in no format"));
    writeBytes(folder / "broken.zip", "PK nonsense");
    EXPECT_THAT(refusal(folder / "broken.zip"), HasSubstr("zip archive"));
    writeZip(folder / "text.zip", "notes.txt", "no raster at all\n");
    EXPECT_THAT(refusal(folder / "text.zip"), HasSubstr("no format that GDAL reads"));
    writeBytes(folder / "broken.hgt.gz", "\x1f\x8b nonsense");
    EXPECT_THAT(refusal(folder / "broken.hgt.gz"), HasSubstr("damaged or in no format"));
}

TEST(DemErrors, SeveralBandsAndPalettesAreNoElevation)
{
    const TemporaryFolder folder;
    RasterSpec spec = example();
    spec.bands = 3;
    writeRaster(folder / "rgb.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "rgb.tif"), HasSubstr("has 3 bands"));
    spec = example();
    spec.type = GDT_CFloat32;
    writeRaster(folder / "complex.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "complex.tif"), HasSubstr("complex numbers"));
}

TEST(DemErrors, WhatGdalWarnsOfIsToldOnceWithTheFile)
{
    const TemporaryFolder folder;
    writeRaster(folder / "plain.tif", "GTiff", example());
    const auto plain = importDem(folder / "plain.tif");
    ASSERT_TRUE(plain);
    EXPECT_TRUE(plain->notes.empty()) << plain->notes[0];
    testsupport::unsortTags(folder / "plain.tif");
    const auto unsorted = importDem(folder / "plain.tif");
    ASSERT_TRUE(unsorted) << unsorted.error().message();
    ASSERT_EQ(unsorted->notes.size(), 1u);
    EXPECT_THAT(unsorted->notes[0], HasSubstr("plain.tif: GDAL warns: "));
    EXPECT_THAT(unsorted->notes[0], HasSubstr("not sorted"));
}

TEST(DemErrors, AGridByControlPointsIsRefused)
{
    const TemporaryFolder folder;
    writeBytes(
        folder / "points.vrt",
        "<VRTDataset rasterXSize='2' rasterYSize='2'><GCPList Projection='EPSG:4326'>"
        "<GCP Id='1' Pixel='0' Line='0' X='8' Y='46'/><GCP Id='2' Pixel='2' Line='0' X='8.1' Y='46.1'/>"
        "<GCP Id='3' Pixel='0' Line='2' X='8.2' Y='45.7'/></GCPList>"
        "<VRTRasterBand dataType='Float32' band='1'/></VRTDataset>");
    EXPECT_THAT(refusal(folder / "points.vrt"), HasSubstr("placed by control points"));
}

TEST(DemErrors, ARotatedGridIsRefusedAndAStraightOneIsNot)
{
    const TemporaryFolder folder;
    RasterSpec spec = example();
    (*spec.geoTransform)[2] = 1e-4;
    (*spec.geoTransform)[4] = 1e-4;
    writeRaster(folder / "rotated.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "rotated.tif"), HasSubstr("rotated"));
    spec = example();
    (*spec.geoTransform)[2] = (*spec.geoTransform)[1];
    (*spec.geoTransform)[4] = (*spec.geoTransform)[1];
    (*spec.geoTransform)[1] = (*spec.geoTransform)[5] = 0.0;
    writeRaster(folder / "quarter.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "quarter.tif"), HasSubstr("rotated")) << "a quarter turn";
    writeRaster(folder / "straight.tif", "GTiff", example());
    EXPECT_TRUE(importDem(folder / "straight.tif"));
}

TEST(DemErrors, VoidsAloneAreNoTerrain)
{
    const TemporaryFolder folder;
    RasterSpec spec = example();
    spec.values.assign(20, -9999.0);
    spec.noData = -9999.0;
    writeRaster(folder / "void.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "void.tif"), HasSubstr("every sample is void"));
    spec.values[3] = 12.0;
    writeRaster(folder / "one.tif", "GTiff", spec);
    EXPECT_TRUE(importDem(folder / "one.tif"));
}

TEST(DemErrors, TooSmallAndTooLargeGridsSaySo)
{
    const TemporaryFolder folder;
    RasterSpec spec = example();
    spec.rows = 1;
    writeRaster(folder / "line.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "line.tif"), HasSubstr("5 x 1 samples make no surface"));
    spec.columns = 32770;
    spec.rows = 2;
    spec.type = GDT_Byte;
    spec.values.assign(2 * 32770, 1.0);
    writeRaster(folder / "wide.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "wide.tif"), HasSubstr("too many for one tile"));
}

TEST(DemErrors, ASpacingMustBeADistance)
{
    const TemporaryFolder folder;
    RasterSpec spec;
    spec.type = GDT_Byte;
    writeRaster(folder / "picture.png", "PNG", spec);
    for (const double spacing : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN()})
    {
        DemImportOptions options;
        options.spacingM = spacing;
        EXPECT_THAT(refusal(folder / "picture.png", options), HasSubstr("spacing"));
    }
}

TEST(DemErrors, CoordinatesOffTheEarthAreRefused)
{
    const TemporaryFolder folder;
    RasterSpec spec;
    spec.geoTransform = {1e12, 10.0, 0.0, 1e12, 0.0, -10.0};
    spec.epsg = 32632;
    writeRaster(folder / "nowhere.tif", "GTiff", spec);
    EXPECT_THAT(refusal(folder / "nowhere.tif"), HasSubstr("map projection"));
}

TEST(DemErrors, TheThreadsOwnGdalSettingsAndHandlerComeBack)
{
    CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "MAYBE");
    static int calls;
    calls = 0;
    CPLPushErrorHandler([](CPLErr, CPLErrorNum, const char*) { ++calls; });
    EXPECT_FALSE(importDem("/nonexistent/file.tif"));
    const TemporaryFolder folder;
    writeBytes(folder / "notes.txt", "no raster at all\n");
    EXPECT_FALSE(importDem(folder / "notes.txt"));
    EXPECT_EQ(calls, 0);
    EXPECT_STREQ(CPLGetThreadLocalConfigOption("GDAL_PAM_ENABLED", "unset"), "MAYBE");
    EXPECT_STREQ(CPLGetThreadLocalConfigOption("CPL_VSIL_GZIP_WRITE_PROPERTIES", "unset"), "unset");
    CPLError(CE_Failure, CPLE_AppDefined, "mine");
    EXPECT_EQ(calls, 1);
    CPLPopErrorHandler();
    CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
}

} // namespace
