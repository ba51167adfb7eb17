// SPDX-License-Identifier: Apache-2.0
// `pmtool simplify --method` as somebody runs it.
#include <cmath>
#include <sstream>

#include "PmToolRun.h"

namespace
{

/// A 12 × 12 grid of squares over waves.
std::string waves()
{
    std::ostringstream text;
    for (int y = 0; y <= 12; ++y)
        for (int x = 0; x <= 12; ++x)
            text << "v " << x << ' ' << y << ' ' << std::sin(0.6 * x) * std::cos(0.5 * y) << '\n';
    for (int y = 0; y < 12; ++y)
        for (int x = 1; x <= 12; ++x)
            text << "f " << 13 * y + x << ' ' << 13 * y + x + 1 << ' ' << 13 * y + x + 14 << ' '
                 << 13 * y + x + 13 << '\n';
    return text.str();
}

TEST(PmToolLevels, OfClustersKeepTheirBound)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves());
    const auto row = pmToolTable(place, {"simplify", model, "--method", "clusters", "--targets", "50,10",
                                         "--tolerances", "4", "--output", place.path("levels")})["models"][0];
    EXPECT_EQ(keysOf(row), (Words{"model", "triangles", "levels"}));
    ASSERT_EQ(row["levels"].size(), 3U);
    EXPECT_EQ(keysOf(row["levels"][0]), (Words{"level", "triangles", "distance", "cellSize", "lines",
                                               "points", "ms", "errorMax", "errorRms", "file"}));
    EXPECT_LE(row["levels"][0]["triangles"], 144);
    EXPECT_GT(row["levels"][0]["triangles"], 50) << "the cells are not larger than needed";
    EXPECT_LE(row["levels"][1]["triangles"], 28);
    EXPECT_LE(row["levels"][2]["distance"].get<double>(), 4.0 + 1e-6);
    EXPECT_LE(row["levels"][2]["errorMax"].get<double>(), 4.0);
    const auto info = pmToolTable(place, {"info", place.path("levels/waves.4m.osgb")})["models"][0];
    EXPECT_EQ(info["triangles"], row["levels"][2]["triangles"]);
    EXPECT_LT(info["positions"], 169) << "positions without a face are gone";
}

TEST(PmToolLevels, OfImagesAreThoseOfEdgesUntilTheLastSteps)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves());
    const Words wanted = {"simplify", model, "--targets", "20", "--placement", "subset"};
    Words polished = wanted;
    polished.insert(polished.end(), {"--method", "images", "--output", place.path("levels")});
    const auto edges = pmToolTable(place, wanted)["models"][0],
               images = pmToolTable(place, polished)["models"][0];
    EXPECT_EQ(images["least"], edges["least"]);
    EXPECT_LE(images["levels"][0]["triangles"], 58);
    EXPECT_GT(images["levels"][0]["triangles"], 40);
    EXPECT_TRUE(images["levels"][0].contains("ms"));
    EXPECT_NE(images["levels"][0]["distance"], edges["levels"][0]["distance"]) << "other steps were chosen";
    const auto info = pmToolTable(place, {"info", place.path("levels/waves.20pc.osgb")})["models"][0];
    EXPECT_EQ(info["triangles"], images["levels"][0]["triangles"]);
}

TEST(PmToolLevels, OfRemovedVerticesAreChosenByTheirDistance)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves());
    const auto row = pmToolTable(place, {"simplify", model, "--method", "removal", "--farther", "1,2",
                                         "--support", "max", "--support-depth", "1"})["models"][0];
    ASSERT_EQ(row["levels"].size(), 2U);
    EXPECT_EQ(row["levels"][0]["triangles"], row["triangles"]);
    EXPECT_EQ(row["levels"][1]["trianglesByFormula"], 72.0);
    EXPECT_NEAR(row["levels"][1]["triangles"].get<double>(), 72.0, 36.0) << "the border removes one a step";
}

