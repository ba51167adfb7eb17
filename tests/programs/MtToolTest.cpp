// SPDX-License-Identifier: Apache-2.0
// terraintool mt-build and validate of its files, from the program itself.
#include <filesystem>
#include <fstream>

#include "Playing.h"

namespace
{

using nlohmann::ordered_json;

std::vector<std::string> building(const Workplace& place, const std::string& output)
{
    return {"mt-build", place.hill(), "-o", place.path(output), "--trees", "5"};
}

TEST(MtTool, buildsAFileThatValidateFindsSound)
{
    const Workplace place;
    std::vector<std::string> build = building(place, "hill.mt");
    build.insert(build.end(), {"--json", place.path("built.json")});
    EXPECT_TRUE(succeeds(runTerrainTool(build)));
    const auto built = ordered_json::parse(readBytes(place.path("built.json")))["files"][0];
    EXPECT_EQ(keysOf(built),
              (std::vector<std::string>{"file", "points", "triangles", "trees", "rectangles", "largestTree",
                                        "smallestTree", "mainPart", "borderPoints", "fileBytes", "peakMB"}));
    EXPECT_EQ(built["points"], 65 * 65);
    EXPECT_FALSE(std::filesystem::exists(place.path("hill.mt.parts")));
    EXPECT_TRUE(succeeds(runTerrainTool(
        {"validate", place.path("hill.mt"), "--frames", "12", "--json", place.path("found.json")})));
    const auto found = ordered_json::parse(readBytes(place.path("found.json")))["files"][0];
    EXPECT_EQ(keysOf(found),
              (std::vector<std::string>{"file", "points", "trees", "wholeTrees", "frames", "measuredFrames",
                                        "mostTriangles", "worstExcessM", "faults"}));
    EXPECT_EQ(found["frames"], 12);
    EXPECT_EQ(found["faults"].size(), 0U);
}

TEST(MtTool, extractsTrianglesThatBuildTheSameAgain)
{
    const Workplace place;
    ASSERT_TRUE(succeeds(runTerrainTool(building(place, "hill.mt"))));
    EXPECT_TRUE(succeeds(runTerrainTool({"mt-extract", place.path("hill.mt"), "-o", place.path("t.ply"),
                                         "--triangles", "500", "--json", place.path("t.json")})));
    const auto taken = ordered_json::parse(readBytes(place.path("t.json")))["files"][0];
    EXPECT_EQ(keysOf(taken),
              (std::vector<std::string>{"file", "points", "triangles", "errorM", "trees", "ofTrees"}));
    EXPECT_LE(taken["triangles"], 500);
    EXPECT_TRUE(succeeds(runTerrainTool({"mt-build", place.path("t.ply"), "-o", place.path("t.mt")})));
    EXPECT_TRUE(succeeds(runTerrainTool({"info", place.path("t.mt"), "--json", place.path("i.json")})));
    const auto told = ordered_json::parse(readBytes(place.path("i.json")))["files"][0];
    EXPECT_EQ(told["points"], taken["points"]);
    EXPECT_EQ(told["triangles"], taken["triangles"]);
    EXPECT_EQ(told["version"], 2);
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-extract", place.path("hill.mt"), "-o", place.path("t.stl")}), 2,
                          "terraintool", {".obj"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"info", place.path("t.ply.mt")}), 1, "terraintool", {"t.ply.mt"}));
}

/// A row of the table of `info`.
ordered_json infoOf(const Workplace& place, const std::string& file)
{
    const std::string table = place.path("info.json");
    EXPECT_TRUE(succeeds(runTerrainTool({"info", place.path(file), "--json", table})));
    return ordered_json::parse(readBytes(table))["files"][0];
}

