// SPDX-License-Identifier: Apache-2.0
// What pmtool says of its inputs and options, and .pm files as models.
#include <fstream>
#include <sstream>

#include "PmToolRun.h"

namespace
{

/// A grid of 8 × 8 squares in waves.
std::string gridObj()
{
    std::string text;
    for (int row = 0; row <= 8; ++row)
        for (int column = 0; column <= 8; ++column)
            text += "v " + std::to_string(column) + ' ' + std::to_string(row) + ' ' +
                    std::to_string((row * column) % 3) + '\n';
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column)
        {
            const auto at = [&](int c, int r)
            { return ' ' + std::to_string(9 * (row + r) + column + c + 1); };
            text += "f" + at(0, 0) + at(1, 0) + at(1, 1) + "\nf" + at(0, 0) + at(1, 1) + at(0, 1) + '\n';
        }
    return text;
}

constexpr const char* kPyramid =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\n"
    "vt 0 0\nvt 1 0\nvt 0.5 1\nusemtl a\nf 1/1 2/2 5/3\nf 2/1 3/2 5/3\nf 3/1 4/2 5/3\n"
    "f 4/1 1/2 5/3\n";

TEST(PmToolFiles, AnInputThatIsNoFileIsToldSo)
{
    const Workplace place;
    std::filesystem::create_directory(place.path("folder.obj"));
    const std::string empty = place.write("empty.obj", ""), unknown = place.write("a.strange", "x");
    for (const char* command : {"info", "consolidate", "simplify"})
    {
        EXPECT_TRUE(failsWith(runPmTool({command, empty}), 1, "pmtool", {empty + ": is empty"}));
        EXPECT_TRUE(failsWith(runPmTool({command, place.path("folder.obj")}), 1, "pmtool", {"is a folder"}));
        EXPECT_TRUE(failsWith(runPmTool({command, "/proc/self/mem"}), 1, "pmtool", {"/proc/self/mem: "}));
        EXPECT_TRUE(failsWith(runPmTool({command, unknown}), 1, "pmtool", {unknown, "plugin"}));
    }
    const std::string emptyMesh = place.write("empty.pm", "");
    EXPECT_TRUE(failsWith(runPmTool({"info", emptyMesh}), 1, "pmtool", {"is empty"}));
}

TEST(PmToolFiles, AWrongOptionIsNamedInWords)
{
    const Workplace place;
    const std::string model = place.write("a.obj", kPyramid);
    EXPECT_TRUE(failsWith(runPmTool({"simplify", model, "--placement", "best"}), 2, "pmtool",
                          {"--placement: 'best' is none of optimal, quality, subset"}));
    EXPECT_TRUE(failsWith(runPmTool({"consolidate", model, "--quad-diagonal", "3"}), 2, "pmtool",
                          {"--quad-diagonal: '3' is none of "}));
    EXPECT_TRUE(failsWith(runPmTool({"build", model, "-o", place.path("q.xyz")}), 2, "pmtool",
                          {"--output", "does not end in .pm"}));
    EXPECT_FALSE(std::filesystem::exists(place.path("q.xyz")));
}

TEST(PmToolFiles, TheSecondsOfALimitAreThoseThatWereGiven)
{
    const Workplace place;
    std::ostringstream text;
    for (int i = 0; i < 1000000; ++i)
        text << "v " << i << " 0 0\n";
    const std::string model = place.write("long.obj", text.str());
    const ProgramRun run = runPmTool({"info", model, "--seconds", "0.1"});
    EXPECT_TRUE(failsWith(run, 1, "pmtool", {"was not done after 0.1 s"}));
}

TEST(PmToolFiles, CommandsTakeAProgressiveMesh)
{
    const Workplace place;
    const std::string model = place.write("a.obj", kPyramid), pm = place.path("a.pm");
    ASSERT_TRUE(succeeds(runPmTool({"build", model, "-o", pm})));
    const auto info = pmToolTable(place, {"info", pm})["models"][0];
    EXPECT_EQ(info["missingSteps"], 0);
    const auto row = pmToolTable(place, {"consolidate", pm, "--output", place.path("out")})["models"][0];
    EXPECT_EQ(row["before"]["triangles"], 4);
    EXPECT_EQ(pmToolTable(place, {"info", place.path("out/a.osgb")})["models"][0]["triangles"], 4);
    EXPECT_EQ(pmToolTable(place, {"simplify", pm, "--targets", "50"})["models"][0]["triangles"], 4);
    EXPECT_EQ(pmToolTable(place, {"build", pm, "-o", place.path("b.pm")})["models"][0]["triangles"], 4);
}

