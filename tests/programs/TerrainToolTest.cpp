// SPDX-License-Identifier: Apache-2.0
// The tables of terraintool, from the program itself.
#include "Playing.h"

namespace
{

using nlohmann::ordered_json;
using Keys = std::vector<std::string>;

/// Runs a command on files and returns the rows of its table.
ordered_json rowsOf(const Workplace& place, const Keys& arguments)
{
    Keys all = arguments;
    all.insert(all.end(), {"--json", place.path("table.json")});
    EXPECT_TRUE(succeeds(runTerrainTool(all)));
    const auto root = ordered_json::parse(readBytes(place.path("table.json")), nullptr, false);
    EXPECT_EQ(root.size(), 1U) << root;
    return root.value("files", ordered_json::array());
}

/// A field with two samples missing.
std::string withVoids(const Workplace& place)
{
    RasterSpec spec;
    spec.columns = 40;
    spec.rows = 30;
    spec.geoTransform = northUp3Seconds(spec.rows);
    spec.epsg = 4326;
    spec.noData = -9999.0;
    for (int i = 0; i < spec.columns * spec.rows; ++i)
        spec.values.push_back(i == 55 || i == 713 ? -9999.0 : 500.0 + i % 41);
    writeRaster(place.path("voids.tif"), "GTiff", spec);
    return place.path("voids.tif");
}

TEST(TerrainTool, InfoDescribesEachFile)
{
    const Workplace place;
    place.write("hill.roam", "dem = hill.tif\nplacement = planar\n");
    const ordered_json rows = rowsOf(place, {"info", withVoids(place), place.path("hill.roam")});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["file"], place.path("voids.tif"));
    EXPECT_EQ(rows[0]["samples"], 1200);
    EXPECT_EQ(rows[0]["voids"], 2);
    EXPECT_NEAR(rows[0]["voidShare"].get<double>(), 2.0 / 1200.0, 1e-6);
    EXPECT_NEAR(rows[0]["originLatitudeDeg"].get<double>(), 46.012, 0.001);
    EXPECT_EQ(rows[1]["file"], place.path("hill.roam"));
    EXPECT_EQ(rows[1]["samples"], 65 * 65);
    EXPECT_EQ(rows[1]["voids"], 0);
    EXPECT_EQ(rows[1]["tileSide"], 65);
}

TEST(TerrainTool, ValidateHasTheKeysThatWereAgreed)
{
    const Workplace place;
    const ordered_json rows = rowsOf(place, {"validate", withVoids(place), place.hill(), "--frames", "5"});
    ASSERT_EQ(rows.size(), 2U);
    for (const ordered_json& row : rows)
    {
        EXPECT_EQ(keysOf(row), (Keys{"file", "samples", "voids", "frames", "tJunctions", "cracks",
                                     "maxErrorPx", "tolerancePx", "ceilingExceeded"}));
        EXPECT_EQ(row["frames"], 5);
        EXPECT_EQ(row["tJunctions"], 0);
        EXPECT_EQ(row["cracks"], 0);
        EXPECT_EQ(row["ceilingExceeded"], 0);
        EXPECT_EQ(row["tolerancePx"], 1.0);
    }
    EXPECT_EQ(rows[0]["voids"], 2);
    const double hillPx = rows[1]["maxErrorPx"].get<double>();
    EXPECT_GT(hillPx, 0.05) << "nothing was simplified: nothing was checked";
    EXPECT_LE(hillPx, 1.0);
}

TEST(TerrainTool, ValidateReportsTheToleranceThatTheCeilingAllowed)
{
    const Workplace place;
    const ordered_json loose = rowsOf(place, {"validate", place.hill(), "--frames", "3", "--tolerance", "6"});
    EXPECT_EQ(loose[0]["tolerancePx"], 6.0);
    EXPECT_GT(loose[0]["maxErrorPx"], 1.0);
    const ordered_json few =
        rowsOf(place, {"validate", place.hill(), "--frames", "3", "--max-triangles", "60"});
    EXPECT_GT(few[0]["tolerancePx"], 1.0);
    EXPECT_LE(few[0]["maxErrorPx"], few[0]["tolerancePx"]);
    EXPECT_EQ(few[0]["ceilingExceeded"], 0);
}

TEST(TerrainTool, ValidateChecksPatches)
{
    const Workplace place;
    for (const std::string exponent : {"2", "6"})
    {
        const ordered_json row =
            rowsOf(place, {"validate", place.hill(), "--frames", "4", "--patch-exponent", exponent})[0];
        EXPECT_EQ(row["tJunctions"], 0);
        EXPECT_EQ(row["cracks"], 0);
        EXPECT_LE(row["maxErrorPx"], 1.0);
    }
    // The patches of a tile's two largest leaves, and so no error at all.
    const ordered_json whole = rowsOf(
        place, {"validate", place.hill(), "--frames", "2", "--tolerance", "9", "--patch-exponent", "10"});
    EXPECT_LT(whole[0]["maxErrorPx"], rowsOf(place, {"validate", place.hill(), "--frames", "2", "--tolerance",
                                                     "9"})[0]["maxErrorPx"]);
}