TEST(MtTool, keepsTheGeoreferenceWithAndWithoutALimitOfMemory)
{
    const Workplace place;
    ASSERT_TRUE(succeeds(runTerrainTool(building(place, "hill.mt"))));
    std::vector<std::string> within = building(place, "within.mt");
    within.insert(within.end(), {"--memory", "200"});
    ASSERT_TRUE(succeeds(runTerrainTool(within)));
    for (const char* name : {"hill.mt", "within.mt"})
    {
        const ordered_json told = infoOf(place, name);
        EXPECT_EQ(told["version"], 3);
        EXPECT_EQ(told["system"], "WGS 84 / UTM zone 32N");
        EXPECT_NEAR(told["west"].get<double>(), 436015.0, 1e-6) << "centres of pixels";
        EXPECT_NEAR(told["east"].get<double>(), 437935.0, 1e-6);
        EXPECT_NEAR(told["north"].get<double>(), 4829935.0, 1e-6);
        EXPECT_NEAR(told["south"].get<double>(), 4828015.0, 1e-6);
    }
    EXPECT_TRUE(succeeds(
        runTerrainTool({"mt-extract", place.path("hill.mt"), "-o", place.path("t.obj"), "--error", "1",
                        "--places", "georeference", "--region", "436500,4828500,437000,4829000"})));
    const std::string obj = readBytes(place.path("t.obj"));
    EXPECT_TRUE(obj.starts_with("# reference system: WGS 84 / UTM zone 32N\n")) << obj.substr(0, 200);
    EXPECT_NE(obj.find("v 436015 4828015 "), std::string::npos) << "the south-western corner";
    place.write("points.xyz", "0 0 1\n9 0 2\n0 9 3\n9 9 4\n");
    ASSERT_TRUE(succeeds(runTerrainTool({"mt-build", place.path("points.xyz"), "-o", place.path("p.mt")})));
    EXPECT_TRUE(infoOf(place, "p.mt")["system"].is_null());
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-extract", place.path("p.mt"), "-o", place.path("p.obj"),
                                          "--places", "georeference"}),
                          1, "terraintool", {"p.mt", "no georeference"}));
}

TEST(MtTool, writesTilesOfTheEarthOutOfSurfacesInDegrees)
{
    const Workplace place;
    ASSERT_TRUE(succeeds(runTerrainTool(building(place, "hill.mt"))));
    const auto extract = [&](std::vector<std::string> more)
    {
        more.insert(more.begin(), {"mt-extract", place.path("hill.mt")});
        return runTerrainTool(more);
    };
    const std::string tile = place.path("t.terrain");
    EXPECT_TRUE(failsWith(extract({"-o", tile}), 1, "terraintool", {"t.terrain", "--tile"}));
    EXPECT_TRUE(failsWith(extract({"-o", tile, "--tile", "9/1024/0"}), 2, "terraintool", {"9/1024/0"}));
    EXPECT_TRUE(failsWith(extract({"-o", place.path("t.obj"), "--tile", "9/535/386"}), 1, "terraintool",
                          {"t.obj", ".terrain"}));
    EXPECT_TRUE(
        failsWith(extract({"-o", tile, "--tile", "9/535/386"}), 1, "terraintool", {"hill.mt", "in degrees"}))
        << "it is in metres of UTM";
}

TEST(MtTool, isTheElevationOfATerrain)
{
    const Workplace place;
    ASSERT_TRUE(succeeds(runTerrainTool(building(place, "hill.mt"))));
    place.write("by-raster.roam", "dem = hill.tif\nsun = 200 30\n");
    place.write("by-mt.roam", "dem = hill.mt\nsun = 200 30\n");
    ordered_json raster = infoOf(place, "by-raster.roam"), triangulation = infoOf(place, "by-mt.roam");
    EXPECT_TRUE(triangulation["georeferenced"]);
    raster.erase("file");
    triangulation.erase("file");
    EXPECT_EQ(triangulation, raster) << "each sample at its place";
    EXPECT_TRUE(succeeds(runTerrainTool({"validate", place.path("by-mt.roam"), "--frames", "5"})));
    place.writeHill("other.tif", 30.0);
    place.write("two.roam", "dem = other.tif\ndem = hill.mt\n");
    EXPECT_TRUE(failsWith(runTerrainTool({"info", place.path("two.roam")}), 1, "terraintool",
                          {"hill.mt", "cannot be joined"}));
    std::string bytes = readBytes(place.path("hill.mt"));
    bytes[20] ^= 1;
    std::ofstream(place.path("hill.mt"), std::ios::binary) << bytes;
    EXPECT_TRUE(failsWith(runTerrainTool({"info", place.path("by-mt.roam")}), 1, "terraintool",
                          {"hill.mt", "damaged header"}));
}

TEST(MtTool, aSurfaceWithoutGeoreferenceIsAPlaneInMetres)
{
    const Workplace place;
    std::string obj; // the plan of an L: there is no surface in the north-east
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            obj += "v " + std::to_string(10 * column) + " " + std::to_string(10 * row) + " 5\n";
    for (const char* face : {"1 2 5 4", "2 3 6 5", "4 5 8 7"})
        obj += std::string("f ") + face + "\n";
    place.write("l.obj", obj);
    ASSERT_TRUE(succeeds(runTerrainTool({"mt-build", place.path("l.obj"), "-o", place.path("l.mt")})));
    place.write("l.roam", "dem = l.mt\nplacement = planar\n");
    const ordered_json told = infoOf(place, "l.roam");
    EXPECT_FALSE(told["georeferenced"]);
    EXPECT_GT(told["missing"], 0) << "holes stay";
    EXPECT_NEAR(told["spacingEastM"].get<double>() * (told["columns"].get<int>() - 1), 20.0, 1e-6);
    EXPECT_EQ(told["lowestM"], 5.0);
}

