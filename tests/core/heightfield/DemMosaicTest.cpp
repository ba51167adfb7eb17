// SPDX-License-Identifier: Apache-2.0
// Rasters are cut out of one synthetic ground and joined again.
#include <cmath>
#include <limits>

#include <GeographicLib/UTMUPS.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "RasterWriter.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr double kFirstLongitude = 8.0, kFirstLatitude = 46.0, kStep = 3.0 / 3600.0;

/// Metres above the sea at coordinates in samples of 3".
double groundM(double column, double row)
{
    return 800.0 + 200.0 * std::sin(0.11 * column) * std::cos(0.07 * row) + 60.0 * std::sin(0.31 * row) +
           3.0 * std::cos(2.1 * column + 1.3 * row);
}

/// A piece of that ground.
struct Piece
{
    int west = 0, south = 0, columns = 2,
        rows = 2;  ///< size in its own samples; south-western corner in samples of 3"
    int every = 1; ///< samples of 3" between its own
    double raisedM = 0.0;
    double shift = 0.0; ///< in samples of 3", eastwards
    std::vector<std::pair<int, int>> voids{};

    void write(const std::filesystem::path& file) const
    {
        RasterSpec spec;
        spec.columns = columns;
        spec.rows = rows;
        spec.epsg = 4326;
        spec.noData = -9999.0;
        const double step = kStep * every;
        spec.geoTransform = {kFirstLongitude + kStep * (west + shift) - 0.5 * step, step, 0.0,
                             kFirstLatitude + kStep * south - 0.5 * step,           0.0,  step};
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c)
                spec.values.push_back(raisedM + groundM(west + shift + c * every, south + r * every));
        for (const auto& [c, r] : voids)
            spec.values[static_cast<std::size_t>(r * columns + c)] = -9999.0;
        writeRaster(file, "GTiff", spec);
    }
};

class DemMosaic : public testing::Test
{
protected:
    foundation::Result<HeightField> join(const std::vector<Piece>& pieces,
                                         const DemImportOptions& options = {})
    {
        std::vector<std::filesystem::path> files;
        for (const Piece& piece : pieces)
        {
            files.push_back(folder / ("piece" + std::to_string(files.size()) + ".tif"));
            piece.write(files.back());
        }
        return importDems(files, options);
    }

    TemporaryFolder folder;
};

float wantedM(int column, int row)
{
    return static_cast<float>(groundM(column, row));
}

TEST_F(DemMosaic, OfPiecesOfOneRasterIsThatRaster)
{
    const auto field = join({{0, 0, 31, 40}, {30, 0, 21, 20}, {30, 19, 21, 21}});
    ASSERT_TRUE(field) << field.error().message();
    ASSERT_EQ(field->columns, 51);
    ASSERT_EQ(field->rows, 40);
    EXPECT_TRUE(field->mask.hasAll());
    EXPECT_EQ(field->mosaic.rasters, 3);
    EXPECT_EQ(field->mosaic.bentSamples, 0u);
    for (int row = 0; row < field->rows; ++row)
        for (int column = 0; column < field->columns; ++column)
            ASSERT_EQ(field->heightM(column, row), wantedM(column, row)) << column << ", " << row;
    const auto whole = join({{0, 0, 51, 40}});
    const PlacedTile joined(*field), alone(*whole);
    EXPECT_LT(glm::distance(joined.position(50, 39), alone.position(50, 39)), 1e-6);
}

TEST_F(DemMosaic, KeepsTheFinestAndInterpolatesTheOthers)
{
    const auto field = join({{0, 0, 17, 21, 4}, {64, 0, 40, 81}});
    ASSERT_TRUE(field) << field.error().message();
    ASSERT_EQ(field->columns, 104);
    ASSERT_EQ(field->rows, 81);
    for (int row = 0; row < field->rows; ++row)
        for (int column = 64; column < field->columns; ++column)
            ASSERT_EQ(field->heightM(column, row), wantedM(column, row)) << column << ", " << row;
    // Beyond the seam's reach the coarse samples are as measured, and points between them are within the
    // range of their neighbours.
    for (int row = 0; row < field->rows; row += 4)
        for (int column = 0; column <= 64 - 16; column += 4)
            ASSERT_EQ(field->heightM(column, row), wantedM(column, row)) << column << ", " << row;
    EXPECT_GT(field->heightM(10, 11),
              std::min({wantedM(8, 8), wantedM(12, 8), wantedM(8, 12), wantedM(12, 12)}) - 0.01);
    EXPECT_LT(field->heightM(10, 11),
              std::max({wantedM(8, 8), wantedM(12, 8), wantedM(8, 12), wantedM(12, 12)}) + 0.01);
}

/// The largest difference between neighbours across the outline of a rectangle.
double largestStepM(const HeightField& field, int west, int south, int east, int north)
{
    double largest = 0.0;
    for (int row = south; row <= north; ++row)
    {
        largest =
            std::max<double>(largest, std::abs(field.heightM(west, row) - field.heightM(west - 1, row)));
        largest =
            std::max<double>(largest, std::abs(field.heightM(east, row) - field.heightM(east + 1, row)));
    }
    for (int column = west; column <= east; ++column)
    {
        largest = std::max<double>(largest,
                                   std::abs(field.heightM(column, south) - field.heightM(column, south - 1)));
        largest = std::max<double>(largest,
                                   std::abs(field.heightM(column, north) - field.heightM(column, north + 1)));
    }
    return largest;
}

