// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterWriter.h"
#include "RealData.h"

namespace
{

using namespace osgTerrainROAM::core;

/// Facts about a file, measured with other tools.
struct Known
{
    const char* name;
    int columns, rows;
    std::size_t voids;
    float lowM, highM;
    double southDeg, westDeg; ///< of the south-western sample; both 0: a plane
    double spacingNorthM;
};

constexpr Known kKnown[] = {
    {"N44W072.hgt", 1201, 1201, 0, 115, 1908, 44, -72, 92.60},
    {"S33W071.tif", 1201, 1201, 0, 250, 6929, -33, -71, 92.41},
    {"N46E008.tif", 1201, 1201, 103743, 187, 4173, 46, 8, 92.63},
    {"N49W124.tif", 1201, 1201, 25620, -26, 2630, 49, -124, 92.68},
    {"N49W123.tif", 1201, 1201, 34926, -37, 2674, 49, -123, 92.68},
    {"mt_rainier_90m.tif", 1201, 1201, 9033, 263, 4371, 46, -122, 92.63},
    {"mt_fuji_90m.tif", 1201, 1201, 2437, -16, 3742, 35, 138, 92.46},
    {"N57E011.hgt", 1201, 1201, 0, -6, 163, 57, 11, 92.81},
    {"S46W066.hgt.gz", 3601, 3601, 0, -3, 146, -46, -66, 30.87},
    {"N10W110.hgt.zip", 1201, 1201, 0, 0, 9, 10, -110, 92.18},
    {"n43.dt0", 121, 121, 0, 75, 460, 43, -80, 925.85},
    {"srtmgl3_boulder.asc", 240, 144, 0, 1943, 3286, 40.0908333, -105.55, 92.53},
    {"bijou_gully_5m.asc", 105, 77, 0, 1673.07f, 1729.86f, 0, 0, 4.988744589},
    {"spearfish_dem.asc.gz", 634, 477, 10101, 1066, 1840, 0, 0, 30},
    {"gcanyon_elev_crop.bw.png", 1200, 1200, 0, 35, 187, 0, 0, 60},
    {"greenriver.tif", 2000, 1000, 0, 1297.29f, 1347.03f, 38.8827, -110.2967, 1.0},
};

DemImportOptions optionsFor(const Known& known)
{
    DemImportOptions options;
    if (std::strstr(known.name, ".png")) options.spacingM = 60.0;
    return options;
}

/// Compares a field with its facts. Returns the first difference; empty when there is none.
std::string deviation(const HeightField& field, const Known& known)
{
    if (!field.isComplete()) return "incomplete";
    if (field.columns != known.columns || field.rows != known.rows) return "size";
    if (field.voids.count != known.voids) return "voids " + std::to_string(field.voids.count);
    if (std::abs(field.voids.share - static_cast<double>(known.voids) / (known.columns * known.rows)) > 1e-12)
        return "share";
    const auto [low, high] = std::minmax_element(field.heightsM.begin(), field.heightsM.end());
    if (std::abs(*low - known.lowM) > 0.01f || std::abs(*high - known.highM) > 0.01f)
        return "range " + std::to_string(*low) + " to " + std::to_string(*high);
    if (std::abs(field.spacingNorthM - known.spacingNorthM) > 0.0005 * known.spacingNorthM) return "spacing";
    const bool planar = known.southDeg == 0.0 && known.westDeg == 0.0;
    if (planar != !field.net) return "georeference";
    if (planar) return {};
    const GeodeticNet::Node& node = field.net->node(0, 0);
    const double slack = known.name[0] == 'g' ? 2e-4 : 1e-6;
    if (std::abs(node.latitudeDeg - known.southDeg) > slack ||
        std::abs(node.longitudeDeg - known.westDeg) > slack)
        return "place " + std::to_string(node.latitudeDeg) + ", " + std::to_string(node.longitudeDeg);
    return node.geoidM == 0.0 ? "geoid" : "";
}

TEST(DemRealData, EveryFileHasItsKnownSizeVoidsRangeAndPlace)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    for (const Known& known : kKnown)
    {
        const auto field = importDem(folder / known.name, optionsFor(known));
        ASSERT_TRUE(field) << field.error().message();
        EXPECT_EQ(deviation(*field, known), "") << known.name;
    }
}