TEST(MtTool, cellsOfRastersAreCutByARule)
{
    const Workplace place;
    const auto built = [&](const std::string& output, const std::string& rule)
    {
        std::vector<std::string> words = building(place, output);
        words.insert(words.end(), {"--quad-diagonal", rule});
        EXPECT_TRUE(succeeds(runTerrainTool(words)));
        return hashOf(place.path(output));
    };
    ASSERT_TRUE(succeeds(runTerrainTool(building(place, "hill.mt"))));
    EXPECT_EQ(built("heights.mt", "heights"), hashOf(place.path("hill.mt")));
    EXPECT_NE(built("difference.mt", "height-difference"), hashOf(place.path("hill.mt")));
    place.write("points.xyz", "0 0 1\n9 0 2\n0 9 3\n9 9 4\n");
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-build", place.path("points.xyz"), "-o", place.path("p.mt"),
                                          "--quad-diagonal", "areas"}),
                          1, "terraintool", {"points.xyz", "--quad-diagonal"}));
}

TEST(MtTool, oneThreadAndFourWriteTheSameBytes)
{
    const Workplace place;
    std::vector<std::string> one = building(place, "one.mt"), four = building(place, "four.mt");
    one.insert(one.end(), {"--jobs", "1"});
    four.insert(four.end(), {"--jobs", "4"});
    EXPECT_TRUE(succeeds(runTerrainTool(one)));
    EXPECT_TRUE(succeeds(runTerrainTool(four)));
    EXPECT_EQ(readBytes(place.path("one.mt")), readBytes(place.path("four.mt")));
}

TEST(MtTool, validateTellsTheTreeThatIsDamagedAndFliesOverTheOthers)
{
    const Workplace place;
    ASSERT_TRUE(succeeds(runTerrainTool(building(place, "hill.mt"))));
    std::string bytes = readBytes(place.path("hill.mt"));
    bytes[bytes.size() - 100] ^= 1;
    std::ofstream(place.path("hill.mt"), std::ios::binary) << bytes;
    const ProgramRun run = runTerrainTool({"validate", place.path("hill.mt"), "--frames", "5"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.output.find("BROKEN"), std::string::npos) << run.text();
    EXPECT_NE(run.output.find("is damaged: the checksum of a section differs"), std::string::npos)
        << run.text();
    EXPECT_NE(run.output.find("5 frames"), std::string::npos) << run.text();
}

TEST(MtTool, pointsOfAFileAreTriangulated)
{
    const Workplace place;
    std::string text;
    for (int i = 0; i < 400; ++i)
        text += std::to_string(i * 37 % 401) + ".25 " + std::to_string(i * i % 397) + " " +
                std::to_string(i % 13) + "\n";
    place.write("points.xyz", text);
    const ProgramRun built =
        runTerrainTool({"mt-build", place.path("points.xyz"), "-o", place.path("points.mt")});
    EXPECT_TRUE(succeeds(built));
    EXPECT_NE(built.output.find("400 points"), std::string::npos) << built.text();
    EXPECT_TRUE(succeeds(runTerrainTool({"validate", place.path("points.mt"), "--frames", "10"})));
    place.write("bad.xyz", text + "1 2\n");
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-build", place.path("bad.xyz"), "-o", place.path("b.mt")}), 1,
                          "terraintool", {"bad.xyz:401"}));
    EXPECT_TRUE(failsWith(
        runTerrainTool({"mt-build", place.path("points.xyz"), place.hill(), "-o", place.path("b.mt")}), 1,
        "terraintool", {"another kind"}));
}

TEST(MtTool, benchHasTheKeysThatWereAgreed)
{
    const Workplace place;
    EXPECT_TRUE(succeeds(runProgram({OSGTRAINER_MT_BENCH, "--points", "2000", "4000", "--folder",
                                     place.path(""), "--json", place.path("t.json")})));
    const auto table = ordered_json::parse(readBytes(place.path("t.json")));
    ASSERT_EQ(table["cases"].size(), 8U);
    for (const char* key : {"distribution", "points", "buildMs", "trees", "largestTree", "smallestTree",
                            "mainPart", "peakMB", "limitMB", "fileBytes", "extractMs"})
        EXPECT_TRUE(table["cases"][0].contains(key)) << key;
    EXPECT_EQ(table["growth"].size(), 4U);
}