TEST_F(DemMosaic, BendsCoarserDataTowardsFiner)
{
    const double smoothM = largestStepM(*join({{0, 0, 161, 161}}), 60, 60, 100, 100);
    const auto field = join({{0, 0, 41, 41, 4}, {60, 60, 41, 41, 1, 40.0}});
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_GT(field->mosaic.largestStepM, 30.0);
    EXPECT_LT(largestStepM(*field, 60, 60, 100, 100), smoothM + 40.0 / 6.0);
    for (int row = 60; row <= 100; ++row)
        for (int column = 60; column <= 100; ++column)
            ASSERT_EQ(field->heightM(column, row), static_cast<float>(groundM(column, row) + 40.0));
    // Mutation: a seam without bending makes the check above fail.
    HeightField unbent = *join({{0, 0, 161, 161}});
    for (int row = 60; row <= 100; ++row)
        for (int column = 60; column <= 100; ++column)
            unbent.heightsM[static_cast<std::size_t>(row) * 161 + static_cast<std::size_t>(column)] += 40.0f;
    EXPECT_GT(largestStepM(unbent, 60, 60, 100, 100), smoothM + 40.0 / 6.0);
}

TEST_F(DemMosaic, TakesTheFirstNamedOfEquals)
{
    const auto field = join({{10, 0, 30, 20, 1, 5.0}, {0, 0, 30, 20}});
    ASSERT_TRUE(field);
    EXPECT_EQ(field->heightM(20, 10), static_cast<float>(groundM(20, 10) + 5.0));
    EXPECT_EQ(field->heightM(0, 10), wantedM(0, 10));
}

TEST_F(DemMosaic, HasHolesWhereNoRasterReaches)
{
    const auto field = join({{0, 0, 41, 21}, {0, 20, 21, 21}});
    ASSERT_TRUE(field);
    ASSERT_EQ(field->rows, 41);
    for (int row = 0; row < 41; ++row)
        for (int column = 0; column < 41; ++column)
            ASSERT_EQ(field->mask.holds(column, row), row <= 20 || column <= 20) << column << ", " << row;
    EXPECT_TRUE(field->isComplete()); // holes have heights, too
    const PlacedTile tile(*field);
    const auto at = [&](double column, double row)
    {
        const glm::dvec3 p = tile.frame().positionAt(column, row, 0.0);
        return groundAt(tile, p.x, p.y).has_value();
    };
    EXPECT_TRUE(at(30.4, 15.2) && at(10.3, 35.5) && at(15.0, 15.0));
    EXPECT_FALSE(at(30.4, 30.5) || at(21.5, 20.5) || at(39.5, 39.5));
}

TEST_F(DemMosaic, BridgesWhatLiesBetweenPixelsThatMeet)
{
    // No shared column: pixels of 4 end at 42.5, where those of 1 begin.
    const Piece coarse{0, 0, 11, 11, 4, 0.0, 0.5};
    const auto field = join({coarse, {43, 0, 30, 41}});
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_TRUE(field->mask.hasAll());
    EXPECT_EQ(field->voids.count, 2u * 41u);
    for (int row = 0; row < 41; ++row) // counted from column 1 on
        EXPECT_NEAR(field->heightM(40, row), 0.5 * (field->heightM(39, row) + field->heightM(42, row)), 15.0);
    const auto apart = join({coarse, {44, 0, 30, 41}});
    EXPECT_FALSE(apart->mask.hasAll());
}

TEST_F(DemMosaic, FillsVoidsFromOtherRastersFirst)
{
    const Piece fine{0, 0, 40, 40, 1, 0.0, 0.0, {{20, 20}, {21, 20}, {5, 5}}};
    const auto field = join({fine, {16, 16, 4, 4, 4}});
    ASSERT_TRUE(field);
    EXPECT_EQ(field->voids.count, 1u);
    EXPECT_NEAR(field->heightM(20, 20), wantedM(20, 20), 8.0);
}

TEST_F(DemMosaic, KeepsVoidsAsHolesWhereWanted)
{
    Piece one{0, 0, 40, 40, 1, 0.0, 0.0, {{20, 20}, {21, 20}, {5, 5}}};
    DemImportOptions options;
    options.voids = Voids::keep;
    const auto field = join({one}, options);
    ASSERT_TRUE(field);
    EXPECT_EQ(field->voids.count, 0u);
    EXPECT_FALSE(field->mask.holds(20, 20) || field->mask.holds(21, 20) || field->mask.holds(5, 5));
    EXPECT_EQ(field->mask.countIn(20, 0, 39), 38);
    EXPECT_EQ(field->mask.countIn(20, 20, 20), 0);
    EXPECT_TRUE(join({one})->mask.hasAll());
}