TEST(TerrainTool, WhatIsRefinedInSightHoldsTheToleranceInEveryFrame)
{
    const Workplace place;
    for (const char* method : {"roam", "roam-walk", "roam-queue", "vdpm"})
    {
        const auto row = rowsOf(
            place, {"validate", place.hill(), "--frames", "4", "--method", method, "--view-margin", "3"})[0];
        EXPECT_LE(row["maxErrorPx"], 1.0) << method;
        EXPECT_EQ(row["tJunctions"], 0) << method;
    }
    EXPECT_TRUE(
        failsWith(runTerrainTool({"validate", place.hill(), "--method", "vipm-locked", "--view-margin", "3"}),
                  1, "terraintool", {"vipm-locked refines all around"}));
}

TEST(TerrainTool, TablesAreTheSameTwice)
{
    const Workplace place;
    const ordered_json first = rowsOf(place, {"validate", place.hill(), "--frames", "3"});
    EXPECT_EQ(first, rowsOf(place, {"validate", place.hill(), "--frames", "3"}));
    EXPECT_NE(first, rowsOf(place, {"validate", place.writeHill("raised.tif", 50.0), "--frames", "3"}));
}

TEST(TerrainTool, ValidateFliesAScenario)
{
    const Workplace place;
    const std::string scenario = place.path("tour.xosc");
    ASSERT_TRUE(
        succeeds(runTrainer({"tour", place.hill(), "--size", "32x18", "--frames", "1", "--save", scenario})));
    const ordered_json rows = rowsOf(place, {"validate", scenario, place.hill(), "--frames", "480"});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["samples"], 65 * 65);
    EXPECT_EQ(rows[0]["frames"], 480) << "20 s at 24 a second";
    EXPECT_NEAR(rows[0]["maxErrorPx"].get<double>(), rows[1]["maxErrorPx"].get<double>(), 1e-3)
        << "the same tour";
    const ordered_json start = rowsOf(place, {"validate", scenario, "--frames", "2"});
    EXPECT_EQ(start[0]["frames"], 2);
}

TEST(TerrainTool, ValidateOpensTheRoadsThatATerrainNames)
{
    const Workplace place;
    place.hill();
    place.write("cut.xodr", "<OpenDRIVE><header");
    const std::string terrain = place.write("roads.roam", "dem = hill.tif\nroads = cut.xodr\n");
    EXPECT_TRUE(failsWith(runTerrainTool({"validate", terrain}), 1, "terraintool", {"cut.xodr"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"validate", terrain, "--patch-exponent", "4"}), 1, "terraintool",
                          {"leave out --patch-exponent"}));
}

TEST(TerrainTool, ValidateNamesAScenarioWithoutTerrain)
{
    const Workplace place;
    const std::string scenario = place.path("tour.xosc");
    ASSERT_TRUE(
        succeeds(runTrainer({"tour", place.hill(), "--size", "32x18", "--frames", "1", "--save", scenario})));
    std::string text = readBytes(scenario);
    const std::size_t begin = text.find("<SceneGraphFile");
    text.erase(begin, text.find("/>", begin) + 2 - begin);
    writeBytes(scenario, text);
    const ProgramRun run = runTerrainTool({"validate", scenario});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.errors.find("tour.xosc: RoadNetwork names no SceneGraphFile"), std::string::npos)
        << run.text();
}

TEST(TerrainTool, PrintsOneLineForEachFileItValidated)
{
    const Workplace place;
    const ProgramRun run = runTerrainTool({"validate", place.hill(), place.hill(), "--frames", "2"});
    EXPECT_TRUE(succeeds(run));
    const Keys lines = linesOf(run.output);
    ASSERT_EQ(lines.size(), 2U) << run.text();
    EXPECT_TRUE(lines[0].starts_with("sound  " + place.hill() + ": 2 frames, 0 T-junctions, 0 cracks"))
        << lines[0];
}

TEST(TerrainTool, TakesFilesOfAnyName)
{
    const Workplace place;
    const std::string latin1 = place.writeHill("h\xfcgel.tif", 0.0);
    const ordered_json rows = rowsOf(place, {"info", latin1});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_TRUE(
        rows[0]["file"].get<std::string>().ends_with("h\xef\xbf\xbdgel.tif")); // the replacement character
    EXPECT_EQ(rows[0]["samples"], 65 * 65);
}

TEST(TerrainTool, OneBadFileOfTwoLeavesNoTable)
{
    const Workplace place;
    const auto before = place.files();
    const ProgramRun run =
        runTerrainTool({"info", place.hill(), place.path("none.tif"), "--json", place.path("t.json")});
    EXPECT_TRUE(failsWith(run, 1, "terraintool", {"none.tif: no such file"}));
    EXPECT_EQ(place.files(), before);
}

} // namespace