/// Builds a surface of 200 000 points within a limit; 0: without one. Returns the row of the table.
ordered_json builtWithin(const Workplace& place, const std::string& input, const std::string& limitMb)
{
    const std::string output = place.path("w" + limitMb + ".mt"), table = place.path("w" + limitMb + ".json");
    std::vector<std::string> words{"mt-build", input, "-o", output, "--json", table};
    if (limitMb != "0") words.insert(words.end(), {"--memory", limitMb});
    EXPECT_TRUE(succeeds(runTerrainTool(words)));
    return ordered_json::parse(readBytes(table))["files"][0];
}

TEST(MtTool, aBuildKeepsWithinItsMemory)
{
    const Workplace place;
    std::string text;
    for (int i = 0; i < 200000; ++i)
        text += std::to_string(i * 7919 % 200003) + "," + std::to_string(i % 449 * 331 + i / 449) + "," +
                std::to_string(i % 89) + "\n";
    place.write("points.csv", text);
    const ordered_json free = builtWithin(place, place.path("points.csv"), "0");
    const ordered_json within = builtWithin(place, place.path("points.csv"), "64");
    EXPECT_LE(within["peakMB"], 64.0);
    EXPECT_GT(free["peakMB"], 64.0) << "a build that does not care takes more";
    EXPECT_EQ(within["points"], free["points"]);
    EXPECT_EQ(within["triangles"], free["triangles"]);
    EXPECT_TRUE(succeeds(runTerrainTool({"validate", place.path("w64.mt"), "--frames", "4"})));
    EXPECT_FALSE(std::filesystem::exists(place.path("w64.mt.spool")));
    EXPECT_FALSE(std::filesystem::exists(place.path("w64.mt.parts")));
}

TEST(MtTool, benchTellsTheLimitAndThePeakBelowIt)
{
    const Workplace place;
    EXPECT_TRUE(
        succeeds(runProgram({OSGTRAINER_MT_BENCH, "--points", "100000", "--distribution", "clustered",
                             "--memory", "64", "--folder", place.path(""), "--json", place.path("t.json")})));
    const auto table = ordered_json::parse(readBytes(place.path("t.json")));
    ASSERT_EQ(table["cases"].size(), 1U);
    EXPECT_EQ(table["cases"][0]["limitMB"], 64.0);
    EXPECT_LE(table["cases"][0]["peakMB"], 64.0);
    EXPECT_EQ(runProgram({OSGTRAINER_MT_BENCH, "--points", "100000", "--distribution", "uniform", "--memory",
                          "30", "--folder", place.path("")})
                  .exitCode,
              1);
}

TEST(MtTool, sweepsShowThatThresholdsSaveReads)
{
    const Workplace place;
    EXPECT_TRUE(succeeds(runProgram({OSGTRAINER_MT_BENCH, "--points", "20000", "--sweeps", "--folder",
                                     place.path(""), "--json", place.path("t.json")})));
    const auto sweeps = ordered_json::parse(readBytes(place.path("t.json")))["sweeps"];
    EXPECT_EQ(keysOf(sweeps), (std::vector<std::string>{"treeCounts", "thresholds", "index"}));
    EXPECT_EQ(sweeps["treeCounts"].size(), 5U);
    EXPECT_GT(sweeps["treeCounts"].back()["rectangles"], sweeps["treeCounts"].front()["rectangles"]);
    EXPECT_GT(sweeps["thresholds"].front()["reads"], sweeps["thresholds"].back()["reads"]);
    EXPECT_FALSE(std::filesystem::exists(place.path("sweeps.mt")));
}

TEST(MtTool, wrongUseIsTold)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-build", place.hill(), "-o", place.path("hill.txt")}), 2,
                          "terraintool", {".mt"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-build", place.path("none.tif"), "-o", place.path("a.mt")}), 1,
                          "terraintool", {"none.tif"}));
    place.write("empty.tif", "");
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-build", place.path("empty.tif"), "-o", place.path("a.mt")}), 1,
                          "terraintool", {"empty.tif"}));
    std::vector<std::string> little = building(place, "a.mt");
    little.insert(little.end(), {"--memory", "1"});
    EXPECT_TRUE(failsWith(runTerrainTool(little), 1, "terraintool", {"MB", "--memory"}));
    EXPECT_FALSE(std::filesystem::exists(place.path("a.mt")));
}

} // namespace
