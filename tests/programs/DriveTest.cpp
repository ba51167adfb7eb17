// SPDX-License-Identifier: Apache-2.0
// `trainer drive`: a car and its driver on a street, twice, and by its recorded inputs.
#include <fstream>
#include <iterator>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

const char* const kStreet = OSGTRAINER_SOURCE_DIR "/data/street.xodr";
const char* const kDriven = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";

std::string bytesOf(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(Drive, GivesTheSameBytesAgainAndByItsRecordedInputs)
{
    const Workplace place;
    const std::string inputs = place.path("inputs.csv");
    const auto driven = [&](const std::string& log, const std::string& option)
    {
        const std::string file = place.path(log);
        EXPECT_TRUE(succeeds(runTrainer({"drive", kStreet, "--headless", "--vehicle", kDriven, "--length",
                                         "150", "--duration", "8", "--csv_logger", file, option, inputs})));
        return bytesOf(file);
    };
    const std::string first = driven("first.csv", "--record-inputs"),
                      second = driven("second.csv", "--record-inputs");
    EXPECT_GT(first.size(), 10000U);
    EXPECT_EQ(first, second);
    EXPECT_EQ(first, driven("replayed.csv", "--inputs"));
}

TEST(Drive, OnIceItComesLessFar)
{
    const auto drivenM = [](const std::string& surface)
    {
        const ProgramRun run = runTrainer({"drive", kStreet, "--headless", "--vehicle", kDriven, "--length",
                                           "200", "--duration", "6", "--surface", surface});
        EXPECT_TRUE(succeeds(run)) << run.text();
        const std::size_t driven = run.output.find("driven"), at = run.output.find(" s, ", driven);
        return at == std::string::npos ? 0.0 : std::atof(run.output.c_str() + at + 4);
    };
    const double dry = drivenM("asphalt");
    EXPECT_GT(dry, 20.0);
    EXPECT_LT(drivenM("ice"), 0.9 * dry);
}

TEST(Drive, SaysWhatIsWrong)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runTrainer({"drive", "/nowhere.xodr", "--vehicle", kDriven}), 1, "trainer",
                          {"/nowhere.xodr"}));
    EXPECT_TRUE(failsWith(runTrainer({"drive", kStreet, "--headless", "--vehicle", "/nowhere.xml"}), 1,
                          "trainer", {"/nowhere.xml", "no such file"}));
    EXPECT_TRUE(failsWith(runTrainer({"drive", kStreet, "--headless", "--surface", "mud"}), 2, "trainer",
                          {"mud", "gravel"}));
}

} // namespace
