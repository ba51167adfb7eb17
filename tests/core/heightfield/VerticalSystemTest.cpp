// SPDX-License-Identifier: Apache-2.0
// What heights count from, as reference systems with a vertical part say. Public reports of the kind: GDAL
// 13920 and 1946, PROJ 2936 and 3323 (grids that are not there, silently), cesium-terrain-builder 22 and 94
// (terrain tens of metres off).
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterWriter.h"

namespace
{

using namespace osgTerrainROAM::core;
using testing::HasSubstr;
using testing::IsEmpty;

/// Five samples by four of 1000 units, at 46° N 8° E, or at 500 km east and 4000 km north of a projected
/// system.
std::filesystem::path rasterOf(const TemporaryFolder& folder, const std::string& crs, bool projected = false)
{
    RasterSpec spec;
    spec.values.assign(20, 1000.0);
    spec.crs = crs;
    if (projected)
        spec.geoTransform = {500000.0, 10.0, 0.0, 4000000.0, 0.0, -10.0};
    else
        spec.geoTransform = northUp3Seconds(spec.rows);
    std::string name = crs + ".tif";
    std::replace(name.begin(), name.end(), ':', '-');
    writeRaster(folder / name, "GTiff", spec);
    return folder / name;
}

/// While it lives PROJ has a grid for EGM2008, which lies at `heightM` over the ellipsoid everywhere within
/// 1° of 46.5° N 8.5° E.
class GridOfEgm2008
{
public:
    GridOfEgm2008(const TemporaryFolder& folder, float heightM)
    {
        const std::array<double, 4> corner{45.5, 7.5, 0.5, 0.5};
        const std::array<std::int32_t, 2> size{5, 5};
        std::string bytes;
        append(bytes, corner);
        append(bytes, size);
        append(bytes, std::vector<float>(25, heightM));
        writeBytes(folder / "egm08_25.gtx", bytes);
        _former = OSRGetPROJSearchPaths();
        char** paths = CSLAddString(CSLDuplicate(_former), folder.path().c_str());
        OSRSetPROJSearchPaths(paths);
        CSLDestroy(paths);
    }
    ~GridOfEgm2008()
    {
        OSRSetPROJSearchPaths(_former);
        CSLDestroy(_former);
    }
    GridOfEgm2008(const GridOfEgm2008&) = delete;
    GridOfEgm2008& operator=(const GridOfEgm2008&) = delete;

private:
    /// Numbers of a .gtx have their highest byte first.
    template<class Numbers>
    static void append(std::string& bytes, const Numbers& numbers)
    {
        for (const auto& number : numbers)
        {
            std::array<char, sizeof number> raw{};
            std::memcpy(raw.data(), &number, sizeof number);
            bytes.append(raw.rbegin(), raw.rend());
        }
    }

