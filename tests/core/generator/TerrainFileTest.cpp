// SPDX-License-Identifier: Apache-2.0
#include "TerrainFile.h"

#include <filesystem>
#include <fstream>
#include <memory>

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

namespace islandgen
{

namespace
{

/// A folder of its own for each test, removed at its end.
class TerrainFile : public ::testing::Test
{
protected:
    void SetUp() override
    {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        _folder = std::filesystem::path(::testing::TempDir()) / (std::string("terrainfile-") + info->name());
        std::filesystem::remove_all(_folder);
        std::filesystem::create_directories(_folder);
    }
    void TearDown() override { std::filesystem::remove_all(_folder); }

    std::filesystem::path _folder;
};

Terrain ramp()
{
    Terrain terrain{Grid<float>(9), 12.0f};
    for (int cell = 0; cell < terrain.heightM.count(); ++cell)
        terrain.heightM[cell] = static_cast<float>(cell);
    return terrain;
}

} // namespace

TEST_F(TerrainFile, HoldsHeightsNorthUpAtTheirPlace)
{
    const auto file = _folder / "ramp.tif";
    ASSERT_TRUE(writeTerrain(ramp(), file));
    const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(file.c_str()));
    ASSERT_TRUE(dataset);
    ASSERT_EQ(dataset->GetRasterXSize(), 9);
    ASSERT_EQ(dataset->GetRasterBand(1)->GetRasterDataType(), GDT_Float32);
    float corner = 0.0f; // the north-western sample is the first of the last row
    ASSERT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 1, 1, &corner, 1, 1, GDT_Float32, 0, 0),
              CE_None);
    EXPECT_EQ(corner, 72.0f);
    double place[6];
    ASSERT_EQ(dataset->GetGeoTransform(place), CE_None);
    EXPECT_DOUBLE_EQ(place[0] + 4.5 * place[1], kCentreEastingM);
    EXPECT_DOUBLE_EQ(place[3] + 4.5 * place[5], kCentreNorthingM);
    OGRSpatialReference expected;
    expected.importFromEPSG(32632);
    EXPECT_TRUE(dataset->GetSpatialRef()->IsSame(&expected));
}

TEST_F(TerrainFile, LeavesNothingElseInItsFolder)
{
    ASSERT_TRUE(writeTerrain(ramp(), _folder / "ramp.tif"));
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(_folder))
        ++files;
    EXPECT_EQ(files, 1);
}

TEST_F(TerrainFile, NamesTheFileThatCannotBeWritten)
{
    const auto outcome = writeTerrain(ramp(), _folder / "missing" / "ramp.tif");
    ASSERT_FALSE(outcome);
    EXPECT_NE(outcome.error().place.find("missing"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(_folder / "missing"));
}

TEST_F(TerrainFile, LeavesNoPartWhereTheNameIsTaken)
{
    const auto file = _folder / "folder.tif";
    std::filesystem::create_directories(file / "inside");
    EXPECT_FALSE(writeTerrain(ramp(), file));
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

} // namespace islandgen
