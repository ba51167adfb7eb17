// SPDX-License-Identifier: Apache-2.0
// Builds over ranks of MPI; compiled where Open MPI is found.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "Playing.h"

namespace
{

namespace fs = std::filesystem;

/// Writes a raster of 90 000 samples, and builds it in one process. Returns the sum of the bytes.
std::size_t builtAtOnce(const Workplace& place)
{
    std::string text = "ncols 300\nnrows 300\nxllcorner 0\nyllcorner 0\ncellsize 30\n";
    for (int i = 0; i < 300 * 300; ++i)
        text += std::to_string(i * 7919 % 61 + i / 300) + (i % 300 == 299 ? "\n" : " ");
    place.write("ground.asc", text);
    EXPECT_TRUE(succeeds(runTerrainTool(
        {"mt-build", place.path("ground.asc"), "-o", place.path("at-once.mt"), "--trees", "30"})));
    return hashOf(place.path("at-once.mt"));
}

/// Builds over some ranks, more than there are cores.
ProgramRun runRanks(const Workplace& place, const std::string& ranks, const std::string& output,
                    const std::string& trees = "30")
{
    return runProgram({"env", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "mpirun",
                       "--oversubscribe", "-n", ranks, OSGTRAINER_TERRAINTOOL_MPI, place.path("ground.asc"),
                       "-o", place.path(output), "--trees", trees});
}

/// Kills one of the processes whose command names the file, but not their mpirun. Returns whether there was
/// one.
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
        EXPECT_EQ(hashOf(place.path("ranks.mt")), atOnce) << ranks;
        EXPECT_FALSE(fs::exists(place.path("ranks.mt.jobs")));
    }
    EXPECT_TRUE(succeeds(runRanks(place, "2", "others.mt", "12")));
    EXPECT_NE(hashOf(place.path("others.mt")), atOnce) << "the control: another build has other bytes";
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
    EXPECT_EQ(hashOf(place.path("ranks.mt")), atOnce);
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

} // namespace
