// SPDX-License-Identifier: Apache-2.0
// Builds cut into jobs from the command line, and over ranks of MPI.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "Playing.h"

namespace
{

namespace fs = std::filesystem;

/// All bytes of a file as one number: a difference is told in one line.
std::size_t sumOf(const std::string& file)
{
    return std::hash<std::string>()(readBytes(file));
}

/// Writes a raster of 90 000 samples, and builds it in one process. Returns the sum of the bytes.
std::size_t builtAtOnce(const Workplace& place)
{
    std::string text = "ncols 300\nnrows 300\nxllcorner 0\nyllcorner 0\ncellsize 30\n";
    for (int i = 0; i < 300 * 300; ++i)
        text += std::to_string(i * 7919 % 61 + i / 300) + (i % 300 == 299 ? "\n" : " ");
    place.write("ground.asc", text);
    EXPECT_TRUE(succeeds(runTerrainTool(
        {"mt-build", place.path("ground.asc"), "-o", place.path("at-once.mt"), "--trees", "30"})));
    return sumOf(place.path("at-once.mt"));
}

TEST(MtJobs, doneByTheirNumbersGiveTheBytesOfOneProcess)
{
    const Workplace place;
    const std::string jobs = place.path("jobs");
    EXPECT_TRUE(succeeds(runTerrainTool(
        {"mt-plan", place.hill(), "-o", jobs, "--trees", "5", "--json", place.path("plan.json")})));
    const auto plan = nlohmann::ordered_json::parse(readBytes(place.path("plan.json")))["plans"][0];
    EXPECT_EQ(keysOf(plan), (std::vector<std::string>{"folder", "points", "triangles", "jobs", "steps"}));
    const int count = plan["jobs"];
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-job", jobs, std::to_string(count - 1)}), 1, "terraintool",
                          {"needs job", "first"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-join", jobs, "-o", place.path("early.mt")}), 1, "terraintool",
                          {"job 0 is not done"}));
    for (int job = 0; job < count; ++job)
        EXPECT_TRUE(succeeds(runTerrainTool({"mt-job", jobs, std::to_string(job)})));
    EXPECT_TRUE(succeeds(runTerrainTool({"mt-join", jobs, "-o", place.path("joined.mt")})));
    EXPECT_TRUE(
        succeeds(runTerrainTool({"mt-build", place.hill(), "-o", place.path("at-once.mt"), "--trees", "5"})));
    EXPECT_EQ(sumOf(place.path("joined.mt")), sumOf(place.path("at-once.mt")));
}

TEST(MtJobs, aPlanThatFailsLeavesNothing)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-plan", place.path("none.tif"), "-o", place.path("jobs")}), 1,
                          "terraintool", {"none.tif"}));
    EXPECT_FALSE(fs::exists(place.path("jobs")));
}

#ifdef OSGTRAINER_TERRAINTOOL_MPI

/// Builds over some ranks, more than there are cores.
ProgramRun runRanks(const Workplace& place, const std::string& ranks, const std::string& output,
                    const std::string& trees = "30")
{
    return runProgram({"env", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "mpirun",
                       "--oversubscribe", "-n", ranks, OSGTRAINER_TERRAINTOOL_MPI, place.path("ground.asc"),
                       "-o", place.path(output), "--trees", trees});
}

/// Kills one of the processes whose command names the file, but not their mpirun. Returns whether there was one.
bool killOneRank(const std::string& file)
{
    for (const auto& entry : fs::directory_iterator("/proc"))
    {
        const std::string command = readBytes(entry.path() / "cmdline");
        if (!command.starts_with(OSGTRAINER_TERRAINTOOL_MPI) || command.find(file) == std::string::npos)
            continue;
        return ::kill(std::stoi(entry.path().filename()), SIGKILL) == 0;
    }
    return false;
}

/// Waits until some trees are finished. Returns whether they ever were.
bool waitForTrees(const fs::path& folder, int wanted)
{
    for (int turn = 0; turn < 20000; ++turn)
    {
        int trees = 0;
        std::error_code code;
        for (const auto& entry : fs::directory_iterator(folder, code))
            trees += entry.path().extension() == ".tree";
        if (trees >= wanted) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

TEST(MtRanks, manyAndOneGiveTheBytesOfOneProcess)
{
    const Workplace place;
    const std::size_t atOnce = builtAtOnce(place);
    for (const char* ranks : {"1", "4"})
    {
        EXPECT_TRUE(succeeds(runRanks(place, ranks, "ranks.mt")));
        EXPECT_EQ(sumOf(place.path("ranks.mt")), atOnce) << ranks;
        EXPECT_FALSE(fs::exists(place.path("ranks.mt.jobs")));
    }
    EXPECT_TRUE(succeeds(runRanks(place, "2", "others.mt", "12")));
    EXPECT_NE(sumOf(place.path("others.mt")), atOnce) << "the control: another build has other bytes";
}

TEST(MtRanks, aRunAfterARankWasKilledGivesTheSameBytes)
{
    const Workplace place;
    const std::size_t atOnce = builtAtOnce(place);
    ProgramRun killed;
    std::thread run([&] { killed = runRanks(place, "3", "ranks.mt"); });
    EXPECT_TRUE(waitForTrees(place.path("ranks.mt.jobs/parts"), 5));
    EXPECT_TRUE(killOneRank(place.path("ranks.mt")));
    run.join();
    EXPECT_NE(killed.exitCode, 0) << killed.text();
    EXPECT_FALSE(fs::exists(place.path("ranks.mt")));
    EXPECT_TRUE(waitForTrees(place.path("ranks.mt.jobs/parts"), 5)) << "what was done stays";
    EXPECT_TRUE(succeeds(runRanks(place, "3", "ranks.mt")));
    EXPECT_EQ(sumOf(place.path("ranks.mt")), atOnce);
}

TEST(MtRanks, anErrorEndsAllRanks)
{
    const Workplace place;
    const ProgramRun run = runRanks(place, "3", "ranks.mt");
    EXPECT_EQ(run.exitCode, 1) << run.text();
    EXPECT_NE(run.errors.find("terraintool-mpi: " + place.path("ground.asc") + ": no such file"),
              std::string::npos)
        << run.text();
    EXPECT_FALSE(fs::exists(place.path("ranks.mt.jobs")));
}

#endif

} // namespace