TEST(PmToolLevels, OfRemovedVerticesArePlayable)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves()), file = place.path("waves.pm");
    const auto built = pmToolTable(
        place, {"build", model, "-o", file, "--method", "removal", "--support", "both"})["models"][0];
    const auto free = pmToolTable(place, {"build", model, "-o", file, "--method", "removal"})["models"][0];
    EXPECT_GT(free["steps"], 120);
    EXPECT_LT(built["steps"], free["steps"]) << "support vertices stay";
    const auto info = pmToolTable(place, {"info", file})["models"][0];
    EXPECT_EQ(info["steps"], free["steps"]);
}

TEST(PmToolLevels, TakeTheParametersOfTswap)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves()), file = place.path("waves.pm");
    const auto built = pmToolTable(place, {"build", model, "-o", file, "--order", "tswap", "--tswap-step",
                                           "0.3", "--stay-weight", "0.5", "--line-weight", "0.1",
                                           "--look-ahead", "2", "--fifo", "24"})["models"][0];
    EXPECT_EQ(built["fifo"], 24);
    EXPECT_TRUE(failsWith(runPmTool({"build", model, "-o", file, "--look-ahead", "17"}), 2, "pmtool",
                          {"--look-ahead"}));
    EXPECT_TRUE(failsWith(runPmTool({"build", model, "-o", file, "--fifo", "2"}), 2, "pmtool", {"--fifo"}));
    EXPECT_TRUE(
        failsWith(runPmTool({"build", model, "-o", file, "--support", "max"}), 2, "pmtool", {"--support"}));
}

TEST(PmToolLevels, AreArrangedForTheCacheThatWasMeasured)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves());
    const auto built =
        pmToolTable(place, {"build", model, "-o", place.path("waves.pm"), "--fifo", "measure"})["models"][0];
    EXPECT_GE(built["fifo"], 3);
    EXPECT_LE(built["fifo"], 1024);
}

/// What a tolerance shows is judged by its exit code, so that it can be asked of all models.
TEST(PmToolLevels, ShowHardlyMoreThanTheToleranceNeeds)
{
    const Workplace place;
    const auto compare = [&](const char* most)
    {
        return runProgram({OSGTRAINER_COMPARE_OBJECTS, "tolerance", place.write("waves.obj", waves()),
                           "--across", "50", "--points", "5000", "--most-ratio", most});
    };
    EXPECT_TRUE(succeeds(compare("1.3")));
    EXPECT_TRUE(failsWith(compare("1"), 1, "compare_objects", {"waves.obj", "times the fewest triangles"}));
}

TEST(PmToolLevels, RefuseWhatTheMethodWouldIgnore)
{
    const Workplace place;
    const std::string model = place.write("waves.obj", waves());
    const auto refuses = [&](const std::string& method, const Words& option)
    {
        Words words = {"simplify", model, "--method", method};
        words.insert(words.end(), option.begin(), option.end());
        return failsWith(runPmTool(words), 2, "pmtool", {option[0]});
    };
    EXPECT_TRUE(refuses("clusters", {"--placement", "subset"}));
    EXPECT_TRUE(refuses("clusters", {"--shape-only"}));
    EXPECT_TRUE(refuses("images", {"--tolerances", "1"}));
    EXPECT_TRUE(refuses("images", {"--envelope", "1"}));
    EXPECT_TRUE(refuses("removal", {"--placement", "subset"}));
    EXPECT_TRUE(refuses("clusters", {"--farther", "2"}));
    EXPECT_TRUE(refuses("edges", {"--support", "max"}));
    EXPECT_TRUE(failsWith(runPmTool({"simplify", model, "--method", "best"}), 2, "pmtool", {"--method"}));
    EXPECT_TRUE(failsWith(runPmTool({"simplify", model, "--method", "clusters", "--tolerances", "0"}), 1,
                          "pmtool", {model, "level 0m"}));
}

} // namespace
