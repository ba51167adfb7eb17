// SPDX-License-Identifier: Apache-2.0
// Tests what `compare_terrain drivers` writes: its table, and the frames for checks by other programs.
#include <cmath>
#include <cstring>
#include <set>

#include "Playing.h"

namespace
{

using nlohmann::ordered_json;
using Keys = std::vector<std::string>;

/// Returns the table of a short run over a hill of 65 × 65 samples.
ordered_json tableOf(const Workplace& place, Keys more = {})
{
    Keys arguments{
        OSGTRAINER_COMPARE_TERRAIN, "drivers", place.hill(), "--frames", "6", "--tolerance", "0.5", "--json",
        place.path("bench.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_TRUE(succeeds(runProgram(arguments)));
    return ordered_json::parse(readBytes(place.path("bench.json")), nullptr, false);
}

TEST(TerrainBench, HasARowForEveryDriverOnEveryPath)
{
    const Workplace place;
    const ordered_json table = tableOf(place);
    std::set<std::pair<std::string, std::string>> rows;
    std::map<std::string, std::set<double>> triangles;
    for (const ordered_json& row : table["runs"])
    {
        for (const char* key : {"patchExponent", "tolerancePx", "adaptUsP50", "adaptUsP95", "adaptUsP99",
                                "adaptUsMax", "changesPerFrame", "checksPerFrame", "nsPerChange",
                                "nsPerTriangle", "maxErrorPx", "uploadBytesPerChange"})
            EXPECT_TRUE(row.contains(key)) << key;
        const std::string path = row["path"];
        rows.emplace(row["driver"], path);
        triangles[path].insert(row["triangles"].get<double>());
        EXPECT_LE(row["maxErrorPx"].get<double>(), 0.5);
        EXPECT_LE(row["adaptUsP50"], row["adaptUsP95"]);
        EXPECT_LE(row["adaptUsP95"], row["adaptUsP99"]);
        EXPECT_LE(row["adaptUsP99"], row["adaptUsMax"]);
        if (path != "still" || row["driver"] == "scratch") continue;
        EXPECT_EQ(row["checksPerFrame"].get<double>() == 0.0, row["driver"] != "walk") << row;
    }
    EXPECT_EQ(rows.size(), 4u * 6u);
    for (const auto& [path, counts] : triangles)
        EXPECT_EQ(counts.size(), 1u) << "the drivers differ on " << path;
    EXPECT_GT(table["enhMerge"]["nsPerRemovedTriangle"], 0.0);
    EXPECT_GT(table["enhMerge"]["singleMergeNsPerRemovedTriangle"], 0.0);
    EXPECT_EQ(table["bytesPerSample"], 6.0);
    EXPECT_GT(table["bytesPerActiveTriangle"], 10.0);
    EXPECT_GT(table["queriesPerSecond"], 1000.0);
    EXPECT_TRUE(table.contains("queriesPerSecondCurved"));
    for (const ordered_json& pop : table["pops"])
        EXPECT_LE(pop["popPxMorphed"], pop["popPx"]) << pop;
}

TEST(TerrainBench, MeasuresOnlyTheDriversAskedFor)
{
    const Workplace place;
    const std::string frames = place.path("frames");
    const ordered_json table =
        tableOf(place, {"--drivers", "wheel", "scratch", "--check-every", "1", "--dump", frames});
    EXPECT_EQ(table["runs"].size(), 2u * 6u);
    for (const ordered_json& row : table["runs"])
        EXPECT_TRUE(row["driver"] == "wheel" || row["driver"] == "scratch") << row["driver"];
    const auto files = std::filesystem::directory_iterator(frames);
    EXPECT_GE(std::distance(begin(files), end(files)), 2 * 6 * 6) << "every frame is checked, and dumped";
}

TEST(TerrainBench, MeasuresPatchesToo)
{
    const Workplace place;
    const ordered_json plain = tableOf(place), patched = tableOf(place, {"--patch-exponent", "4"});
    ASSERT_EQ(plain["runs"].size(), patched["runs"].size());
    for (std::size_t i = 0; i < plain["runs"].size(); ++i)
    {
        const ordered_json& row = patched["runs"][i];
        EXPECT_EQ(row["patchExponent"], 4);
        EXPECT_GE(row["triangles"], plain["runs"][i]["triangles"]) << "patches draw more for the same bound";
        EXPECT_LE(row["maxErrorPx"], 0.5);
    }
}

TEST(TerrainBench, DumpsWhatCanBeCheckedFromOutside)
{
    const Workplace place;
    tableOf(place, {"--dump", place.path("dump")});
    std::size_t frames = 0;
    for (const auto& entry : std::filesystem::directory_iterator(place.path("dump")))
    {
        if (entry.path().extension() != ".json") continue;
        ++frames;
        const auto frame = ordered_json::parse(readBytes(entry.path()), nullptr, false);
        const std::string corners =
            readBytes(entry.path().parent_path() / frame["corners"].get<std::string>());
        const auto triangles = frame["triangles"].get<std::size_t>();
        ASSERT_EQ(corners.size(), triangles * 15 * sizeof(double));
        std::vector<double> values(triangles * 15);
        std::memcpy(values.data(), corners.data(), corners.size());
        double area = 0.0;
        for (std::size_t t = 0; t < triangles; ++t)
        {
            const double* c = &values[15 * t]; // x, y, z, column, row of each corner
            area += 0.5 * ((c[8] - c[3]) * (c[14] - c[4]) - (c[13] - c[3]) * (c[9] - c[4]));
        }
        EXPECT_NEAR(area, 64.0 * 64.0, 1e-6) << entry.path();
        EXPECT_EQ(frame["matrix"].size(), 16u);
        EXPECT_EQ(frame["eye"].size(), 3u);
    }
    EXPECT_EQ(frames, 24u);
}

TEST(TerrainBench, SaysWhatItCannotDo)
{
    const Workplace place;
    const ProgramRun beyond =
        runProgram({OSGTRAINER_COMPARE_TERRAIN, "drivers", place.hill(), "--crop", "65", "3", "0"});
    EXPECT_EQ(beyond.exitCode, 1);
    EXPECT_NE(beyond.errors.find("square"), std::string::npos) << beyond.errors;
    place.write("file", "");
    const ProgramRun blocked = runProgram({OSGTRAINER_COMPARE_TERRAIN, "drivers", place.hill(), "--frames",
                                           "2", "--dump", place.path("file/dump")});
    EXPECT_EQ(blocked.exitCode, 1);
    EXPECT_NE(blocked.errors.find("folder"), std::string::npos) << blocked.errors;
    EXPECT_EQ(runProgram({OSGTRAINER_COMPARE_TERRAIN, "drivers", place.hill(), "--tolerance", "0"}).exitCode,
              2);
}

} // namespace