TEST(DemRealData, TheCheckNoticesOneVoidMoreOrOneHeightChanged)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    const Known& known = kKnown[0];
    const TemporaryFolder temporary;
    std::string bytes = readBytes(folder / known.name);
    ASSERT_EQ(bytes.size(), 2u * 1201u * 1201u);
    std::string pierced = bytes;
    pierced[123456] = static_cast<char>(0x80); // -32768, big-endian: SRTM's void
    pierced[123457] = 0;
    writeBytes(temporary / known.name, pierced);
    EXPECT_EQ(deviation(*importDem(temporary / known.name), known), "voids 1");

    std::string raised = bytes;
    raised[200000] = 0x0f; // 3840 m and more: above the highest
    writeBytes(temporary / known.name, raised);
    EXPECT_EQ(deviation(*importDem(temporary / known.name), known).substr(0, 5), "range");
}

TEST(DemRealData, HeightsAreTheFilesOwnAtSingleSamples)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    // Read from the bytes: big-endian, from the north-west.
    const std::string bytes = readBytes(folder / "N44W072.hgt");
    const auto field = importDem(folder / "N44W072.hgt");
    ASSERT_TRUE(field);
    for (int row = 0; row < 1201; ++row)
        for (int column = 0; column < 1201; ++column)
        {
            const std::size_t at =
                2 * (static_cast<std::size_t>(1200 - row) * 1201 + static_cast<std::size_t>(column));
            const int height =
                static_cast<signed char>(bytes[at]) * 256 + static_cast<unsigned char>(bytes[at + 1]);
            ASSERT_EQ(field->heightM(column, row), static_cast<float>(height)) << column << ", " << row;
        }
}

TEST(DemRealData, NeighbouringTilesShareTheirColumnOutsideVoids)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    const auto west = importDem(folder / "N49W124.tif");
    const auto east = importDem(folder / "N49W123.tif");
    ASSERT_TRUE(west && east);
    int different = 0;
    for (int row = 0; row < 1201; ++row)
        different += west->heightM(1200, row) != east->heightM(0, row);
    // Voids on the seam are filled from one side each.
    EXPECT_LT(different, 40);
}

TEST(DemRealData, TwoImportsAreBitIdentical)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    for (const char* name : {"N46E008.tif", "spearfish_dem.asc.gz", "greenriver.tif"})
    {
        const auto first = importDem(folder / name), second = importDem(folder / name);
        ASSERT_TRUE(first && second);
        EXPECT_EQ(std::memcmp(first->heightsM.data(), second->heightsM.data(), 4 * first->heightsM.size()), 0)
            << name;
        if (!first->net) continue;
        ASSERT_EQ(first->net->nodes.size(), second->net->nodes.size());
        EXPECT_EQ(std::memcmp(first->net->nodes.data(), second->net->nodes.data(),
                              sizeof(GeodeticNet::Node) * first->net->nodes.size()),
                  0)
            << name;
    }
}

std::map<std::string, std::pair<std::uintmax_t, std::filesystem::file_time_type>>
listing(const std::filesystem::path& folder)
{
    std::map<std::string, std::pair<std::uintmax_t, std::filesystem::file_time_type>> entries;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            entries[entry.path().string()] = {entry.file_size(), entry.last_write_time()};
    return entries;
}

TEST(DemRealData, NothingIsWrittenBesideTheInputs)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    // A writable copy, because a read-only folder would hide an attempt to write.
    const TemporaryFolder copy;
    for (const Known& known : kKnown)
        std::filesystem::copy_file(folder / known.name, copy / known.name);
    const auto before = listing(copy.path());
    for (const Known& known : kKnown)
        EXPECT_TRUE(importDem(copy / known.name, optionsFor(known))) << known.name;
    EXPECT_EQ(listing(copy.path()), before);
}

TEST(DemRealData, OtherFilesOfTheFolderAreRefusedInOneLine)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    for (const char* name : {"README.md", "quantized-mesh/tile.terrain", "quantized-mesh"})
    {
        const auto field = importDem(folder / name);
        ASSERT_FALSE(field) << name;
        EXPECT_EQ(field.error().message().find('\n'), std::string::npos);
    }
}

} // namespace
