// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gdal.h>

/// A folder that is gone with the test.
class TemporaryFolder
{
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return _path / name; }
    const std::filesystem::path& path() const { return _path; }

private:
    std::filesystem::path _path;
};

/// What a test wants a raster file to be.
struct RasterSpec
{
    int columns = 5;
    int rows = 4;
    int bands = 1;
    GDALDataType type = GDT_Float32;
    std::vector<double> values; ///< in file order; empty: value(column, row) of exampleHeight
    std::optional<std::array<double, 6>> geoTransform;
    int epsg = 0;    ///< 0: none
    std::string crs; ///< or any text that GDAL understands
    std::optional<double> noData;
    std::string unit;
    std::vector<std::string> options;
};

/// A height that tells its place: row 0 is the southernmost.
inline double exampleHeight(int column, int row)
{
    return 10.0 + 3.0 * column + 17.0 * row;
}

/// Degrees, 3", north-up: the south-western sample at 46° N 8° E.
std::array<double, 6> northUp3Seconds(int rows);

/// Writes the raster with the named GDAL driver; fails the test if GDAL does.
void writeRaster(const std::filesystem::path& file, const char* driver, const RasterSpec& spec);

void writeBytes(const std::filesystem::path& file, const std::string& bytes);
std::string readBytes(const std::filesystem::path& file);

/// Packs bytes as the only content of a .gz, or as member `name` of a .zip.
void writeGzip(const std::filesystem::path& file, const std::string& bytes);
void writeZip(const std::filesystem::path& file, const std::string& name, const std::string& bytes);

/// A square .hgt of 1201² samples with exampleHeight modulo 4000 in it.
std::string hgtBytes();