/// Each command writes what the name says, and OpenSceneGraph reads it again.
TEST(PmToolFiles, EveryFormatIsThatOfItsName)
{
    const Workplace place;
    const std::string model = place.write("a.obj", kPyramid);
    place.write("a.mtl", "newmtl a\nKd 1 0 0\n");
    for (const auto& [format, beginning] :
         {std::pair{"osgt", "#Ascii"}, std::pair{"osgb", "\xa1\x0e\x91\x6c"}, std::pair{"ive", ""}})
        for (const auto& [command, more] :
             {std::pair{"simplify", Words{"--targets", "100"}}, std::pair{"consolidate", Words{}},
              std::pair{"bake", Words{"--faces", "4", "--size", "64"}}})
        {
            const std::string folder = place.path(std::string(command) + format);
            Words words{command, model, "--output", folder, "--format", format};
            words.insert(words.end(), more.begin(), more.end());
            ASSERT_TRUE(succeeds(runPmTool(words))) << command << ' ' << format;
            for (const auto& entry : std::filesystem::directory_iterator(folder))
            {
                const std::string file = entry.path().string();
                const std::string bytes = readBytes(file);
                EXPECT_TRUE(bytes.starts_with(beginning)) << file;
                EXPECT_EQ(bytes.find('\0') == bytes.npos, format == std::string("osgt")) << file;
                EXPECT_EQ(pmToolTable(place, {"info", file})["models"][0]["triangles"], 4) << file;
            }
        }
}

/// A grid of squares, with enough steps for several sections.
std::string grid()
{
    std::ostringstream text;
    for (int y = 0; y <= 20; ++y)
        for (int x = 0; x <= 20; ++x)
            text << "v " << x << ' ' << y << ' ' << 0.1 * ((x * x + y) % 5) << '\n';
    for (int y = 0; y < 20; ++y)
        for (int x = 1; x <= 20; ++x)
            text << "f " << 21 * y + x << ' ' << 21 * y + x + 1 << ' ' << 21 * y + x + 22 << ' '
                 << 21 * y + x + 21 << '\n';
    return text.str();
}

TEST(PmToolFiles, LevelsArePrintedInColumns)
{
    const Workplace place;
    const ProgramRun run = runPmTool({"simplify", place.write("grid.obj", grid()), "--targets", "25"});
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("\n      25pc      "), std::string::npos) << run.output;
}

TEST(PmToolFiles, TheBeginningOfAProgressiveMeshIsACoarserOneAndToldSo)
{
    const Workplace place;
    const std::string model = place.write("grid.obj", grid()), pm = place.path("grid.pm");
    ASSERT_TRUE(succeeds(runPmTool({"build", model, "-o", pm})));
    const std::string bytes = readBytes(pm),
                      cut = place.write("cut.pm", bytes.substr(0, bytes.size() * 2 / 3));
    const auto whole = pmToolTable(place, {"info", pm})["models"][0];
    const auto info = pmToolTable(place, {"info", cut})["models"][0];
    EXPECT_GT(info["missingSteps"], 0);
    EXPECT_EQ(info["missingSteps"].get<int>() + info["steps"].get<int>(), whole["steps"].get<int>());
    EXPECT_NE(info["notes"][0].get<std::string>().find("cut off"), std::string::npos);
    const auto row = pmToolTable(place, {"consolidate", cut})["models"][0];
    EXPECT_EQ(row["before"]["triangles"], info["levels"][0]["triangles"]);
    EXPECT_NE(row["notes"][0].get<std::string>().find("cut off"), std::string::npos);
}

TEST(PmToolFiles, WhatWasLeftOutWhileLoadingIsToldByEveryCommand)
{
    const Workplace place;
    place.write("a.mtl", "newmtl a\nmap_Kd wood.png\n");
    const std::string model = place.write("a.obj", kPyramid);
    for (const Words& words : {Words{"info", model}, Words{"consolidate", model}, Words{"simplify", model},
                               Words{"build", model, "-o", place.path("a.pm")}})
    {
        const auto row = pmToolTable(place, words)["models"][0];
        ASSERT_TRUE(row.contains("notes")) << words[0];
        ASSERT_EQ(row["notes"].size(), 1U) << "once: " << row["notes"];
        EXPECT_NE(row["notes"][0].get<std::string>().find("wood.png is missing"), std::string::npos);
        EXPECT_NE(runPmTool(words).output.find("wood.png is missing"), std::string::npos) << words[0];
    }
    const std::string line = place.write("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 3\n");
    for (const Words& words : {Words{"simplify", line}, Words{"build", line, "-o", place.path("a.pm")}})
        EXPECT_EQ(pmToolTable(place, words)["models"][0]["import"]["keptDrawables"], 1) << words[0];
}

TEST(PmToolFiles, StripsAreWrittenAndReadAgainWithAllTriangles)
{
    const Workplace place;
    const std::string model = place.write("grid.obj", gridObj());
    const auto whole = pmToolTable(place, {"consolidate", model, "--output", place.path("none"), "--format",
                                           "osgt"})["models"][0]["after"]["triangles"];
    EXPECT_EQ(whole, 2 * 8 * 8);
    EXPECT_EQ(readBytes(place.path("none/grid.osgt")).find("TRIANGLE_STRIP"), std::string::npos);
    for (const char* kind : {"sgi", "dual"})
    {
        const std::string folder = place.path(kind);
        pmToolTable(place, {"consolidate", model, "--output", folder, "--format", "osgt", "--strips", kind,
                            "--order", "hilbert"});
        EXPECT_NE(readBytes(folder + "/grid.osgt").find("TRIANGLE_STRIP"), std::string::npos) << kind;
        const auto again = pmToolTable(place, {"info", folder + "/grid.osgt"})["models"][0];
        EXPECT_NE(again.dump().find("\"triangles\":" + whole.dump()), std::string::npos) << again.dump();
    }
}

} // namespace
