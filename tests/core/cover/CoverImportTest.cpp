// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <osgTerrainROAM/core/cover/CoverImport.h>

#include "KeptFiles.h"
#include "SetScaleY.h"
#include "SyntheticField.h"
#include "UnsortedTags.h"

namespace
{

using namespace osgTerrainROAM::core;
using testing::HasSubstr;

constexpr int kCoverSide = 240;
constexpr double kStepDeg = 0.00025;
constexpr double kWest = 8.0, kNorth = 46.052; ///< the tile reaches from 46 and 8 to 46.0533 and 8.0533

/// The raster's class at a pixel from the upper left: islands of three classes, a hole without data, one
/// unknown code.
int classAt(int x, int y)
{
    if (x < 20) return 0;
    if (x == 100 && y == 100) return 77;
    const double n = std::sin(x * 0.13) + std::sin(y * 0.09 + x * 0.03);
    return n > 0.6 ? 10 : n > -0.5 ? 30 : 80;
}

class CoverImport : public testing::Test
{
protected:
    void SetUp() override
    {
        GDALAllRegister();
        write(false);
    }

    /// `isSouthUp`: the same classes at the same places, in rows from south to north.
    void write(bool isSouthUp)
    {
        _file = std::filesystem::temp_directory_path() /
                ("osgtrainer-cover-" + std::to_string(::getpid()) + ".tif");
        GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            _file.c_str(), kCoverSide, kCoverSide, 1, GDT_Byte, nullptr);
        OGRSpatialReference geodetic;
        geodetic.SetWellKnownGeogCS("WGS84");
        double transform[6]{kWest, kStepDeg, 0.0, kNorth, 0.0, -kStepDeg};
        dataset->SetSpatialRef(&geodetic);
        dataset->SetGeoTransform(transform);
        dataset->GetRasterBand(1)->SetNoDataValue(0.0);
        std::vector<unsigned char> classes;
        for (int y = 0; y < kCoverSide; ++y)
            for (int x = 0; x < kCoverSide; ++x)
                classes.push_back(static_cast<unsigned char>(classAt(x, isSouthUp ? kCoverSide - 1 - y : y)));
        EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, kCoverSide, kCoverSide, classes.data(),
                                                      kCoverSide, kCoverSide, GDT_Byte, 0, 0, nullptr),
                  CE_None);
        GDALClose(dataset);
    }
    void TearDown() override { std::filesystem::remove(_file); }

    std::filesystem::path _file;
};

PlacedTile alps()
{
    return PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65)));
}

} // namespace

TEST_F(CoverImport, EachTexelIsTheClassOfItsPlaceOnEarth)
{
    const auto tile = alps();
    const auto map = importCover(_file, worldCoverTable(), tile);
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_NEAR(map->width, 213, 2) << "the raster's own resolution: 0.0533 degrees of it";
    int compared = 0, wrong = 0, shifted = 0;
    for (int y = 0; y < map->height; ++y)
        for (int x = 0; x < map->width; ++x)
        {
            const glm::dvec3 local =
                tile.frame().positionAt(64.0 * x / (map->width - 1), 64.0 * y / (map->height - 1), 0.0);
            const Geodetic at = tile.frame().geodeticFromLocal(local);
            const double px = (at.longitudeDeg - kWest) / kStepDeg, py = (kNorth - at.latitudeDeg) / kStepDeg;
            const auto nearBorder = [](double p) { return std::abs(p - std::round(p)) < 0.05; };
            if (nearBorder(px) || nearBorder(py) || px < 0 || px >= kCoverSide || py < 0 || py >= kCoverSide)
                continue;
            const auto kindAt = [](int i, int j)
            {
                const CoverTable table = worldCoverTable();
                const auto found = table.find(classAt(i, j));
                return found == table.end() ? GroundKind::unknown : found->second;
            };
            ++compared;
            wrong += map->at(x, y) != kindAt(static_cast<int>(px), static_cast<int>(py));
            shifted += map->at(x, y) !=
                       kindAt(std::min(static_cast<int>(px) + 1, kCoverSide - 1), static_cast<int>(py));
        }
    EXPECT_GT(compared, 20000);
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(shifted, 300) << "one pixel off is found out";
}

/// A negative ScaleY and a transform of the same meaning lie as the raster from north to south does, and are
/// told; with rows in the other order the classes lie elsewhere.
TEST_F(CoverImport, RowsFromSouthToNorthLieWhereTheyBelong)
{
    const auto north = importCover(_file, worldCoverTable(), alps());
    ASSERT_TRUE(north);
    constexpr double kSouth = kNorth - kCoverSide * kStepDeg;
    for (const bool isScale : {true, false})
        for (const bool isSouthUp : {true, false})
        {
            write(isSouthUp);
            if (isScale)
                testsupport::setScaleY(_file, -kStepDeg, kSouth);
            else
            {
                GDALDataset* const dataset =
                    GDALDataset::Open(_file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE);
                double transform[6]{kWest, kStepDeg, 0.0, kSouth, 0.0, kStepDeg};
                dataset->SetGeoTransform(transform);
                GDALClose(dataset);
            }
            const auto map = importCover(_file, worldCoverTable(), alps());
            ASSERT_TRUE(map) << map.error().message();
            ASSERT_EQ(map->kinds.size(), north->kinds.size());
            double others = 0.0; // texels on the border of two pixels may take either
            for (std::size_t i = 0; i < map->kinds.size(); ++i)
                others +=
                    map->kinds[i] != north->kinds[i] ? 1.0 / static_cast<double>(map->kinds.size()) : 0.0;
            EXPECT_EQ(others < 0.01, isSouthUp) << others;
            ASSERT_EQ(map->notes.size(), 1u);
            EXPECT_THAT(map->notes[0], HasSubstr("its rows run from south to north"));
        }
}

