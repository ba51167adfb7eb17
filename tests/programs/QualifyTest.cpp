// SPDX-License-Identifier: Apache-2.0
// `trainer qualify`: a table of figures, and an exit code that tells whether all are reached.
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

const char* const kAircraft = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";

nlohmann::json readTable(const std::string& file)
{
    std::ifstream stream(file);
    return nlohmann::json::parse(stream, nullptr, false);
}

TEST(Qualify, WritesEveryFigureWithItsSource)
{
    const Workplace place;
    const std::string file = place.path("figures.json");
    EXPECT_TRUE(succeeds(runTrainer({"qualify", "flight", "--aircraft", kAircraft, "--json", file})));
    const nlohmann::json table = readTable(file);
    ASSERT_TRUE(table.contains("checks"));
    ASSERT_GE(table["checks"].size(), 5U);
    for (const nlohmann::json& check : table["checks"])
    {
        for (const char* member : {"name", "value", "unit", "expected", "tolerance", "source"})
            EXPECT_TRUE(check.contains(member)) << check.dump();
        EXPECT_EQ(check["pass"], true) << check.dump();
    }
}

// The control: with a third of its fuel's heat it climbs no more.
TEST(Qualify, FailsForAnAircraftThatDoesNotReachThem)
{
    const Workplace place;
    std::ifstream stream(kAircraft);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    text = with(text, "heatingValueJPerKg=\"43.5e6\"", "heatingValueJPerKg=\"30e6\"");
    const std::string file = place.path("figures.json");
    const ProgramRun run =
        runTrainer({"qualify", "flight", "--aircraft", place.write("weak.xml", text), "--json", file});
    EXPECT_EQ(run.exitCode, 1) << run.text();
    EXPECT_NE(run.output.find("FAIL  climb"), std::string::npos) << run.text();
}

TEST(Qualify, ExplainsAFileThatIsNone)
{
    EXPECT_TRUE(failsWith(runTrainer({"qualify", "flight", "--aircraft", "/nowhere.xml"}), 1, "trainer",
                          {"/nowhere.xml", "no such file"}));
}

const char* const kCar = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";

TEST(QualifyDrive, WritesEveryFigureWithItsSource)
{
    const Workplace place;
    const std::string file = place.path("figures.json");
    EXPECT_TRUE(
        succeeds(runTrainer({"qualify", "drive", "--stand", "10", "--vehicle", kCar, "--json", file})));
    const nlohmann::json table = readTable(file);
    ASSERT_TRUE(table.contains("checks"));
    ASSERT_EQ(table["checks"].size(), 12U);
    for (const nlohmann::json& check : table["checks"])
    {
        for (const char* member : {"name", "value", "unit", "expected", "tolerance", "source"})
            EXPECT_TRUE(check.contains(member)) << check.dump();
        EXPECT_EQ(check["pass"], true) << check.dump();
    }
}

// The control: with weak brakes it stops late.
TEST(QualifyDrive, FailsForAVehicleThatDoesNotReachThem)
{
    const Workplace place;
    std::ifstream stream(kCar);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    text = with(text, "mostNm=\"7000\"", "mostNm=\"1500\"");
    const ProgramRun run =
        runTrainer({"qualify", "drive", "--stand", "10", "--vehicle", place.write("weak.xml", text)});
    EXPECT_EQ(run.exitCode, 1) << run.text();
    EXPECT_NE(run.output.find("FAIL  mid-size car: 100-0"), std::string::npos) << run.text();
}

TEST(QualifyDrive, ExplainsAFileThatIsNone)
{
    EXPECT_TRUE(failsWith(runTrainer({"qualify", "drive", "--vehicle", "/nowhere.xml"}), 1, "trainer",
                          {"/nowhere.xml", "no such file"}));
}

/// What is known to be missed; docs/measurements/light.md says why.
const std::set<std::string> kMissed{"stars: direction, worst of ten in 2049",
                                    "stars: faintest seen, fastest change at the equator",
                                    "sun: rise and set, worst of twelve"};

TEST(QualifyLight, WritesEveryFigureWithItsSource)
{
    const Workplace place;
    const std::string file = place.path("figures.json");
    const ProgramRun run = runTrainer({"qualify", "light", "--json", file});
    EXPECT_EQ(run.exitCode, kMissed.empty() ? 0 : 1) << run.text();
    const nlohmann::json table = readTable(file);
    ASSERT_TRUE(table.contains("figures")) << run.text();
    std::set<std::string> missed, goals;
    for (const nlohmann::json& figure : table["figures"])
    {
        for (const char* member : {"goal", "name", "value", "unit", "least", "most", "source", "pass"})
            EXPECT_TRUE(figure.contains(member)) << figure.dump();
        goals.insert(figure["goal"]);
        if (!figure["pass"]) missed.insert(figure["name"]);
    }
    EXPECT_EQ(missed, kMissed) << run.text();
    EXPECT_EQ(goals, (std::set<std::string>{"N10", "N3", "N4", "N6", "N7", "N8", "N9"}));
    for (const nlohmann::json& goal : table["notMeasured"])
        EXPECT_FALSE(goal["why"].get<std::string>().empty()) << goal.dump();
    EXPECT_NE(run.output.find("none  N1"), std::string::npos) << run.text();
}

TEST(QualifyLight, ExplainsAFileThatCannotBeWritten)
{
    EXPECT_TRUE(failsWith(runTrainer({"qualify", "light", "--json", "/nowhere/figures.json"}), 1, "trainer",
                          {"/nowhere"}));
}

} // namespace
