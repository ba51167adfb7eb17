// SPDX-License-Identifier: Apache-2.0
// Wrong use: exit code 2, and one line that names the option or command and where to look it up.
#include <cctype>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

struct WrongUse
{
    const char* name;
    std::vector<std::string> arguments;
    std::vector<std::string> words; ///< of the line
};

std::string nameOf(const testing::TestParamInfo<WrongUse>& info)
{
    return info.param.name;
}

class TrainerWrongUse : public testing::TestWithParam<WrongUse>
{
};

TEST_P(TrainerWrongUse, IsOneLineThatNamesTheOption)
{
    const Workplace place;
    const auto before = place.files();
    std::vector<std::string> arguments = GetParam().arguments;
    // The terrain is there: nothing else is wrong.
    for (std::string& argument : arguments)
        if (argument == "HILL") argument = place.hill();
    if (arguments.size() > 2) arguments.insert(arguments.begin() + 2, {"--stats", place.path("stats.json")});
    EXPECT_TRUE(failsWith(runTrainer(arguments), 2, "trainer", GetParam().words));
    EXPECT_EQ(place.files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Table, TrainerWrongUse,
    testing::Values(
        WrongUse{"NoCommand", {}, {"command line: no command", "play, tour, check"}},
        WrongUse{
            "UnknownCommand", {"sail"}, {"sail: no such command", "play, tour, check", "trainer --help"}},
        WrongUse{"UnknownOptionFirst", {"--fly"}, {"--fly: no such command or option", "trainer --help"}},
        WrongUse{"MissingScenario", {"play"}, {"SCENARIO", "trainer play --help"}},
        WrongUse{"MissingTerrain", {"tour"}, {"DEM", "trainer tour --help"}},
        WrongUse{"TwoTerrains", {"tour", "HILL", "another.tif"}, {"another.tif", "trainer tour --help"}},
        WrongUse{"UnknownOption", {"tour", "HILL", "--frobnicate"}, {"--frobnicate", "trainer tour --help"}},
        WrongUse{"MissingValue", {"tour", "HILL", "--capture"}, {"--capture", "trainer tour --help"}},
        WrongUse{"HalfASize", {"tour", "HILL", "--size", "10x"}, {"--size: '10x'", "960x540"}},
        WrongUse{"NoSize", {"tour", "HILL", "--size", "large"}, {"--size: 'large'", "960x540"}},
        WrongUse{"EmptySize", {"tour", "HILL", "--size", "0x0"}, {"--size: '0x0'", "960x540"}},
        WrongUse{"SizeWithATail", {"tour", "HILL", "--size", "64x36x2"}, {"--size: '64x36x2'", "960x540"}},
        WrongUse{"HugeSize",
                 {"tour", "HILL", "--size", "99999999999x64"},
                 {"--size: '99999999999x64'", "960x540"}},
        WrongUse{"FpsZero", {"tour", "HILL", "--fps", "0"}, {"--fps: ", "1 to 240", "trainer tour --help"}},
        WrongUse{"FpsNoNumber", {"tour", "HILL", "--fps", "many"}, {"--fps: ", "many"}},
        WrongUse{"FramesZero", {"tour", "HILL", "--frames", "0"}, {"--frames: Value 0", "1 to 1000000; "}},
        WrongUse{"FramesNegative", {"tour", "HILL", "--frames", "-3"}, {"--frames: "}},
        WrongUse{"Backend", {"tour", "HILL", "--backend", "metal"}, {"backend 'metal'", "osmesa or egl"}},
        WrongUse{"Eye", {"tour", "HILL", "--eye", "third"}, {"--eye: third", "own", "chase"}},
        WrongUse{"Samples", {"tour", "HILL", "--samples", "3"}, {"--samples: 3"}},
        WrongUse{"ToleranceNan", {"tour", "HILL", "--tolerance", "nan"}, {"--tolerance: 'nan'"}},
        WrongUse{"ToleranceZero", {"tour", "HILL", "--tolerance", "0"}, {"--tolerance: '0'"}},
        WrongUse{"Ceiling", {"tour", "HILL", "--max-triangles", "1"}, {"--max-triangles: "}},
        WrongUse{"PatchesOdd",
                 {"tour", "HILL", "--patch-exponent", "3"},
                 {"--patch-exponent: '3'", "0, 2, 4, 6, 8 or 10"}},
        WrongUse{
            "PatchesNoNumber", {"tour", "HILL", "--patch-exponent", "fast"}, {"--patch-exponent: 'fast'"}},
        WrongUse{"DurationNan", {"tour", "HILL", "--duration", "nan"}, {"--duration: 'nan'", "4 to 3600"}},
        WrongUse{"DurationShort", {"tour", "HILL", "--duration", "1"}, {"--duration: '1'", "4 to 3600"}},
        WrongUse{"SpacingNegative", {"tour", "HILL", "--spacing", "-1"}, {"--spacing: '-1'"}},
        WrongUse{"SpacingInfinite", {"tour", "HILL", "--spacing", "inf"}, {"--spacing: 'inf'"}},
        WrongUse{"EyeTooHighForADriver",
                 {"tour", "HILL", "--eye-height", "11"},
                 {"--eye-height", "no driver's eye is higher than 10 m", "--eye above"}},
        WrongUse{"EyeHeightNan", {"tour", "HILL", "--eye-height", "nan"}, {"--eye-height: 'nan'"}}),
    nameOf);

class TerrainToolWrongUse : public testing::TestWithParam<WrongUse>
{
};

TEST_P(TerrainToolWrongUse, IsOneLineThatNamesTheOption)
{
    EXPECT_TRUE(failsWith(runTerrainTool(GetParam().arguments), 2, "terraintool", GetParam().words));
}

INSTANTIATE_TEST_SUITE_P(
    Table, TerrainToolWrongUse,
    testing::Values(
        WrongUse{"NoCommand", {}, {"command line: no command", "info, validate"}},
        WrongUse{"UnknownCommand", {"bake"}, {"bake: no such command", "info, validate"}},
        WrongUse{"NoFile", {"info"}, {"FILE", "terraintool info --help"}},
        WrongUse{"UnknownOption", {"info", "a.tif", "--deep"}, {"--deep", "terraintool info --help"}},
        WrongUse{"MissingValue", {"validate", "a.tif", "--json"}, {"--json", "terraintool validate --help"}},
        WrongUse{"FramesZero", {"validate", "a.tif", "--frames", "0"}, {"--frames: "}},
        WrongUse{"FramesOfInfo", {"info", "a.tif", "--frames", "4"}, {"--frames"}},
        WrongUse{"ToleranceNan", {"validate", "a.tif", "--tolerance", "nan"}, {"--tolerance: 'nan'"}},
        WrongUse{"Ceiling", {"validate", "a.tif", "--max-triangles", "0"}, {"--max-triangles: "}},
        WrongUse{"PatchesOdd", {"validate", "a.tif", "--patch-exponent", "5"}, {"--patch-exponent: 5"}},
        WrongUse{"Spacing", {"info", "a.tif", "--spacing", "wide"}, {"--spacing: 'wide'"}}),
    nameOf);

TEST(WrongUse, IsNotTheSameAsWorkThatFailed)
{
    EXPECT_TRUE(failsWith(runTrainer({"tour", "not-there.tif"}), 1, "trainer", {"not-there.tif"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"info", "not-there.tif"}), 1, "terraintool", {"not-there.tif"}));
}

TEST(HelpAndVersion, ExitWithZeroAndPrintOnStdout)
{
    for (const auto& run :
         {runTrainer({"--help"}), runTrainer({"play", "--help"}), runTrainer({"tour", "--help"}),
          runTrainer({"check", "--help"}), runTerrainTool({"--help"}), runTerrainTool({"info", "--help"}),
          runTerrainTool({"validate", "--help"})})
    {
        EXPECT_TRUE(succeeds(run));
        EXPECT_NE(run.output.find("--help"), std::string::npos) << run.text();
        EXPECT_EQ(run.errors, "");
    }
    for (const auto& run : {runTrainer({"--version"}), runTerrainTool({"--version"})})
    {
        EXPECT_TRUE(succeeds(run));
        ASSERT_EQ(linesOf(run.output).size(), 1U) << run.text();
        EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(run.output.front()))) << run.text();
    }
}

} // namespace
