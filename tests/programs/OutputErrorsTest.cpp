// SPDX-License-Identifier: Apache-2.0
// Results that have no place to go: said in one line before any work is done, and nothing half-made is left.
#include <unistd.h>

#include "Playing.h"

namespace
{

using std::filesystem::is_symlink;

std::vector<std::string> tour(const Workplace& place, const std::vector<std::string>& results)
{
    std::vector<std::string> arguments{"tour", place.hill(), "--size", "64x36", "--frames", "2"};
    arguments.insert(arguments.end(), results.begin(), results.end());
    return arguments;
}

TEST(OutputErrors, AFolderThatCannotBeMadeIsNamed)
{
    const Workplace place;
    const auto before = place.files();
    for (const std::string& folder :
         {place.hill() + "/frames", place.hill(), std::string("/proc/none/frames")})
        EXPECT_TRUE(
            failsWith(runTrainer(tour(place, {"--capture", folder})), 1, "trainer", {folder, "writ"}));
    EXPECT_EQ(place.files(), before);
}

TEST(OutputErrors, AFolderThatTakesNoFilesIsNamedBeforeTheFlight)
{
    const Workplace place;
    EXPECT_TRUE(
        failsWith(runTrainer(tour(place, {"--capture", "/proc"})), 1, "trainer", {"/proc/frame_00000.png"}));
}

TEST(OutputErrors, AFileThatCannotBeWrittenIsNamedBeforeTheFlight)
{
    const Workplace place;
    std::filesystem::create_directory(place.path("folder"));
    const auto before = place.files();
    for (const char* option : {"--stats", "--report", "--save"})
        for (const std::string& file : {place.hill() + "/result", place.path("none/result"),
                                        place.path("folder"), std::string("/proc/none/result")})
        {
            const auto arguments = tour(place, {"--capture", place.path("frames"), option, file});
            EXPECT_TRUE(failsWith(runTrainer(arguments), 1, "trainer", {file + ": "})) << option;
        }
    EXPECT_EQ(place.files(), before);
}

TEST(OutputErrors, ATableThatCannotBeWrittenIsNamedBeforeTheWork)
{
    const Workplace place;
    const auto before = place.files();
    for (const char* command : {"info", "validate"})
    {
        const std::string file = place.hill() + "/table.json";
        const ProgramRun run = runTerrainTool({command, place.hill(), "--json", file});
        EXPECT_TRUE(failsWith(run, 1, "terraintool", {file + ": "}));
        EXPECT_EQ(run.output, "");
    }
    EXPECT_EQ(place.files(), before);
}

TEST(OutputErrors, ADeviceThatTakesNoMoreIsAnError)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "NOT TESTED: this machine has no /dev/full";
    const Workplace place;
    const std::string link = place.path("full.json");
    ASSERT_EQ(symlink("/dev/full", link.c_str()), 0);
    const auto before = place.files();
    const ProgramRun flight = runTrainer(tour(place, {"--stats", link}));
    EXPECT_EQ(flight.exitCode, 1) << flight.text();
    EXPECT_NE(flight.errors.find("trainer: " + link + ": cannot be written: No space left on device; "),
              std::string::npos)
        << flight.text();
    EXPECT_TRUE(failsWith(runTerrainTool({"info", place.hill(), "--json", link}), 1, "terraintool",
                          {"No space left"}));
    EXPECT_EQ(place.files(), before);
    EXPECT_TRUE(is_symlink(link));
}

TEST(OutputErrors, LinksAndDevicesAreWrittenToNotReplaced)
{
    const Workplace place;
    ASSERT_EQ(symlink("/dev/null", place.path("null.json").c_str()), 0);
    place.write("real.json", "old");
    ASSERT_EQ(symlink("real.json", place.path("link.json").c_str()), 0);
    for (const char* name : {"null.json", "link.json"})
    {
        EXPECT_TRUE(succeeds(runTerrainTool({"info", place.hill(), "--json", place.path(name)})));
        EXPECT_TRUE(is_symlink(place.path(name))) << name;
    }
    EXPECT_TRUE(nlohmann::json::accept(readBytes(place.path("real.json"))));
}

TEST(OutputErrors, AResultThatWasThereStaysWhenTheWorkFails)
{
    const Workplace place;
    place.write("old.json", "from the last time");
    EXPECT_TRUE(failsWith(runTerrainTool({"info", place.path("none.tif"), "--json", place.path("old.json")}),
                          1, "terraintool", {"none.tif"}));
    EXPECT_EQ(readBytes(place.path("old.json")), "from the last time");
}

TEST(OutputErrors, AViewFileThatIsWrongIsNamedWithItsLine)
{
    const Workplace place;
    place.write("view.xml",
                "<View>\n<Channel name=\"a\" widthPx=\"64\" heightPx=\"36\" zoom=\"2\"/>\n</View>\n");
    const auto before = place.files();
    for (const auto& [file, words] : {std::pair{"view.xml", "view.xml:2: "}, {"none.xml", "none.xml: "}})
        EXPECT_TRUE(failsWith(
            runTrainer(tour(place, {"--view", place.path(file), "--capture", place.path("frames")})), 1,
            "trainer", {words}));
    EXPECT_EQ(place.files(), before);
}

} // namespace
