// SPDX-License-Identifier: Apache-2.0
// `trainer play` and `trainer check` on a file of parameter-value distributions.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

/// A scenario of a quarter of a second whose speed is a parameter, and three speeds for it. Returns the file
/// of the speeds.
std::string writeSpeeds(const Workplace& place, const std::string& parameter = "speed")
{
    simulation::ScenarioText text;
    text.declarations =
        "<ParameterDeclarations><ParameterDeclaration name=\"speed\" parameterType=\"double\" "
        "value=\"1\"/></ParameterDeclarations>";
    text.privates = simulation::teleport("<WorldPosition x=\"0\" y=\"0\"/>") +
                    with(simulation::speedAction(15.0), "AbsoluteTargetSpeed value=\"15.000000\"",
                         "AbsoluteTargetSpeed value=\"$speed\"");
    text.stop = simulation::stopAt(0.25);
    place.write("drive.xosc", text.text());
    return place.write(
        "speeds.xosc",
        "<OpenSCENARIO>" + text.header +
            "<ParameterValueDistribution><ScenarioFile filepath=\"drive.xosc\"/><Deterministic>"
            "<DeterministicSingleParameterDistribution parameterName=\"" +
            parameter +
            "\"><DistributionSet><Element value=\"4\"/><Element value=\"8\"/><Element "
            "value=\"12\"/></DistributionSet>"
            "</DeterministicSingleParameterDistribution></Deterministic></ParameterValueDistribution></"
            "OpenSCENARIO>");
}

std::string contentOf(const std::string& file)
{
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(VariationsPlay, ListsTheVariations)
{
    const Workplace place;
    const ProgramRun run = runTrainer({"play", writeSpeeds(place), "--list-variations"});
    EXPECT_TRUE(succeeds(run)) << run.text();
    EXPECT_EQ(run.output,
              "variation 1 of 3: speed=4\nvariation 2 of 3: speed=8\nvariation 3 of 3: speed=12\n");
}

TEST(VariationsPlay, PlaysThemAllAndOneAlone)
{
    const Workplace place;
    const std::string speeds = writeSpeeds(place), log = place.path("log.csv");
    EXPECT_TRUE(succeeds(runTrainer({"play", speeds, "--headless", "--csv_logger", log})));
    EXPECT_TRUE(
        succeeds(runTrainer({"play", speeds, "--headless", "--variation", "2", "--csv_logger", log})));
    EXPECT_EQ(contentOf(log), contentOf(place.path("log-2.csv")));
    EXPECT_NE(contentOf(log), contentOf(place.path("log-1.csv")));
    EXPECT_NE(contentOf(log).find("8.000000, "), std::string::npos);
    EXPECT_NE(contentOf(place.path("log-3.csv")).find("12.000000, "), std::string::npos);
}

TEST(VariationsPlay, RefusesWhatThereIsNot)
{
    const Workplace place;
    const std::string speeds = writeSpeeds(place);
    EXPECT_TRUE(failsWith(runTrainer({"play", speeds, "--headless", "--variation", "4"}), 1, "trainer",
                          {speeds, "no variation 4", "from 1 to 3"}));
    EXPECT_TRUE(failsWith(runTrainer({"play", place.path("drive.xosc"), "--headless", "--variation", "1"}), 1,
                          "trainer", {"drive.xosc", "without --variation"}));
    const std::string wrong = writeSpeeds(place, "sped");
    EXPECT_TRUE(failsWith(runTrainer({"play", wrong, "--headless"}), 1, "trainer",
                          {"drive.xosc:", "no parameter sped"}));
    const ProgramRun checked = runTrainer({"check", wrong});
    EXPECT_TRUE(failsWith(checked, 1, "trainer", {"1 problem"})) << checked.text();
}

TEST(VariationsPlay, CheckTakesSeveralFilesAndTellsWhatTheyHave)
{
    const Workplace place;
    const std::string speeds = writeSpeeds(place), json = place.path("check.json");
    const std::string odd =
        place.write("odd.xosc", with(contentOf(place.path("drive.xosc")), "<RoadNetwork/>",
                                     "<RoadNetwork><UsedArea/></RoadNetwork>"));
    const ProgramRun run = runTrainer({"check", speeds, odd, "--json", json});
    EXPECT_TRUE(succeeds(run)) << run.text();
    EXPECT_NE(run.output.find("UsedArea is not supported; instead: "), std::string::npos) << run.text();
    EXPECT_TRUE(failsWith(runTrainer({"check", odd, "--strict"}), 1, "trainer", {"1 problem"}));
    const std::string told = contentOf(json);
    for (const char* part :
         {"\"kind\": \"not supported\"", "\"DistributionSet\": 1", "\"TeleportAction\": 1"})
        EXPECT_NE(told.find(part), std::string::npos) << part << told;
    EXPECT_TRUE(failsWith(runTrainer({"check"}), 2, "trainer", {"no scenario"}));
}

} // namespace