TEST_F(CoverImport, AFinerGridUnderTheRasterChangesNothing)
{
    PlacedTileOptions options;
    options.gridExponent = 2;
    const PlacedTile fine(testsupport::onTheEarth(testsupport::hills(65, 65)), options);
    const auto there = importCover(_file, worldCoverTable(), fine),
               here = importCover(_file, worldCoverTable(), alps());
    ASSERT_TRUE(there && here);
    EXPECT_EQ(there->width, here->width);
    EXPECT_TRUE(there->kinds == here->kinds);
}

TEST_F(CoverImport, NoDataAndStrangeCodesAreUnknownAndCounted)
{
    const auto map = importCover(_file, worldCoverTable(), alps());
    ASSERT_TRUE(map);
    EXPECT_EQ(map->at(2, map->height / 2), GroundKind::unknown);
    ASSERT_EQ(map->unknownCodes.size(), 1u);
    EXPECT_EQ(map->unknownCodes.begin()->first, 77);
}

TEST_F(CoverImport, WhatGdalWarnsOfIsToldAtTheSecondImportToo)
{
    const auto plain = importCover(_file, worldCoverTable(), alps());
    ASSERT_TRUE(plain);
    EXPECT_THAT(plain->notes, testing::IsEmpty());
    testsupport::unsortTags(_file);
    const testsupport::TestFolder folder("cover-notes");
    const foundation::KeptFrom kept{std::make_shared<const foundation::KeptResults>(folder / "made"),
                                    foundation::ContentMark().add(std::string_view("alps"))};
    for (int i = 0; i < 2; ++i)
    {
        const auto map = importCover(_file, worldCoverTable(), alps(), kept);
        ASSERT_TRUE(map) << map.error().message();
        ASSERT_EQ(map->notes.size(), 1u);
        EXPECT_THAT(map->notes[0], HasSubstr(_file.string() + ": GDAL warns: "));
    }
}

TEST_F(CoverImport, ARasterPlacedByControlPointsIsRefused)
{
    const testsupport::TestFolder folder("cover-points");
    const auto file = folder / "points.tif";
    GDALDataset* const dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), kCoverSide, kCoverSide, 1, GDT_Byte, nullptr);
    GDAL_GCP points[4];
    GDALInitGCPs(4, points);
    for (int i = 0; i < 4; ++i)
    {
        points[i].dfGCPPixel = i % 2 * kCoverSide, points[i].dfGCPLine = i / 2 * kCoverSide;
        points[i].dfGCPX = kWest + i % 2 * 0.06 + i / 2 * 0.01, points[i].dfGCPY = kNorth - i / 2 * 0.06;
    }
    OGRSpatialReference geodetic;
    geodetic.SetWellKnownGeogCS("WGS84");
    ASSERT_EQ(dataset->SetGCPs(4, points, &geodetic), CE_None);
    GDALDeinitGCPs(4, points);
    GDALClose(dataset);
    const auto map = importCover(file, worldCoverTable(), alps());
    ASSERT_FALSE(map);
    EXPECT_THAT(map.error().message(), HasSubstr("is placed by control points, not as a grid"));
}

TEST_F(CoverImport, ErrorsNameTheFileAndWhatToDo)
{
    const auto messageOf = [](const foundation::Result<CoverMap>& map)
    { return map ? "" : map.error().message(); };
    EXPECT_THAT(messageOf(importCover("/none.tif", worldCoverTable(), alps())), HasSubstr("/none.tif"));
    EXPECT_THAT(messageOf(importCover(_file, {{5, GroundKind::crop}}, alps())),
                HasSubstr("has no class that its table knows: it has 10 and others"));
    const PlacedTile plane(testsupport::hills(33, 33), Placement::planar);
    EXPECT_THAT(messageOf(importCover(_file, worldCoverTable(), plane)),
                HasSubstr("no georeference to lay this"));
    auto elsewhere = testsupport::onTheEarth(testsupport::hills(33, 33));
    for (auto& node : elsewhere.net->nodes)
        node.longitudeDeg += 3.0;
    EXPECT_THAT(messageOf(importCover(_file, worldCoverTable(), PlacedTile(std::move(elsewhere)))),
                HasSubstr("covers nothing of the terrain"));
}

TEST_F(CoverImport, IsFoundAgainForTheSameRasterAndTable)
{
    const testsupport::TestFolder folder("kept-cover");
    const foundation::KeptFrom kept(std::make_shared<const foundation::KeptResults>(folder / "made"),
                                    foundation::ContentMark());
    const auto file = folder / "cover.tif"; // nothing beside it has its name
    std::filesystem::copy_file(_file, file);
    const auto read = importCover(file, worldCoverTable(), alps());
    ASSERT_TRUE(read);
    const auto isSame = [&]
    {
        const auto map = importCover(file, worldCoverTable(), alps(), kept);
        return map && map->width == read->width && map->height == read->height && map->kinds == read->kinds &&
               map->unknownCodes == read->unknownCodes;
    };
    EXPECT_TRUE(isSame());
    const auto files = testsupport::filesIn(folder / "made");
    EXPECT_EQ(files.size(), 1U);
    EXPECT_TRUE(isSame());
    EXPECT_EQ(testsupport::filesIn(folder / "made"), files);
    testsupport::writeNonsense(folder / "made");
    const auto nonsense = testsupport::filesIn(folder / "made");
    EXPECT_TRUE(isSame());
    EXPECT_NE(testsupport::filesIn(folder / "made"), nonsense);
    ASSERT_TRUE(importCover(file, {{10, GroundKind::crop}}, alps(), kept));
    EXPECT_EQ(testsupport::filesIn(folder / "made").size(), 2U);
}
