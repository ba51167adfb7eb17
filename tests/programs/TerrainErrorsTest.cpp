// SPDX-License-Identifier: Apache-2.0
// Terrain that cannot be used: exit code 1, one line that names the file, and no result of any kind left
// behind.
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

struct BadTerrain
{
    const char* name;
    std::string (*make)(const Workplace&); ///< writes it and returns its path
    std::vector<std::string> words;        ///< of the line, besides the path
};

std::string cutTo(const Workplace& place, const std::string& name, const std::string& whole, double share)
{
    return place.write(name,
                       whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
}

std::string threeBands(const Workplace& place)
{
    RasterSpec spec;
    spec.bands = 3;
    spec.geoTransform = northUp3Seconds(spec.rows);
    spec.epsg = 4326;
    writeRaster(place.path("colour.tif"), "GTiff", spec);
    return place.path("colour.tif");
}

std::string withoutGeoreference(const Workplace& place)
{
    RasterSpec spec;
    spec.columns = spec.rows = 33;
    writeRaster(place.path("plain.tif"), "GTiff", spec);
    return place.path("plain.tif");
}

class TerrainErrors : public testing::TestWithParam<BadTerrain>
{
};

TEST_P(TerrainErrors, AreOneLineThatNamesTheFile)
{
    const Workplace place;
    const std::string terrain = GetParam().make(place);
    std::vector<std::string> words = GetParam().words;
    const bool hasOddName = terrain.find('\n') != std::string::npos || terrain.size() > 255;
    if (!hasOddName) words.push_back(terrain);
    const auto before = place.files();

    const std::vector<std::string> tour{"tour",      terrain,
                                        "--capture", place.path("frames"),
                                        "--size",    "64x36",
                                        "--save",    place.path("tour.xosc"),
                                        "--stats",   place.path("s.json"),
                                        "--report",  place.path("r.html")};
    EXPECT_TRUE(failsWith(runTrainer(tour), 1, "trainer", words));
    for (const char* command : {"info", "validate"})
    {
        const std::string json = place.path("table.json");
        EXPECT_TRUE(failsWith(runTerrainTool({command, terrain, "--json", json}), 1, "terraintool", words))
            << command;
    }
    EXPECT_EQ(place.files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Table, TerrainErrors,
    testing::Values(
        BadTerrain{
            "Missing", [](const Workplace& place) { return place.path("none.tif"); }, {"no such file; "}},
        BadTerrain{"TruncatedTiff",
                   [](const Workplace& place)
                   { return cutTo(place, "cut.tif", readBytes(place.hill()), 0.6); },
                   {"row ", "truncated or damaged"}},
        BadTerrain{"TruncatedHgt",
                   [](const Workplace& place) { return cutTo(place, "N46E008.hgt", hgtBytes(), 0.5); },
                   {"N46E008.hgt", "fetch it again"}},
        BadTerrain{"NoRaster",
                   [](const Workplace& place) { return place.write("notes.tif", "heights to come\n"); },
                   {"in no format that GDAL reads"}},
        BadTerrain{
            "Empty", [](const Workplace& place) { return place.write("empty.tif", ""); }, {"no format"}},
        BadTerrain{"Folder", [](const Workplace& place) { return place.path(""); }, {"is a folder"}},
        BadTerrain{"ThreeBands", threeBands, {"has 3 bands where elevation has one", "gdal_translate -b 1"}},
        BadTerrain{"NoGeoreference", withoutGeoreference, {"has no georeference", "--spacing METRES"}},
        BadTerrain{
            "LongName", [](const Workplace&) { return std::string(5000, 'x') + ".tif"; }, {"no such file"}},
        BadTerrain{"NameOfTwoLines",
                   [](const Workplace&) { return std::string("two\nlines.tif"); },
                   {"two?lines.tif"}},
        BadTerrain{"RoamNamesNothing",
                   [](const Workplace& place)
                   { return place.write("a.roam", "# nothing\n\ndem = none.tif\n"); },
                   {"a.roam:3: ", "none.tif", "does not exist"}},
        BadTerrain{"RoamOfAnUnknownKey",
                   [](const Workplace& place)
                   { return place.write("b.roam", "dem = hill.tif\nmountains = high\n"); },
                   {"b.roam:2: ", "unknown key 'mountains'"}},
        BadTerrain{"RoamOfAnOverlongLine",
                   [](const Workplace& place)
                   { return place.write("c.roam", "dem = hill.tif\n" + std::string(26000, 'x') + " = 1\n"); },
                   {"c.roam:2: ", "unknown key 'xxx", "bytes left out"}},
        BadTerrain{"RoamOfAnOverlongPath",
                   [](const Workplace& place)
                   { return place.write("d.roam", "dem = " + std::string(26000, 'x') + "\n"); },
                   {"d.roam:1: dem '", "bytes left out", "does not exist"}}),
    [](const testing::TestParamInfo<BadTerrain>& test) { return std::string(test.param.name); });

TEST(TerrainErrors, GoAwayWithWhatTheRemedySays)
{
    const Workplace place;
    EXPECT_TRUE(succeeds(runTerrainTool({"info", place.hill()})));
    EXPECT_TRUE(succeeds(runTerrainTool({"info", withoutGeoreference(place), "--spacing", "10"})));
    place.write("good.roam", "dem = hill.tif\n");
    EXPECT_TRUE(succeeds(runTerrainTool({"info", place.path("good.roam")})));
}

} // namespace
