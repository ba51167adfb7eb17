// SPDX-License-Identifier: Apache-2.0
// Who has an entity: a controller with physics from its activation to its deactivation, in the domains that
// it is given; else the scenario.
#include <cmath>
#include <filesystem>
#include <fstream>

#include "ControlPlay.h"

namespace
{

using namespace controlplay;
using simulation::event;
using simulation::speedAction;
using simulation::story;
using simulation::timeCondition;

std::string laneChange(int lane, double durationS)
{
    return "<PrivateAction><LateralAction><LaneChangeAction><LaneChangeActionDynamics "
           "dynamicsShape=\"sinusoidal\" "
           "dynamicsDimension=\"time\" value=\"" +
           std::to_string(durationS) + "\"/><LaneChangeTarget><AbsoluteTargetLane value=\"" +
           std::to_string(lane) +
           "\"/></LaneChangeTarget></LaneChangeAction></LateralAction></PrivateAction>";
}

TEST(ScenarioControl, ADriverKeepsTheSpeedOfTheScenarioInTheMiddleOfItsLane)
{
    const auto player = played(driven(20.0), 30.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).speedMps, 20.0, 0.3);
    EXPECT_NEAR(ego(*player).position.x, 100.0 + 20.0 * 30.0, 10.0);
    EXPECT_NEAR(ego(*player).position.y, -1.75, 0.05);
    EXPECT_TRUE(ego(*player).isOnGround);
    // By itself: wheels turn, and the springs give way.
    EXPECT_TRUE(ego(*player).wheelTurnDeg);
    EXPECT_NE(ego(*player).position.z, 0.0);
    EXPECT_TRUE(player->notes().empty());
}

TEST(ScenarioControl, WithoutActivationTheScenarioMovesTheEntity)
{
    simulation::ScenarioText text = driven(20.0);
    text.privates = onLane(100.0) + speedAction(20.0);
    const auto player = played(text, 30.0);
    ASSERT_TRUE(player);
    EXPECT_DOUBLE_EQ(ego(*player).speedMps, 20.0);
    EXPECT_FALSE(ego(*player).wheelTurnDeg);
}

TEST(ScenarioControl, AControllerIsFoundByItsKindWhateverItsName)
{
    for (const std::string kind : {"Driver", "SomebodyElse"})
    {
        simulation::ScenarioText text = driven(20.0, property("kind", kind), "me");
        const auto player = played(text, 2.0);
        ASSERT_TRUE(player);
        EXPECT_EQ(ego(*player).wheelTurnDeg.has_value(), kind == "Driver") << kind;
    }
}

TEST(ScenarioControl, AControllerMayBeAssignedByAnAction)
{
    simulation::ScenarioText text = driven(20.0);
    text.entities = "<ScenarioObject name=\"Ego\">" + simulation::kCar + "</ScenarioObject>";
    text.privates = onLane(100.0) + speedAction(20.0);
    const std::string assigned =
        "<PrivateAction><ControllerAction><AssignControllerAction activateLateral=\"true\" "
        "activateLongitudinal=\"true\"><Controller name=\"Driver\"><Properties>" +
        property("vehicle", kCarFile) +
        "</Properties></Controller></AssignControllerAction></ControllerAction></PrivateAction>";
    text.stories = story(event("assign", assigned, timeCondition(3.0)));
    auto player = played(text, 2.9);
    ASSERT_TRUE(player);
    EXPECT_FALSE(ego(*player).wheelTurnDeg);
    playTo(*player, 10.0);
    EXPECT_TRUE(ego(*player).wheelTurnDeg);
    EXPECT_NEAR(ego(*player).position.x, 100.0 + 20.0 * 10.0, 4.0);
    // Its properties are checked before the play, too.
    text.stories = story(event("assign", assigned, timeCondition(3.0)));
    text.stories.replace(text.stories.find(kCarFile), kCarFile.size(), "nothing.xml");
    EXPECT_FALSE(opened(text));
}

TEST(ScenarioControl, AControllerMayStandInACatalogue)
{
    const auto folder = std::filesystem::path(testing::TempDir()) / "controller_catalogue_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "Controllers.xosc")
        << R"(<OpenSCENARIO><FileHeader revMajor="1" revMinor="3" date="d" description="d" author="a"/><Catalog name="Controllers">)"
        << R"(<Controller name="calm"><ParameterDeclarations><ParameterDeclaration name="mps" parameterType="double" value="9"/></ParameterDeclarations><Properties>)"
        << property("kind", "Driver") << property("vehicle", kCarFile) << property("speed", "$mps")
        << "</Properties></Controller></Catalog></OpenSCENARIO>";
    simulation::ScenarioText text = driven(9.0);
    text.catalogs =
        R"(<CatalogLocations><ControllerCatalog><Directory path="."/></ControllerCatalog></CatalogLocations>)";
    text.entities =
        "<ScenarioObject name=\"Ego\">" + simulation::kCar +
        R"(<ObjectController><CatalogReference catalogName="Controllers" entryName="calm"><ParameterAssignments>
<ParameterAssignment parameterRef="mps" value="14"/></ParameterAssignments></CatalogReference></ObjectController></ScenarioObject>)";
    text.stop = simulation::stopAt(1000.0);
    std::ofstream(folder / "test.xosc") << text.text();
    auto parsed = simulation::readScenario(folder / "test.xosc");
    ASSERT_TRUE(parsed) << parsed.error().message();
    auto player = begunPlay(std::move(parsed->scenario));
    ASSERT_TRUE(player) << player.error().message();
    playTo(**player, 30.0);
    EXPECT_TRUE(ego(**player).wheelTurnDeg);
    EXPECT_NEAR(ego(**player).speedMps, 14.0, 0.3);
    std::filesystem::remove_all(folder);
}

