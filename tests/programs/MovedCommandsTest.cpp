// SPDX-License-Identifier: Apache-2.0
// Commands that another program has now: the old name says in one line where it went, and it is there.
#include "ProgramRun.h"

namespace
{

struct Moved
{
    const char* testName;
    std::string path, program, name; ///< where it was
    std::vector<std::string> place;  ///< path of the program that has it now, and its command
    std::string placeName;           ///< as the line tells it
};

std::string nameOfMoved(const testing::TestParamInfo<Moved>& info)
{
    return info.param.testName;
}

class MovedCommands : public testing::TestWithParam<Moved>
{
};

TEST_P(MovedCommands, SayWhereTheyWent)
{
    const Moved& moved = GetParam();
    const ProgramRun told =
        runProgram({moved.path, moved.name, "order", "some.file", "--json", "table.json"});
    EXPECT_TRUE(failsWith(told, 2, moved.program, {moved.name}));
    EXPECT_TRUE(told.errors.ends_with("; call " + moved.placeName + '\n')) << told.errors;
    std::vector<std::string> place = moved.place;
    place.emplace_back("--help");
    EXPECT_TRUE(succeeds(runProgram(place)));
}

/// The old name is looked for where a command stands, nowhere else.
TEST_P(MovedCommands, AreFreeAsArguments)
{
    const Moved& moved = GetParam();
    EXPECT_EQ(runProgram({moved.path, "info", moved.name}).errors.find(moved.placeName), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, MovedCommands,
                         testing::Values(Moved{"Methods",
                                               OSGTRAINER_TERRAINTOOL,
                                               "terraintool",
                                               "compare",
                                               {OSGTRAINER_COMPARE_TERRAIN, "methods"},
                                               "compare_terrain methods"},
                                         Moved{"Drivers",
                                               OSGTRAINER_TERRAINTOOL,
                                               "terraintool",
                                               "bench",
                                               {OSGTRAINER_COMPARE_TERRAIN, "drivers"},
                                               "compare_terrain drivers"},
                                         Moved{"Triangulations",
                                               OSGTRAINER_TERRAINTOOL,
                                               "terraintool",
                                               "mt-bench",
                                               {OSGTRAINER_MT_BENCH},
                                               "mt_bench"},
                                         Moved{"Objects",
                                               OSGTRAINER_PMTOOL,
                                               "pmtool",
                                               "compare",
                                               {OSGTRAINER_COMPARE_OBJECTS},
                                               "compare_objects"},
                                         Moved{"Support",
                                               OSGTRAINER_PMTOOL,
                                               "pmtool",
                                               "support",
                                               {OSGTRAINER_COMPARE_OBJECTS, "support"},
                                               "compare_objects support"}),
                         nameOfMoved);

} // namespace
