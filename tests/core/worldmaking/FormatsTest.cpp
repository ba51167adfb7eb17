// SPDX-License-Identifier: Apache-2.0
// Maps in the formats that ogr2ogr makes of OpenStreetMap data.
#include <fstream>
#include <map>
#include <string>

#include <cpl_conv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include "MadeMap.h"
#include "TestFolder.h"
#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/JoinLand.h"
#include "worldmaking/map/MapSources.h"
#include "worldmaking/map/ReadLand.h"

namespace
{

MadeMap smallTown()
{
    MadeMap map;
    const auto box = [&](double eastM, double northM, double sideM, const char* key, const char* value)
    {
        const int first = map.node(eastM, northM), b = map.node(eastM + sideM, northM),
                  c = map.node(eastM + sideM, northM + sideM), d = map.node(eastM, northM + sideM);
        map.way({first, b, c, d, first}, {{key, value}});
    };
    map.way({map.node(-300, 0), map.node(300, 0)},
            {{"highway", "residential"}, {"lanes", "2"}, {"oneway", "yes"}});
    map.way({map.node(0, 0), map.node(0, 200)},
            {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({map.node(-250, 270), map.node(250, 260)}, {{"power", "line"}, {"voltage", "110000"}});
    map.way({map.node(-250, 300), map.node(250, 300)}, {{"aeroway", "runway"}, {"ref", "09/27"}});
    box(-100, 60, 15, "building", "house");
    box(100, 100, 80, "natural", "water");
    box(-300, -300, 200, "landuse", "forest");
    return map;
}

/// Converts as `ogr2ogr -f FORMAT` does.
bool convert(const std::filesystem::path& from, const std::filesystem::path& to, const char* format)
{
    worldmaking::GdalScope errors;
    const worldmaking::DatasetPtr source(GDALDataset::Open(from.c_str(), GDAL_OF_VECTOR));
    if (!source) return false;
    const char* arguments[] = {"-f", format, "-skipfailures", nullptr};
    GDALVectorTranslateOptions* const options =
        GDALVectorTranslateOptionsNew(const_cast<char**>(arguments), nullptr);
    GDALDatasetH sources[] = {source.get()};
    int wrongUse = 0;
    const GDALDatasetH made = GDALVectorTranslate(to.c_str(), nullptr, 1, sources, options, &wrongUse);
    GDALVectorTranslateOptionsFree(options);
    if (made) GDALClose(made);
    return made && wrongUse == 0;
}

/// How many shapes have what a world is made of.
std::map<std::string, int> countsOf(const worldmaking::LandMap& map)
{
    std::map<std::string, int> counts;
    for (const auto& shape : map.shapes)
        for (const char* key : {"highway", "bridge", "oneway", "power", "voltage", "aeroway", "ref",
                                "building", "natural", "landuse"})
            if (const auto value = worldmaking::valueOf(shape.tags, key); !value.empty())
                ++counts[std::string(key) + "=" + std::string(value)];
    return counts;
}

/// All maps of a folder or archive as one.
worldmaking::LandMap wholeOf(const std::filesystem::path& given)
{
    worldmaking::LandMap whole;
    const auto sources = worldmaking::mapSourcesOf({given});
    EXPECT_TRUE(sources) << (sources ? "" : sources.error().message());
    EXPECT_GT(sources->size(), 1u);
    for (const auto& source : *sources)
    {
        EXPECT_FALSE(source.isOsm);
        auto land = worldmaking::readLand(source.file);
        EXPECT_TRUE(land) << (land ? "" : land.error().message());
        worldmaking::joinLand(whole, std::move(*land));
    }
    return whole;
}

} // namespace

TEST(Formats, AGeoPackageOfOgr2ogrHasWhatTheMapHad)
{
    const testsupport::TestFolder folder("formats");
    const auto osm = folder.write("town.osm", smallTown().text());
    const auto known = worldmaking::readLand(osm);
    ASSERT_TRUE(known) << known.error().message();
    EXPECT_EQ(countsOf(*known).size(), 11u);
    ASSERT_TRUE(convert(osm, folder / "town.gpkg", "GPKG"));
    const auto read = worldmaking::readLand(folder / "town.gpkg");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(countsOf(*read), countsOf(*known));
    EXPECT_EQ(worldmaking::streetsOf(*read).ways.size(), 2u);
}

TEST(Formats, WhatGdalWarnsOfIsTold)
{
    const testsupport::TestFolder folder("formats");
    const auto osm = folder.write("town.osm", smallTown().text());
    ASSERT_TRUE(convert(osm, folder / "town.gpkg", "GPKG"));
    EXPECT_TRUE(worldmaking::readLand(folder / "town.gpkg")->notes.empty());
    {
        std::fstream file(folder / "town.gpkg", std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(68); // the application's id of SQLite's header
        file.write("abcd", 4);
    }
    const auto read = worldmaking::readLand(folder / "town.gpkg");
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->notes.size(), 1u);
    EXPECT_NE(read->notes[0].find("town.gpkg: GDAL warns: "), std::string::npos) << read->notes[0];
}

TEST(Formats, AnArchiveOfManyShapefilesHasWhatTheFolderHad)
{
    const testsupport::TestFolder folder("formats");
    const auto osm = folder.write("town.osm", smallTown().text());
    const auto known = worldmaking::readLand(osm);
    ASSERT_TRUE(known);
    ASSERT_TRUE(convert(osm, folder / "town", "ESRI Shapefile"));
    // A table without shapes lies beside them, as in extracts.
    std::filesystem::copy_file(folder / "town/lines.dbf", folder / "town/table.dbf");
    EXPECT_EQ(countsOf(wholeOf(folder / "town")), countsOf(*known));
    EXPECT_EQ(worldmaking::streetsOf(wholeOf(folder / "town")).ways.size(), 2u);
    void* const zip = CPLCreateZip((folder / "town.shp.zip").c_str(), nullptr);
    for (const auto& entry : std::filesystem::directory_iterator(folder / "town"))
    {
        const std::string bytes = testsupport::bytesOf(entry.path());
        CPLCreateFileInZip(zip, ("shapes/" + entry.path().filename().string()).c_str(), nullptr);
        CPLWriteFileInZip(zip, bytes.data(), static_cast<int>(bytes.size()));
        CPLCloseFileInZip(zip);
    }
    CPLCloseZip(zip);
    EXPECT_EQ(countsOf(wholeOf(folder / "town.shp.zip")), countsOf(*known));
}

TEST(Formats, AFolderOfShapefilesHasWhatTheMapHad)
{
    const testsupport::TestFolder folder("formats");
    const auto osm = folder.write("town.osm", smallTown().text());
    const auto known = worldmaking::readLand(osm);
    ASSERT_TRUE(known);
    ASSERT_TRUE(convert(osm, folder / "town", "ESRI Shapefile"));
    const auto read = worldmaking::readLand(folder / "town");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(countsOf(*read), countsOf(*known));
    EXPECT_EQ(worldmaking::streetsOf(*read).ways.size(), 2u);
}