TEST(ScenarioControl, SpeedActionsAreWishesToTheDriver)
{
    simulation::ScenarioText text = driven(20.0);
    text.stories = story(event("slower", speedAction(12.0), timeCondition(5.0)));
    auto player = played(text, 5.5);
    ASSERT_TRUE(player);
    EXPECT_GT(ego(*player).speedMps, 18.0); // a step would be there
    playTo(*player, 30.0);
    EXPECT_NEAR(ego(*player).speedMps, 12.0, 0.3);
}

TEST(ScenarioControl, DeactivationGivesTheEntityBackAsItMoves)
{
    simulation::ScenarioText text = driven(20.0);
    text.stories = story(event("back", activate("false", "false"), timeCondition(10.0)) +
                         event("step", speedAction(7.0), timeCondition(12.0)));
    auto player = played(text, 10.02);
    ASSERT_TRUE(player);
    const double speed = ego(*player).speedMps, x = ego(*player).position.x;
    playTo(*player, 11.02);
    EXPECT_DOUBLE_EQ(ego(*player).speedMps, speed);
    EXPECT_NEAR(ego(*player).position.x, x + speed, 1e-6);
    EXPECT_NEAR(ego(*player).position.y, -1.75, 0.05);
    playTo(*player, 12.02);
    EXPECT_DOUBLE_EQ(ego(*player).speedMps, 7.0);
}

TEST(ScenarioControl, TheScenarioDrivesAndTheDriverSteersWithLateralAlone)
{
    simulation::ScenarioText text = driven(20.0);
    text.privates = onLane(100.0) + speedAction(20.0) + activate("false", "true");
    text.stories = story(event("slower", speedAction(10.0, "linear", "time", 20.0), timeCondition(5.0)));
    const auto player = played(text, 15.0);
    ASSERT_TRUE(player);
    // Half of the way from 20 to 10 m/s.
    EXPECT_NEAR(ego(*player).speedMps, 15.0, 0.6);
    EXPECT_TRUE(ego(*player).wheelTurnDeg);
}

TEST(ScenarioControl, TheScenarioSteersAndTheDriverHasThePedalsWithLongitudinalAlone)
{
    for (const bool isLateral : {false, true})
    {
        simulation::ScenarioText text = driven(20.0);
        text.privates = onLane(100.0) + speedAction(20.0) + activate("true", isLateral ? "true" : "false");
        text.stories = story(event("left", laneChange(1, 5.0), timeCondition(3.0)));
        const auto player = played(text, 12.0);
        ASSERT_TRUE(player);
        EXPECT_NEAR(ego(*player).position.y, isLateral ? -1.75 : 1.75, 0.15);
        EXPECT_NEAR(ego(*player).speedMps, 20.0, 0.5);
    }
}

TEST(ScenarioControl, ATeleportBeginsAnewThere)
{
    simulation::ScenarioText text = driven(20.0);
    text.stories = story(event("away", onLane(2000.0), timeCondition(5.0)));
    auto player = played(text, 5.03);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).position.x, 2000.0, 2.0);
    playTo(*player, 10.0);
    EXPECT_NEAR(ego(*player).position.x, 2000.0 + 5.0 * 20.0, 4.0);
    EXPECT_TRUE(ego(*player).wheelTurnDeg);
}

TEST(ScenarioControl, ADriverFollowsTheTrajectoryThatRunsWhenItBegins)
{
    simulation::ScenarioText text = driven(10.0);
    // A quarter of a circle of 60 m to the left.
    std::string vertices;
    for (int i = 0; i <= 30; ++i)
    {
        const double angle = i / 30.0 * std::acos(0.0);
        vertices += simulation::vertex("<WorldPosition x=\"" + std::to_string(60.0 * std::sin(angle)) +
                                       "\" y=\"" + std::to_string(60.0 - 60.0 * std::cos(angle)) + "\"/>");
    }
    text.privates = simulation::teleport(R"(<WorldPosition x="0" y="0" h="0"/>)") + speedAction(10.0) +
                    simulation::followTrajectory(vertices) + activate("true", "true");
    Stage stage;
    stage.roads = nullptr;
    const auto player = played(text, 7.0, stage);
    ASSERT_TRUE(player);
    const double away = std::hypot(ego(*player).position.x, ego(*player).position.y - 60.0);
    EXPECT_NEAR(away, 60.0, 0.5);
    EXPECT_GT(ego(*player).headingDeg, 45.0);
}