    char** _former = nullptr;
};

TEST(VerticalSystem, WhatHasNoGridCountsFromEgm96AndIsTold)
{
    const TemporaryFolder folder;
    struct Case
    {
        const char* crs;
        bool isProjected;
        const char* name;
        const char* code;
    };
    const double egm96 = importDem(rasterOf(folder, "EPSG:4326"))->net->node(0, 0).geoidM;
    for (const Case& c : {Case{"EPSG:4326+5703", false, "NAVD88 height", "EPSG:4326+5703"},
                          Case{"EPSG:4326+3855", false, "EGM2008 height", "EPSG:4326+3855"},
                          Case{"EPSG:26910+5703", true, "NAVD88 height", "EPSG:4326+5703"},
                          Case{"EPSG:25832+7837", true, "DHHN2016 height", "EPSG:4326+7837"},
                          Case{"EPSG:4258+5730", false, "EVRF2000 height", "EPSG:4326+5730"},
                          Case{"EPSG:4326+5709", false, "NAP height", "EPSG:4326+5709"}})
    {
        const auto field = importDem(rasterOf(folder, c.crs, c.isProjected));
        ASSERT_TRUE(field) << field.error().message();
        ASSERT_EQ(field->notes.size(), 1u) << c.crs;
        EXPECT_THAT(field->notes[0],
                    HasSubstr(std::string("heights above ") + c.name + " are taken as above EGM96"));
        EXPECT_THAT(field->notes[0], HasSubstr(c.code));
        if (c.isProjected) continue; // it lies elsewhere
        EXPECT_NEAR(field->net->node(0, 0).geoidM, egm96, 0.01) << c.crs;
    }
}

TEST(VerticalSystem, Egm96AndPlainSeaLevelAreNotTold)
{
    const TemporaryFolder folder;
    for (const char* crs : {"EPSG:4326", "EPSG:4326+5773", "EPSG:4326+5714"})
    {
        const auto field = importDem(rasterOf(folder, crs));
        ASSERT_TRUE(field) << field.error().message();
        EXPECT_THAT(field->notes, IsEmpty()) << crs;
        EXPECT_GT(field->net->node(0, 0).geoidM, 45.0);
    }
}

TEST(VerticalSystem, AGridThatProjFindsIsUsed)
{
    const TemporaryFolder folder;
    const auto file = rasterOf(folder, "EPSG:4326+3855");
    const GridOfEgm2008 grid(folder, 77.25f);
    // On a thread of its own: on each, PROJ remembers which grids are not there.
    std::thread(
        [&]
        {
            const auto field = importDem(file);
            ASSERT_TRUE(field) << field.error().message();
            EXPECT_THAT(field->notes, IsEmpty());
            EXPECT_NEAR(field->net->node(0, 0).geoidM, 77.25, 1e-6);
            DemImportOptions said;
            said.verticalDatum = VerticalDatum::egm96; // the user knows better
            EXPECT_GT(std::abs(importDem(file, said)->net->node(0, 0).geoidM - 77.25), 20.0);
        })
        .join();
}

TEST(VerticalSystem, TheUnitOfTheVerticalAxisCountsWhereTheBandNamesNone)
{
    const TemporaryFolder folder;
    EXPECT_NEAR(importDem(rasterOf(folder, "EPSG:4326+6360"))->heightM(2, 2), 1000.0 * 1200.0 / 3937.0, 1e-3);
    EXPECT_NEAR(importDem(rasterOf(folder, "EPSG:4326+8228"))->heightM(2, 2), 304.8, 1e-3);
    RasterSpec spec;
    spec.values.assign(20, 100.0);
    spec.geoTransform = northUp3Seconds(spec.rows);
    spec.epsg = 4326;
    const auto withUnit = [&](const char* unit)
    {
        spec.unit = unit;
        writeRaster(folder / "unit.tif", "GTiff", spec);
        return importDem(folder / "unit.tif");
    };
    EXPECT_FLOAT_EQ(withUnit("fathom")->heightM(1, 1), 182.88f);
    EXPECT_FLOAT_EQ(withUnit("dm")->heightM(1, 1), 10.0f);
    EXPECT_FLOAT_EQ(withUnit("Meters")->heightM(1, 1), 100.0f);
    EXPECT_THAT(withUnit("Meters")->notes, IsEmpty());
    const auto strange = withUnit("cubit");
    EXPECT_FLOAT_EQ(strange->heightM(1, 1), 100.0f);
    ASSERT_EQ(strange->notes.size(), 1u);
    EXPECT_THAT(strange->notes[0], HasSubstr("'cubit', a unit that is not known"));
}

TEST(VerticalSystem, DepthsAreNegativeHeights)
{
    const TemporaryFolder folder;
    const auto field = importDem(rasterOf(folder, "EPSG:4326+5715")); // MSL depth
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_FLOAT_EQ(field->heightM(2, 2), -1000.0f);
    ASSERT_FALSE(field->notes.empty());
    EXPECT_THAT(field->notes[0], HasSubstr("counts depths downwards"));
}

TEST(VerticalSystem, FilesOfDifferentSystemsAreJoinedAndTold)
{
    const TemporaryFolder folder;
    std::vector<std::filesystem::path> files{rasterOf(folder, "EPSG:4326+5773")};
    EXPECT_THAT(importDems(std::vector{files[0], files[0]})->notes, IsEmpty());
    files.push_back(rasterOf(folder, "EPSG:4326+5709"));
    const auto joined = importDems(files);
    ASSERT_TRUE(joined) << joined.error().message();
    EXPECT_THAT(joined->notes, testing::Contains(HasSubstr(
                                   "count from NAP height, those of files before it from EGM96 height")));
}

} // namespace
