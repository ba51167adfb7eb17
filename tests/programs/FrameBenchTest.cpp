// SPDX-License-Identifier: Apache-2.0
// Tests what frame_bench writes: its tables are complete, and it measures no popping where nothing changes,
// but some where the level of detail is made to jump.
#include "Playing.h"

namespace
{

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// Returns the table of a short run with small pictures over a hill of 65 × 65 samples.
ordered_json frameTable(const Workplace& place, const Words& command, const std::string& frames = "4")
{
    Words arguments{OSGTRAINER_FRAME_BENCH,
                    command.front(),
                    place.hill(),
                    "--width",
                    "160",
                    "--height",
                    "90",
                    "--above",
                    "60",
                    "--start",
                    "0.1",
                    "--frames",
                    frames,
                    "--json",
                    place.path("frames.json")};
    arguments.insert(arguments.end(), command.begin() + 1, command.end());
    const ProgramRun run = runProgram(arguments);
    EXPECT_TRUE(succeeds(run));
    EXPECT_EQ(run.errors, ""); // also without warnings of OSG about OpenGL
    return ordered_json::parse(readBytes(place.path("frames.json")), nullptr, false);
}

int most(const ordered_json& table, const char* what, const char* which)
{
    int levels = 0;
    for (const ordered_json& row : table["rows"])
        if (row.contains(what)) levels = std::max(levels, row[what][which].get<int>());
    return levels;
}

TEST(FrameBench, TimesEveryWayToDrawTheSameView)
{
    const Workplace place;
    const ordered_json table = frameTable(place, {"times", "--tolerance", "1"});
    EXPECT_NE(table["renderer"].get<std::string>().find("Mesa"), std::string::npos) << table["renderer"];
    std::map<std::string, double> triangles;
    for (const ordered_json& row : table["rows"])
    {
        for (const char* key : {"look", "draws", "frames", "wallMsP50", "cpuMsP50", "cpuMsP99"})
            EXPECT_TRUE(row.contains(key)) << key;
        EXPECT_GT(row["wallMsP50"], 0.0);
        EXPECT_LE(row["wallMsP50"], row["wallMsP99"]);
        EXPECT_GT(row["wallMsP50OverOurs"], 0.0);
        triangles[row["subject"]] = row["triangles"];
    }
    EXPECT_EQ(table["rows"].size(), 5U + 6U);
    EXPECT_EQ(triangles["full grid"], 2.0 * 64 * 64);
    EXPECT_EQ(triangles["GeometryTechnique"], 2.0 * 64 * 64);
    EXPECT_GT(triangles["RoamDrawable 1 px"], 0.0);
    EXPECT_LT(triangles["RoamDrawable 1 px"], triangles["full grid"]);
}

TEST(FrameBench, TimesADatabaseOfTiles)
{
    const Workplace place;
    const ordered_json table = frameTable(place, {"database", "--tolerance", "1", "--tile-cells", "16"});
    ASSERT_EQ(table["rows"].size(), 3U);
    for (const ordered_json& row : table["rows"])
    {
        EXPECT_EQ(row["tiles"], 16);
        EXPECT_GT(row["wallMsP50"], 0.0);
        EXPECT_LE(row["wallMsP50"], row["wallMsP99"]);
        EXPECT_GT(row["buildMs"], 0.0);
    }
    EXPECT_EQ(table["rows"][0]["technique"], "GeometryTechnique");
    EXPECT_GT(table["rows"][0]["triangles"], table["rows"][1]["triangles"]);
    EXPECT_GT(table["rows"][1]["triangles"], 0.0);
    const ProgramRun odd =
        runProgram({OSGTRAINER_FRAME_BENCH, "database", place.hill(), "--tile-cells", "17"});
    EXPECT_TRUE(failsWith(odd, 1, "frame_bench", {"--tile-cells"}));
}

TEST(FrameBench, ShowsNothingWhereNothingIsLeftOutAndTheEyeStandsStill)
{
    const Workplace place;
    const ordered_json exact =
        frameTable(place, {"pop", "--tolerance", "0.000001", "--antialiasing", "none", "ssaa2"});
    // The triangles of the grid start at other corners than those of the bintree, so interpolation may round
    // differently.
    for (const char* what : {"lodMinusFull", "delta"})
        EXPECT_LE(most(exact, what, "max"), 2) << what;
    EXPECT_EQ(most(exact, "pop", "max"), 0);
    EXPECT_EQ(exact["rows"].size(), 2U * 2U * 3U);
    const ordered_json still =
        frameTable(place, {"pop", "--tolerance", "2", "--antialiasing", "none", "--speed", "0"});
    EXPECT_GT(most(still, "lodMinusFull", "max"), 0);
    for (const char* what : {"delta", "pop"})
        EXPECT_EQ(most(still, what, "max"), 0) << what;
}

TEST(FrameBench, SeesOneFrameThatIsTenTimesCoarser)
{
    const Workplace place;
    const Words command{"pop", "--tolerance", "0.5", "--antialiasing", "none"};
    Words coarse = command;
    coarse.insert(coarse.end(), {"--coarse-frame", "2"});
    const ordered_json sound = frameTable(place, command), popped = frameTable(place, coarse);
    for (const char* what : {"delta", "pop"})
        EXPECT_GT(most(popped, what, "p999"), most(sound, what, "p999") + 2) << what;
    for (const ordered_json& row : sound["rows"])
    {
        EXPECT_EQ(row.contains("pop"), row["mesh"] != "frozen");
        for (const char* key : {"p50", "p99", "p999", "max", "shareAbove2"})
            EXPECT_TRUE(row["delta"].contains(key)) << key;
        EXPECT_LE(row["delta"]["p999"], row["delta"]["max"]);
        EXPECT_GT(row["edgeShare"], 0.0);
        EXPECT_LT(row["edgeShare"], 1.0);
    }
}

TEST(FrameBench, SaysWhatItCannotDo)
{
    const Workplace place;
    const ProgramRun beyond =
        runProgram({OSGTRAINER_FRAME_BENCH, "times", place.hill(), "--crop", "65", "3", "0"});
    EXPECT_TRUE(failsWith(beyond, 1, "frame_bench", {"square", "hill.tif"}));
    const ProgramRun unknown =
        runProgram({OSGTRAINER_FRAME_BENCH, "pop", place.hill(), "--antialiasing", "fxaa"});
    EXPECT_EQ(unknown.exitCode, 2) << unknown.text();
    EXPECT_NE(unknown.errors.find("fxaa"), std::string::npos) << unknown.errors;
}

} // namespace