TEST_F(DemMosaic, ResamplesWhatLiesBetweenItsPlaces)
{
    Piece between{30, 0, 30, 20};
    between.shift = 0.5;
    const auto field = join({{0, 0, 35, 20}, between});
    ASSERT_TRUE(field);
    ASSERT_EQ(field->columns, 60);
    EXPECT_EQ(field->heightM(20, 10), wantedM(20, 10));
    EXPECT_NEAR(field->heightM(50, 10), wantedM(50, 10), 1.0);
}

TEST_F(DemMosaic, JoinsDegreesAndMetres)
{
    Piece{0, 0, 61, 61, 4}.write(folder / "degrees.tif");
    RasterSpec spec; // UTM 32, whose central meridian is 9° E; a flat block: only its position matters
    spec.columns = spec.rows = 101;
    spec.epsg = 32632;
    spec.values.assign(101 * 101, 2000.0);
    spec.geoTransform = {430000.0, 30.0, 0.0, 5100000.0, 0.0, 30.0};
    writeRaster(folder / "metres.tif", "GTiff", spec);
    const std::vector<std::filesystem::path> files{folder / "degrees.tif", folder / "metres.tif"};
    const auto field = importDems(files);
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_NEAR(field->spacingNorthM, 30.0, 0.1);
    const PlacedTile tile(*field);
    const auto heightAt = [&](double latitude, double longitude)
    {
        const glm::dvec3 p = tile.frame().localFromGeodetic({latitude, longitude, 0.0});
        const auto ground = groundAt(tile, p.x, p.y);
        return ground ? tile.frame().heightOf(ground->position) : std::numeric_limits<double>::quiet_NaN();
    };
    double latitude = 0.0, longitude = 0.0; // of the block's middle; and a point far from it
    GeographicLib::UTMUPS::Reverse(32, true, 431515.0, 5101515.0, latitude, longitude);
    EXPECT_NEAR(heightAt(latitude, longitude), 2000.0, 0.01);
    const double column = 100.5, row = 200.25;
    EXPECT_NEAR(heightAt(kFirstLatitude + row * kStep, kFirstLongitude + column * kStep),
                groundM(column, row), 30.0);
}

TEST_F(DemMosaic, RefusesWhatCannotBeJoined)
{
    const auto messageOf =
        [&](const std::vector<std::filesystem::path>& files, const DemImportOptions& options = {})
    {
        const auto field = importDems(files, options);
        return field ? std::string("joined") : field.error().message();
    };
    Piece{0, 0, 20, 20}.write(folder / "one.tif");
    RasterSpec plain;
    writeRaster(folder / "plain.tif", "GTiff", plain);
    EXPECT_THAT(messageOf({folder / "one.tif", folder / "plain.tif"}),
                testing::AllOf(testing::HasSubstr("plain.tif"), testing::HasSubstr("no georeference"),
                               testing::HasSubstr("gdal_translate")));
    RasterSpec plane;
    plane.geoTransform = {1000.0, 10.0, 0.0, 1000.0, 0.0, 10.0};
    writeRaster(folder / "plane.tif", "GTiff", plane);
    EXPECT_THAT(messageOf({folder / "one.tif", folder / "plane.tif"}), testing::HasSubstr("plane"));
    RasterSpec ellipsoidal = plane;
    ellipsoidal.crs = "EPSG:4979";
    ellipsoidal.geoTransform = northUp3Seconds(4);
    writeRaster(folder / "ellipsoidal.tif", "GTiff", ellipsoidal);
    EXPECT_THAT(messageOf({folder / "one.tif", folder / "ellipsoidal.tif"}), testing::HasSubstr("ellipsoid"));
    RasterSpec tiny;
    tiny.epsg = 4326;
    tiny.geoTransform = {20.0, 1e-9, 0.0, 40.0, 0.0, 1e-9};
    writeRaster(folder / "tiny.tif", "GTiff", tiny);
    EXPECT_THAT(messageOf({folder / "one.tif", folder / "tiny.tif"}),
                testing::AllOf(testing::HasSubstr("nowhere near"), testing::HasSubstr("gdalinfo")));
    EXPECT_THAT(messageOf({folder / "one.tif", folder / "none.tif"}), testing::HasSubstr("none.tif"));
}

TEST_F(DemMosaic, CrossesTheDateLine)
{
    const auto write = [&](const char* name, double west)
    {
        RasterSpec spec;
        spec.columns = spec.rows = 21;
        spec.epsg = 4326;
        spec.values.assign(21 * 21, 7.0);
        spec.geoTransform = {west - 0.5 * kStep, kStep, 0.0, 10.0 - 0.5 * kStep, 0.0, kStep};
        writeRaster(folder / name, "GTiff", spec);
        return folder / name;
    };
    const std::vector<std::filesystem::path> files{write("west.tif", 180.0 - 20 * kStep),
                                                   write("east.tif", -180.0)};
    const auto field = importDems(files);
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_EQ(field->columns, 41);
    EXPECT_TRUE(field->mask.hasAll());
}

} // namespace
