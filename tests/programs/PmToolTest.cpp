// SPDX-License-Identifier: Apache-2.0
// pmtool as somebody runs it.
#include <fstream>
#include <sstream>

#include "PmToolRun.h"

namespace
{

using nlohmann::ordered_json;

/// Two squares side by side, the second with a vertex in the middle of the seam, a face twice, and a flat
/// one.
constexpr const char* kBroken = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 1 0.5 0\n"
                                "f 1 2 3\nf 1 3 4\nf 7 2 5\nf 7 5 6\nf 7 6 3\nf 7 6 3\nf 1 2 2\n";

const Words kCounts = {"triangles",  "positions",   "attributeVertices", "tJunctions",
                       "duplicates", "degenerates", "nonManifoldEdges",  "components"};

TEST(PmTool, ConsolidateWritesTheTableTheModelAndPlainData)
{
    const Workplace place;
    const std::string model = place.write("broken.obj", kBroken);
    const ordered_json table = pmToolTable(
        place, {"consolidate", model, model, "--output", place.path("clean"), "--dump", place.path("dump")});
    ASSERT_EQ(table["models"].size(), 2U);
    const ordered_json& row = table["models"][0];
    EXPECT_EQ(keysOf(row),
              (Words{"model", "before", "after", "surfaceChangePercent", "trianglesDropped", "ms"}));
    EXPECT_EQ(keysOf(row["before"]), kCounts);
    EXPECT_EQ(keysOf(row["after"]), kCounts);
    EXPECT_EQ(row["model"], model);
    EXPECT_EQ(row["before"]["tJunctions"], 1);
    EXPECT_EQ(row["before"]["duplicates"], 1);
    EXPECT_EQ(row["after"]["tJunctions"], 0);
    EXPECT_EQ(row["after"]["duplicates"], 0);
    EXPECT_EQ(row["after"]["degenerates"], 0);
    EXPECT_EQ(row["after"]["triangles"], 6);
    EXPECT_LT(row["surfaceChangePercent"], 1e-9);

    const ordered_json again = pmToolTable(place, {"info", place.path("clean/broken.osgb")});
    EXPECT_EQ(again["models"][0]["triangles"], 6);
    EXPECT_EQ(again["models"][0]["tJunctions"], 0);
    EXPECT_TRUE(std::filesystem::exists(place.path("clean/broken-2.osgb"))) << "the second of the same name";
    std::istringstream plain(readBytes(place.path("dump/broken.after.obj")));
    std::size_t positions = 0, faces = 0;
    for (std::string line; std::getline(plain, line);)
        ++(line[0] == 'v' ? positions : faces);
    EXPECT_EQ(positions, row["after"]["positions"]);
    EXPECT_EQ(faces, 6U);
}

TEST(PmTool, InfoDescribesAModel)
{
    const Workplace place;
    const ordered_json table = pmToolTable(place, {"info", place.write("broken.obj", kBroken)});
    const ordered_json& row = table["models"][0];
    for (const std::string& key : kCounts)
        EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(row["components"], 1);
    EXPECT_EQ(row["parts"], 1);
    EXPECT_NEAR(row["diagonal"].get<double>(), std::sqrt(5.0), 1e-6);
}

/// An 8 × 8 grid of squares, a little higher in the middle.
std::string hill()
{
    std::ostringstream text;
    for (int y = 0; y <= 8; ++y)
        for (int x = 0; x <= 8; ++x)
            text << "v " << x << ' ' << y << ' ' << 0.1 * x * (8 - x) * y * (8 - y) / 16.0 << '\n';
    for (int y = 0; y < 8; ++y)
        for (int x = 1; x <= 8; ++x)
            text << "f " << 9 * y + x << ' ' << 9 * y + x + 1 << ' ' << 9 * y + x + 10 << ' ' << 9 * y + x + 9
                 << '\n';
    return text.str();
}

TEST(PmTool, BakeWritesTheTableAndTheModelWithItsMaps)
{
    const Workplace place;
    const std::string model = place.write("hill.obj", hill());
    const ordered_json table =
        pmToolTable(place, {"bake", model, "--level", "25", "--size", "64", "--output", place.path("baked")});
    ASSERT_EQ(table["models"].size(), 1U);
    const ordered_json& row = table["models"][0];
    EXPECT_EQ(keysOf(row),
              (Words{"model", "triangles", "trianglesReached", "size", "charts", "atlasUsePercent",
                     "texelsPerUnit", "unmatchedPercent", "reach", "texturesNotRead", "ms", "output"}));
    EXPECT_EQ(keysOf(row["ms"]), (Words{"simplify", "charts", "maps"}));
    EXPECT_EQ(row["triangles"], 128);
    EXPECT_NEAR(row["trianglesReached"].get<double>(), 32.0, 4.0);
    EXPECT_GE(row["charts"], 1);
    EXPECT_GT(row["atlasUsePercent"], 30.0);
    const ordered_json again = pmToolTable(place, {"info", place.path("baked/hill.osgb")});
    EXPECT_EQ(again["models"][0]["triangles"], row["trianglesReached"]);
    EXPECT_GT(std::filesystem::file_size(place.path("baked/hill.osgb")), 2U * 3U * 64U * 64U) << "two maps";
    EXPECT_EQ(
        pmToolTable(place, {"bake", model, "--faces", "10", "--size", "64"})["models"][0]["trianglesReached"]
                .get<int>() <= 10,
        true);
}

TEST(PmTool, BakeSaysWhatItCannotDo)
{
    const Workplace place;
    const std::string model = place.write("hill.obj", hill());
    EXPECT_TRUE(failsWith(runPmTool({"bake", model, "--size", "100"}), 2, "pmtool", {"--size"}));
    EXPECT_TRUE(
        failsWith(runPmTool({"bake", model, "--level", "10", "--faces", "5"}), 2, "pmtool", {"--level"}));
    EXPECT_TRUE(failsWith(runPmTool({"bake", model, "--size", "16", "--gutter", "8"}), 1, "pmtool",
                          {model, "do not fit"}));
}

TEST(PmTool, OneBadModelIsNamedAndTheOthersAreDone)
{
    const Workplace place;
    const std::string good = place.write("good.obj", kBroken), bad = place.write("bad.glb", "glTF");
    const ProgramRun run = runPmTool({"consolidate", bad, good, "--json", place.path("table.json")});
    EXPECT_TRUE(failsWith(run, 1, "pmtool", {bad, "glTF 2"}));
    const auto table = ordered_json::parse(readBytes(place.path("table.json")), nullptr, false);
    ASSERT_EQ(table["models"].size(), 1U);
    EXPECT_EQ(table["models"][0]["model"], good);
}

TEST(PmTool, RefusesWhatMakesNoSense)
{
    const Workplace place;
    const std::string model = place.write("a.obj", kBroken);
    EXPECT_TRUE(failsWith(runPmTool({"consolidate"}), 2, "pmtool", {"MODEL"}));
    EXPECT_TRUE(failsWith(runPmTool({"consolidate", model, "--weld", "nan"}), 2, "pmtool", {"--weld"}));
    EXPECT_TRUE(failsWith(runPmTool({"consolidate", model, "--strips", "long"}), 2, "pmtool", {"--strips"}));
    EXPECT_TRUE(
        failsWith(runPmTool({"consolidate", model, "--output", model}), 1, "pmtool", {model, "folder"}));
    EXPECT_TRUE(
        failsWith(runPmTool({"info", "/nowhere.obj"}), 1, "pmtool", {"/nowhere.obj", "no such file"}));
}

} // namespace
