// SPDX-License-Identifier: Apache-2.0
// The checks that the other tests here rest on: each must see what it is there for.
#include "ProgramRun.h"

namespace
{

ProgramRun shell(const std::string& script, double limitS = 60.0)
{
    return runProgram({"sh", "-c", script}, limitS);
}

/// failsWith, of a script that prints this on stderr.
bool passes(const std::string& words, int exitCode = 1)
{
    const ProgramRun run = shell("printf '%b' '" + words + "' >&2; exit " + std::to_string(exitCode));
    return static_cast<bool>(failsWith(run, 1, "tool", {"a.tif"}));
}

TEST(ProgramRun, GivesCodeAndWords)
{
    const ProgramRun run = shell("echo to stdout; echo to stderr >&2; exit 7");
    EXPECT_EQ(run.exitCode, 7);
    EXPECT_EQ(run.output, "to stdout\n");
    EXPECT_EQ(run.errors, "to stderr\n");
    EXPECT_FALSE(run.timedOut);
    EXPECT_EQ(runProgram({"no-such-program-anywhere"}).exitCode, 127);
    EXPECT_EQ(shell("kill -9 $$").exitCode, 137);
}

TEST(ProgramRun, EndsWhatTakesTooLong)
{
    const ProgramRun run = shell("sleep 1000 & sleep 1000", 0.2);
    EXPECT_TRUE(run.timedOut);
    EXPECT_FALSE(succeeds(run));
}

TEST(ProgramRun, OneLineWithPlaceAndRemedyIsWhatAnErrorLooksLike)
{
    EXPECT_TRUE(passes("tool: a.tif: no such file; check the path\\n"));
    EXPECT_FALSE(passes("tool: a.tif: no such file; check the path\\n", 0)) << "exit code";
    EXPECT_FALSE(passes("tool: a.tif: no such file; check the path\\n", 2)) << "exit code";
    EXPECT_FALSE(passes("")) << "no line";
    EXPECT_FALSE(passes("Warning\\ntool: a.tif: no such file; check the path\\n")) << "two lines";
    EXPECT_FALSE(passes("a.tif: no such file; check the path\\n")) << "program";
    EXPECT_FALSE(passes("tool: a.tif; check the path\\n")) << "place";
    EXPECT_FALSE(passes("tool: a.tif: no such file\\n")) << "remedy";
    EXPECT_FALSE(passes("tool: a.tif: no such file; \\n")) << "remedy";
    EXPECT_FALSE(passes("tool: b.tif: no such file; check the path\\n")) << "file";
}

} // namespace
