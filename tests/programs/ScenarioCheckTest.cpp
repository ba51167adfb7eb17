// SPDX-License-Identifier: Apache-2.0
// `trainer check`: everything that is wrong with a scenario, each with its line.
#include <algorithm>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

TEST(ScenarioCheck, ListsEveryProblemWithItsLine)
{
    const Workplace place;
    std::string text = driveText("hill.tif");
    text = with(text, "<FileHeader revMajor=\"1\"", "<FileHeader revMajor=\"7\"");
    text = with(text, "x=\"-600\"", "x=\"far\"");
    text = with(text, "<Storyboard>\n", "<Storyboard>\n<Prologue/>\n");
    text = with(text, "<StopTrigger>", "\n\n<StopTrigger>");
    text = with(text, "<SimulationTimeCondition ", "<MoonPhaseCondition ");
    const std::string file = place.write("bad.xosc", text);

    const ProgramRun run = runTrainer({"check", file});
    EXPECT_TRUE(failsWith(run, 1, "trainer", {file + ": "}));
    const std::vector<std::string> found = linesOf(run.output);
    for (const char* fault : {"revMajor=\"7\"", "x=\"far\"", "<Prologue", "<MoonPhaseCondition"})
    {
        const std::size_t at = text.find(fault);
        ASSERT_NE(at, std::string::npos) << fault;
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        const std::string start = file + ":" + std::to_string(line) + ": ";
        EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                [&](const std::string& words) { return words.starts_with(start); }))
            << fault << " is not said to be in line " << line << "\n"
            << run.text();
    }
    EXPECT_NE(run.errors.find(std::to_string(found.size()) + " problems"), std::string::npos) << run.text();
    EXPECT_TRUE(failsWith(runTrainer({"play", file}), 1, "trainer", {file + ":"}))
        << "play says the first alone";
    EXPECT_EQ(run.output.find("trainer check"), std::string::npos) << "the check recommends itself";
}

TEST(ScenarioCheck, SaysNothingOfAGoodScenario)
{
    const Workplace place;
    const ProgramRun run = runTrainer({"check", place.write("good.xosc", driveText("hill.tif"))});
    EXPECT_TRUE(succeeds(run));
    EXPECT_EQ(run.output + run.errors, "");
}

TEST(ScenarioCheck, SaysNothingOfASavedTour)
{
    const Workplace place;
    const std::string saved = place.path("tour.xosc");
    EXPECT_TRUE(
        succeeds(runTrainer({"tour", place.hill(), "--frames", "1", "--size", "64x36", "--save", saved})));
    const ProgramRun run = runTrainer({"check", saved});
    EXPECT_TRUE(succeeds(run));
    EXPECT_EQ(run.output, "");
}

} // namespace
