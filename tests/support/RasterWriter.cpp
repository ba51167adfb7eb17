// SPDX-License-Identifier: Apache-2.0
#include "RasterWriter.h"

#include <atomic>
#include <fstream>
#include <iterator>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>
#include <unistd.h>

TemporaryFolder::TemporaryFolder()
{
    static std::atomic<int> counter{0};
    _path = std::filesystem::temp_directory_path() /
            ("osgtrainer-dem-" + std::to_string(getpid()) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(_path);
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code code;
    std::filesystem::remove_all(_path, code);
}

std::array<double, 6> northUp3Seconds(int rows)
{
    constexpr double kStep = 3.0 / 3600.0;
    return {8.0 - 0.5 * kStep, kStep, 0.0, 46.0 + (rows - 0.5) * kStep, 0.0, -kStep};
}

namespace
{

std::vector<double> valuesOf(const RasterSpec& spec)
{
    if (!spec.values.empty()) return spec.values;
    const bool southUp = spec.geoTransform && (*spec.geoTransform)[5] > 0.0;
    std::vector<double> values;
    for (int r = 0; r < spec.rows; ++r)
        for (int c = 0; c < spec.columns; ++c)
            values.push_back(exampleHeight(c, southUp ? r : spec.rows - 1 - r));
    return values;
}

void setCrs(GDALDatasetH dataset, const RasterSpec& spec)
{
    if (spec.epsg == 0 && spec.crs.empty()) return;
    const OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
    if (spec.epsg != 0)
        ASSERT_EQ(OSRImportFromEPSG(crs, spec.epsg), OGRERR_NONE);
    else
        ASSERT_EQ(OSRSetFromUserInput(crs, spec.crs.c_str()), OGRERR_NONE);
    GDALSetSpatialRef(dataset, crs);
    OSRDestroySpatialReference(crs);
}

} // namespace

void writeRaster(const std::filesystem::path& file, const char* driver, const RasterSpec& spec)
{
    GDALAllRegister();
    CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO");
    const GDALDatasetH memory =
        GDALCreate(GDALGetDriverByName("MEM"), "", spec.columns, spec.rows, spec.bands, spec.type, nullptr);
    ASSERT_TRUE(memory);
    if (spec.geoTransform)
    {
        std::array<double, 6> transform = *spec.geoTransform;
        GDALSetGeoTransform(memory, transform.data());
    }
    setCrs(memory, spec);
    std::vector<double> values = valuesOf(spec);
    for (int b = 1; b <= spec.bands; ++b)
    {
        const GDALRasterBandH band = GDALGetRasterBand(memory, b);
        ASSERT_EQ(GDALRasterIO(band, GF_Write, 0, 0, spec.columns, spec.rows, values.data(), spec.columns,
                               spec.rows, GDT_Float64, 0, 0),
                  CE_None);
        if (spec.noData) GDALSetRasterNoDataValue(band, *spec.noData);
        if (!spec.unit.empty()) GDALSetRasterUnitType(band, spec.unit.c_str());
    }
    char** options = nullptr;
    for (const std::string& option : spec.options)
        options = CSLAddString(options, option.c_str());
    const GDALDatasetH written = GDALCreateCopy(GDALGetDriverByName(driver), file.string().c_str(), memory,
                                                FALSE, options, nullptr, nullptr);
    CSLDestroy(options);
    ASSERT_TRUE(written) << driver << " cannot write " << file;
    GDALClose(written);
    GDALClose(memory);
    CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes)
{
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string readBytes(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

namespace
{

void writeThroughGdal(const std::string& gdalPath, const std::string& bytes)
{
    VSILFILE* file = VSIFOpenL(gdalPath.c_str(), "wb");
    ASSERT_TRUE(file) << gdalPath;
    ASSERT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), file), bytes.size());
    VSIFCloseL(file);
}

} // namespace

void writeGzip(const std::filesystem::path& file, const std::string& bytes)
{
    writeThroughGdal("/vsigzip/" + file.string(), bytes);
}

void writeZip(const std::filesystem::path& file, const std::string& name, const std::string& bytes)
{
    writeThroughGdal("/vsizip/" + file.string() + "/" + name, bytes);
}

std::string hgtBytes()
{
    constexpr int kSide = 1201;
    std::string bytes;
    for (int r = kSide - 1; r >= 0; --r)
        for (int c = 0; c < kSide; ++c)
        {
            const int height = static_cast<int>(exampleHeight(c, r)) % 4000;
            bytes.push_back(static_cast<char>(height >> 8));
            bytes.push_back(static_cast<char>(height & 0xff));
        }
    return bytes;
}