TEST(ScenarioControl, DriversKeepTheirDistanceToEachOther)
{
    simulation::ScenarioText text = driven(25.0);
    text.entities += "<ScenarioObject name=\"Slow\">" + simulation::kCar + "</ScenarioObject>";
    text.globals = R"(<Private entityRef="Slow">)" + onLane(180.0) + speedAction(10.0) + "</Private>";
    const auto player = played(text, 40.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).speedMps, 10.0, 0.5);
    const double gapM = player->entities()[1].position.x - ego(*player).position.x - 5.0;
    EXPECT_GT(gapM, 10.0);
    EXPECT_LT(gapM, 30.0);
    EXPECT_TRUE(ego(*player).collidesWith.empty());
}

bool isLit(const simulation::EntityState& state, const std::string& lamp)
{
    const auto found = state.lamps.find(lamp);
    return found != state.lamps.end() && found->second.isLit;
}

TEST(ScenarioControl, LampsFollowDuskAndChangesOfLane)
{
    for (const bool isNight : {false, true})
    {
        simulation::ScenarioText text = driven(20.0);
        text.globals =
            std::string(
                "<GlobalAction><EnvironmentAction><Environment name=\"e\"><TimeOfDay animation=\"false\" "
                "dateTime=\"2024-06-21T") +
            (isNight ? "00" : "12") + ":00:00Z\"/></Environment></EnvironmentAction></GlobalAction>";
        text.privates = onLane(100.0) + speedAction(20.0) + activate("true", "false");
        text.stories = story(event("left", laneChange(1, 4.0), timeCondition(3.0)));
        auto player = opened(text);
        ASSERT_TRUE(player);
        EXPECT_EQ(isLit(ego(**player), "lowBeam"), isNight) << "before the first step";
        int left = 0, right = 0;
        double firstS = 1e9;
        while ((*player)->timeS() < 15.0)
        {
            (*player)->step();
            if (isLit(ego(**player), "indicatorLeft")) firstS = std::min(firstS, (*player)->timeS());
            left += isLit(ego(**player), "indicatorLeft");
            right += isLit(ego(**player), "indicatorRight");
        }
        EXPECT_EQ(isLit(ego(**player), "lowBeam"), isNight);
        EXPECT_GT(left, 50);
        EXPECT_LT(left, 500); // it is there after some seconds
        EXPECT_EQ(right, 0);
        EXPECT_GT(firstS, 3.0);
        EXPECT_LT(firstS, 6.0);
    }
}

TEST(ScenarioControl, AHeadLampSwitchComesBeforeTheDark)
{
    for (const bool isNight : {false, true})
    {
        const auto file = std::filesystem::path(testing::TempDir()) / "switch-in-scenario.txt";
        std::ofstream(file) << "osgtrainer-inputs 1\ncolumns time lights\n0 " << (isNight ? -1 : 1) << "\n";
        simulation::ScenarioText text = driven(20.0, property("inputs", file.string()), "RecordedInputs");
        text.globals =
            std::string(
                "<GlobalAction><EnvironmentAction><Environment name=\"e\"><TimeOfDay animation=\"false\" "
                "dateTime=\"2024-06-21T") +
            (isNight ? "00" : "12") + ":00:00Z\"/></Environment></EnvironmentAction></GlobalAction>";
        const auto player = played(text, 1.0);
        ASSERT_TRUE(player);
        EXPECT_EQ(isLit(ego(*player), "lowBeam"), !isNight);
    }
}

/// Ego's states at whole seconds, with a clock of the scene.
std::vector<simulation::EntityState> everySecond(const simulation::FixedClock& clock)
{
    Stage stage;
    stage.clock = clock;
    simulation::ScenarioText text = driven(18.0, property("speed", "25"));
    auto player = opened(text, stage);
    EXPECT_TRUE(player);
    std::vector<simulation::EntityState> states;
    for (int second = 1; second <= 20; ++second)
    {
        playTo(**player, second);
        states.push_back(ego(**player));
    }
    return states;
}

TEST(ScenarioControl, StatesOfACarDoNotDependOnTheStepOfTheScene)
{
    const auto fine = everySecond(simulation::FixedClock(120));
    for (const int rate : {10, 24, 100, 144})
    {
        const auto other = everySecond(simulation::FixedClock(rate));
        for (std::size_t i = 0; i < fine.size(); ++i)
        {
            EXPECT_EQ(other[i].position, fine[i].position) << rate << " steps, second " << i + 1;
            EXPECT_EQ(other[i].headingDeg, fine[i].headingDeg);
            EXPECT_EQ(other[i].speedMps, fine[i].speedMps);
        }
    }
}

} // namespace
