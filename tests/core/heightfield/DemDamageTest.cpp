// SPDX-License-Identifier: Apache-2.0
// Truncated files and files with changed bytes: an import must end in an error or in a complete field, never
// in a crash, and a truncated file must not be accepted as complete.
#include <random>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterWriter.h"

namespace
{

using namespace osgTerrainROAM::core;

struct Sample
{
    std::string name;
    std::string bytes;
    bool isText = false;
};

/// One small file of each format.
std::vector<Sample> samples(const TemporaryFolder& folder)
{
    std::vector<Sample> all;
    const auto add =
        [&](const std::string& name, const char* driver, const RasterSpec& spec, bool isText = false)
    {
        writeRaster(folder / name, driver, spec);
        all.push_back({name, readBytes(folder / name), isText});
    };
    RasterSpec spec;
    spec.columns = 24;
    spec.rows = 20;
    spec.geoTransform = northUp3Seconds(spec.rows);
    spec.epsg = 4326;
    add("plain.tif", "GTiff", spec);
    spec.options = {"COMPRESS=LZW", "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"};
    add("tiled.tif", "GTiff", spec);
    spec.options = {"COMPRESS=DEFLATE"};
    spec.type = GDT_Int16;
    spec.noData = 61.0;
    add("deflate.tif", "GTiff", spec);
    spec.options.clear();
    add("grid.asc", "AAIGrid", spec, true);
    spec.type = GDT_Byte;
    spec.noData.reset();
    add("picture.png", "PNG", spec);
    spec.type = GDT_Int16;
    constexpr double kStep = 30.0 / 3600.0;
    spec.columns = spec.rows = 121;
    spec.geoTransform = {8.0 - 0.5 * kStep, kStep, 0.0, 47.0 + 0.5 * kStep, 0.0, -kStep};
    add("n46.dt0", "DTED", spec);
    all.push_back({"grass.asc",
                   "north: 4000120\nsouth: 4000000\neast: 500090\nwest: 500000\nrows: 4\ncols: 3\n"
                   "61 64 67\n44 0 50\n27 * 33\n10 13 16\n",
                   true});
    writeBytes(folder / "grass.asc", all.back().bytes);
    writeGzip(folder / "packed.asc.gz", all.back().bytes);
    all.push_back({"packed.asc.gz", readBytes(folder / "packed.asc.gz"), false});
    writeZip(folder / "packed.zip", "grass.asc", all.back().bytes);
    return all;
}

foundation::Result<HeightField> importBytes(const TemporaryFolder& folder, const std::string& name,
                                            const std::string& bytes)
{
    DemImportOptions options;
    options.spacingM = 10.0;
    writeBytes(folder / name, bytes);
    auto field = importDem(folder / name, options);
    if (field)
        EXPECT_TRUE(field->isComplete()) << name;
    else
        EXPECT_EQ(field.error().message().find('\n'), std::string::npos);
    return field;
}

TEST(DemDamage, AFileCutShortIsRefusedOrWhole)
{
    const TemporaryFolder folder;
    for (const Sample& sample : samples(folder))
    {
        const auto whole = importBytes(folder, sample.name, sample.bytes);
        ASSERT_TRUE(whole) << whole.error().message();
        std::mt19937 random(17);
        int refused = 0;
        for (int i = 0; i < 60; ++i)
        {
            const std::size_t length = i < 20 ? sample.bytes.size() - 1 - static_cast<std::size_t>(i)
                                              : random() % sample.bytes.size();
            const auto cut = importBytes(folder, sample.name, sample.bytes.substr(0, length));
            refused += !cut;
            if (!cut) continue;
            ASSERT_EQ(cut->heightsM.size(), whole->heightsM.size()) << sample.name << " cut to " << length;
            std::size_t different = 0;
            for (std::size_t k = 0; k < cut->heightsM.size(); ++k)
                different += cut->heightsM[k] != whole->heightsM[k];
            // Text can lose digits of its last number without a trace (16 becomes 1), and a void beside that
            // number is filled from it.
            EXPECT_LE(different, sample.isText ? 2u : 0u) << sample.name << " cut to " << length;
        }
        EXPECT_GE(refused, 40) << sample.name;
    }
}

TEST(DemDamage, ATruncatedSrtmFileIsRefused)
{
    const TemporaryFolder folder;
    const std::string bytes = hgtBytes();
    for (const std::size_t missing : {std::size_t{1}, std::size_t{2402}, bytes.size() / 2, bytes.size() - 1})
        EXPECT_FALSE(importBytes(folder, "N46E008.hgt", bytes.substr(0, bytes.size() - missing))) << missing;
    writeGzip(folder / "N46E009.hgt.gz", bytes);
    const std::string packed = readBytes(folder / "N46E009.hgt.gz");
    for (const std::size_t missing :
         {std::size_t{9}, std::size_t{100}, packed.size() / 2, packed.size() - 30})
        EXPECT_FALSE(importBytes(folder, "N46E010.hgt.gz", packed.substr(0, packed.size() - missing)))
            << missing;
    writeZip(folder / "N46E009.hgt.zip", "N46E009.hgt", bytes);
    const std::string zipped = readBytes(folder / "N46E009.hgt.zip");
    for (const std::size_t missing : {std::size_t{30}, std::size_t{100}, zipped.size() / 2})
        EXPECT_FALSE(importBytes(folder, "N46E010.hgt.zip", zipped.substr(0, zipped.size() - missing)))
            << missing;
}

TEST(DemDamage, ACompleteDtedWithWholeProfilesMissingIsRefused)
{
    const TemporaryFolder folder;
    std::string bytes;
    for (const Sample& sample : samples(folder))
        if (sample.name == "n46.dt0") bytes = sample.bytes;
    constexpr std::size_t kProfile = 12 + 2 * 121;
    ASSERT_EQ(bytes.size(), 3428 + 121 * kProfile);
    for (const std::size_t missing : {1u, 18u, 100u})
        EXPECT_FALSE(importBytes(folder, "n46.dt0", bytes.substr(0, bytes.size() - missing * kProfile)));
}

TEST(DemDamage, ChangedBytesNeverCrash)
{
    const TemporaryFolder folder;
    std::mt19937 random(23);
    for (const Sample& sample : samples(folder))
        for (int i = 0; i < 150; ++i)
        {
            std::string bytes = sample.bytes;
            const int changes = 1 + static_cast<int>(random() % 8);
            // Half of the changes fall into the first 256 bytes, the headers.
            for (int k = 0; k < changes; ++k)
            {
                const std::size_t range =
                    random() % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 256);
                bytes[random() % range] = static_cast<char>(random() % 256);
            }
            (void)importBytes(folder, sample.name, bytes);
        }
}

} // namespace
