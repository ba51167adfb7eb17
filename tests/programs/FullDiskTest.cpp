// SPDX-License-Identifier: Apache-2.0
// A disk that fills up or is read-only: the work stops with an error, and every picture under a final name is
// whole.
#include "Playing.h"

namespace
{

/// Runs a shell script whose $1 is a folder of the workplace, $2 the trainer, $3 the terrain.
ProgramRun inShell(std::vector<std::string> shell, const std::string& script, const Workplace& place)
{
    std::filesystem::create_directory(place.path("disk"));
    shell.insert(shell.end(),
                 {"sh", "-c", script, "sh", place.path("disk"), OSGTRAINER_TRAINER, place.hill()});
    return runProgram(shell);
}

/// Whether this machine lets a test mount something where nobody else sees it.
bool canMount(const Workplace& place)
{
    std::filesystem::create_directory(place.path("probe"));
    return runProgram({"unshare", "-m", "mount", "-t", "tmpfs", "none", place.path("probe")}).exitCode == 0;
}

const std::string kTour =
    R"("$2" tour --no-world "$3" --size 160x90 --frames 8 --capture "$1/frames" --stats "$1/stats.json")";

/// The last line is the error; those before it tell of the progress.
void expectEndsWithError(const ProgramRun& run, const std::string& words)
{
    EXPECT_EQ(run.exitCode, 1) << run.text();
    std::vector<std::string> errors;
    for (const std::string& line : linesOf(run.errors))
        if (!line.starts_with("frames: ")) errors.push_back(line);
    ASSERT_EQ(errors.size(), 1U) << run.text();
    EXPECT_TRUE(errors.front().starts_with("trainer: ")) << run.text();
    EXPECT_NE(errors.front().find(words), std::string::npos) << run.text();
}

TEST(FullDisk, APictureThatDoesNotFitLeavesNothing)
{
    const Workplace place;
    // No file may grow beyond 4 kB. ThreadSanitizer would map a longer one of its own in the folder for such
    // things.
    expectEndsWithError(inShell({}, "ulimit -f 8; trap '' XFSZ; TMPDIR=/nowhere exec " + kTour, place),
                        "frame_00000.png: ");
    EXPECT_TRUE(bytesIn(place.path("disk")).empty());
}

TEST(FullDisk, StopsTheFlightAndLeavesWholePicturesOnly)
{
    const Workplace place;
    if (!canMount(place)) GTEST_SKIP() << "NOT TESTED: no tmpfs can be mounted in a private namespace here";
    const std::string small = "mount -t tmpfs -o size=64k none \"$1\" || exit 99\n" + kTour +
                              "\ncode=$?\ncp -r \"$1\" \"$1-kept\"\nexit $code";
    const ProgramRun run = inShell({"unshare", "-m"}, small, place);
    expectEndsWithError(run, "No space left on device");
    const auto kept = bytesIn(place.path("disk-kept"));

    const Playing whole =
        playedAs(place, "whole", {"tour", place.hill()}, {"--size", "160x90", "--frames", "8"});
    EXPECT_GE(kept.size(), 1U) << "the disk was full before the first picture";
    EXPECT_LT(kept.size(), whole.frames.size()) << "the disk was not full at all";
    for (const auto& [name, bytes] : kept)
    {
        ASSERT_TRUE(name.starts_with("frames/frame_") && name.ends_with(".png")) << name;
        EXPECT_TRUE(bytes == whole.frames.at(name.substr(7))) << name << " is not the whole picture";
    }
}

TEST(FullDisk, AReadOnlyFolderIsNamedBeforeTheFlight)
{
    const Workplace place;
    if (!canMount(place)) GTEST_SKIP() << "NOT TESTED: nothing can be mounted in a private namespace here";
    const std::string readOnly =
        "mount --bind \"$1\" \"$1\" && mount -o remount,bind,ro \"$1\" || exit 99\nexec ";
    const ProgramRun run = inShell({"unshare", "-m"}, readOnly + kTour, place);
    EXPECT_TRUE(failsWith(run, 1, "trainer", {place.path("disk/stats.json"), "Read-only file system"}));
    const ProgramRun pictures =
        runProgram({"unshare", "-m", "sh", "-c",
                    readOnly + "\"$2\" tour --no-world \"$3\" --size 64x36 --capture \"$1/frames\"", "sh",
                    place.path("disk"), OSGTRAINER_TRAINER, place.hill()});
    EXPECT_TRUE(failsWith(pictures, 1, "trainer", {place.path("disk/frames"), "Read-only file system"}));
}

} // namespace
