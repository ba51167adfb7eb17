// SPDX-License-Identifier: Apache-2.0
// `trainer play --drive`: a person in an entity of a scenario, by recorded inputs and in a window.
#include <sstream>

#include "Playing.h"
#include "WindowRun.h"

namespace
{

/// Ego at 15 m/s on level ground, and Other that stands 80 m ahead, a metre aside; it ends after 12 s.
std::string meeting(const std::string& controller = "", const std::string& stories = "")
{
    simulation::ScenarioText text;
    text.entities =
        "<ScenarioObject name=\"Ego\">" + simulation::kCar + controller +
        "</ScenarioObject><ScenarioObject name=\"Other\">" + simulation::kCar +
        "</ScenarioObject><ScenarioObject name=\"Walker\"><Pedestrian name=\"w\" mass=\"70\" "
        "pedestrianCategory=\"pedestrian\" model=\"\"><BoundingBox><Center x=\"0\" y=\"0\" z=\"0.9\"/>"
        "<Dimensions width=\"0.5\" length=\"0.4\" height=\"1.8\"/></BoundingBox><Properties/>"
        "</Pedestrian></ScenarioObject>";
    text.globals = "<Private entityRef=\"Other\">" +
                   simulation::teleport(R"(<WorldPosition x="80" y="1" h="0"/>)") +
                   "</Private><Private entityRef=\"Walker\">" +
                   simulation::teleport(R"(<WorldPosition x="10" y="30" h="0"/>)") + "</Private>";
    text.privates =
        simulation::teleport(R"(<WorldPosition x="0" y="0" h="0"/>)") + simulation::speedAction(15.0);
    text.stories = stories;
    text.stop = simulation::stopAt(12.0);
    return text.text();
}

const std::string kPush =
    "osgtrainer-inputs 1\ncolumns time throttle steering gear\n0 0.3 0 3\n1 0.3 0.002 3\n2 0.3 0 3\n";

/// The rows of a table up to a time, without the lines above.
std::string rowsUntil(const std::string& csv, double timeS)
{
    std::istringstream lines(csv);
    std::string line, rows;
    while (std::getline(lines, line))
    {
        const std::size_t comma = line.find(", ");
        if (comma == std::string::npos || line.empty() || !std::isdigit(static_cast<unsigned char>(line[0])))
            continue;
        if (std::stod(line.substr(comma + 2)) < timeS + 1e-6) rows += line + "\n";
    }
    return rows;
}

TEST(DriveInScenario, IsTheSameInEveryRunAndAtEveryRateOfPictures)
{
    const Workplace place;
    const std::vector<std::string> play{
        "play", place.write("meet.xosc", meeting()), "--drive", "Ego", "--vehicle", kSeatCar};
    const std::string inputs = place.write("push.txt", kPush), again = place.path("again.txt");
    const auto played = [&](const std::string& name, const std::vector<std::string>& more)
    {
        const std::string log = place.path(name + ".csv");
        const ProgramRun run = runTrainer(with(with(play, {"--csv_logger", log}), more));
        EXPECT_TRUE(succeeds(run)) << run.text();
        EXPECT_NE(run.output.find("into a vehicle (Other)"), std::string::npos) << run.text();
        return rowsUntil(allOf(log), 7.5);
    };
    const std::string headless =
        played("headless", {"--headless", "--inputs", inputs, "--record-inputs", again});
    EXPECT_GT(headless.size(), 100'000U);
    EXPECT_NE(headless.find("person"), std::string::npos);
    EXPECT_EQ(headless, played("replayed", {"--headless", "--inputs", again}));
    // Pictures that lie between two steps.
    EXPECT_EQ(headless,
              played("pictures", {"--inputs", inputs, "--fps", "7", "--frames", "56", "--size", "32x18",
                                  "--samples", "1", "--shadows", "off", "--quality", "low"}));
    // The control: other inputs.
    std::string other = kPush;
    other.replace(other.find("0.002"), 5, "0.003");
    EXPECT_NE(headless, played("other", {"--headless", "--inputs", place.write("other.txt", other)}));
}

TEST(DriveInScenario, TellsMistakesBeforeAnythingIsOpened)
{
    const Workplace place;
    const std::string scenario = place.write("meet.xosc", meeting()), inputs = place.write("push.txt", kPush);
    const auto fails = [&](const std::vector<std::string>& more, const std::vector<std::string>& words) {
        return failsWith(runTrainer(with({"play", scenario}, more)), 1, "trainer", words);
    };
    EXPECT_TRUE(fails({"--headless", "--drive", "Egoo", "--inputs", inputs}, {"'Egoo'", "Ego, Other"}));
    EXPECT_TRUE(fails({"--drive", "Walker", "--inputs", inputs, "--frames", "1"},
                      {"neither a vehicle", "Ego, Other"}));
    EXPECT_TRUE(fails({"--headless", "--drive", "Ego"}, {"--drive", "--inputs FILE"}));
    EXPECT_TRUE(fails({"--drive", "Ego", "--frames", "1"}, {"--drive", "--inputs FILE"}));
    EXPECT_TRUE(fails({"--headless", "--inputs", inputs}, {"--inputs", "--drive ENTITY"}));
    EXPECT_TRUE(fails({"--headless", "--drive", "Ego", "--inputs", place.path("none.txt")}, {"none.txt"}));
    EXPECT_TRUE(fails({"--headless", "--drive", "Ego", "--inputs", inputs, "--vehicle", kSeatAircraft},
                      {"c172p.xml", "is an aircraft"}));
    EXPECT_TRUE(fails({"--headless", "--drive", "Ego", "--inputs", inputs, "--fixed_timestep", "0.01"},
                      {"--fixed_timestep", "1/120"}));
}

/// A storyboard that hands over and takes back; alone it is told that nobody sits there.
TEST(DriveInScenario, AManualControllerNeedsInputsAlone)
{
    const Workplace place;
    const std::string controller =
        "<ObjectController><Controller name=\"Manual\"><Properties/></Controller></ObjectController>";
    const auto activate = [](const char* is)
    {
        return std::string("<PrivateAction><ControllerAction><ActivateControllerAction longitudinal=\"") +
               is + "\" lateral=\"" + is + "\"/></ControllerAction></PrivateAction>";
    };
    const std::string scenario = place.write(
        "manual.xosc",
        meeting(
            controller,
            simulation::story(simulation::event("take", activate("true"), simulation::timeCondition(1.0)) +
                              simulation::event("back", activate("false"), simulation::timeCondition(3.0)))));
    const ProgramRun alone = runTrainer({"play", scenario, "--headless"});
    EXPECT_TRUE(succeeds(alone));
    EXPECT_NE(alone.output.find("nobody sits there, so the scenario moves it"), std::string::npos)
        << alone.text();
    const ProgramRun driven =
        runTrainer({"play", scenario, "--headless", "--inputs", place.write("push.txt", kPush)});
    EXPECT_TRUE(succeeds(driven));
    EXPECT_NE(driven.output.find("Ego at 1.00 s: the person takes over"), std::string::npos) << driven.text();
    EXPECT_NE(driven.output.find("Ego at 3.00 s: the person gives it back"), std::string::npos)
        << driven.text();
}

TEST(DriveInScenario, InAWindowTabTakesOverAndGivesBackAndItRepeats)
{
    if (!hasXvfb()) GTEST_SKIP() << "SKIPPED: no Xvfb; install the package xvfb";
    const Workplace place;
    const std::string keys = place.write(
        "drive.keys",
        "osgtrainer-keys 1\n0.5 tap Tab\n1 hold Up 1.5\n1.5 hold Left 0.25\n3 tap Tab\n5 tap Tab\n"
        "5.25 hold Down 1\n7 close\n");
    const std::string scenario = place.write("meet.xosc", meeting());
    const std::vector<std::string> play{"play", scenario, "--vehicle", kSeatCar};
    const ProgramRun run =
        inWindow(with(play, {"--keys", keys, "--picture-time", "0.25", "--csv_logger", place.path("hand.csv"),
                             "--record-inputs", place.path("hand.txt")}));
    ASSERT_TRUE(succeeds(run)) << run.text();
    EXPECT_NE(run.output.find("the person gives it back"), std::string::npos) << run.text();
    const std::string hand = allOf(place.path("hand.csv"));
    EXPECT_GT(hand.size(), 100'000U);
    EXPECT_TRUE(
        succeeds(runTrainer(with(play, {"--headless", "--drive", "Ego", "--inputs", place.path("hand.txt"),
                                        "--csv_logger", place.path("again.csv")}))));
    EXPECT_EQ(hand, allOf(place.path("again.csv")));
    EXPECT_NE(hand.find("person"), std::string::npos);
    EXPECT_NE(hand.find("scenario"), std::string::npos);
}

} // namespace
