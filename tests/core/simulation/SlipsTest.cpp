// SPDX-License-Identifier: Apache-2.0
// Slips in storyboards of others that leave one plain reading: it is taken, told with its line, and the play
// goes on.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "RoadPlay.h"
#include "simulation/road/ScenarioRoads.h"

namespace simulation
{
namespace
{

/// Ego at 10 m/s on lane -1 at 100 m; the event `go` sets 4 m/s at 1 s.
ScenarioText soundText()
{
    ScenarioText text;
    text.entities += "<ScenarioObject name=\"Lead\">" + kCar + "</ScenarioObject>";
    text.privates = roadplay::onLane(100.0) + speedAction(10.0);
    text.stories = story(event("go", speedAction(4.0), timeCondition(1.0)));
    text.stop = stopAt(2.0);
    return text;
}

struct Slip
{
    const char* name;
    const char* replaced; ///< in the text without slips
    const char* by;
    const char* what;    ///< of the message
    const char* instead; ///< of the message
};

class Slips : public testing::TestWithParam<Slip>
{
};

std::vector<Problem> slipsIn(const std::string& text)
{
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    return parsed ? parsed->problems : std::vector<Problem>();
}

/// The text of a scenario with a slip, played to 2 s.
std::unique_ptr<ScenarioPlayer> played(const std::string& text)
{
    auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    PlayerOptions options;
    options.clock = FixedClock::forStep(roadplay::kStepS);
    options.roads = roadplay::straight();
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return nullptr;
    roadplay::playTo(**player, 3.0);
    return std::move(*player);
}

TEST_P(Slips, AreToldAndTheOneReadingIsPlayed)
{
    std::string text = soundText().text();
    const std::size_t at = text.find(GetParam().replaced);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::string(GetParam().replaced).size(), GetParam().by);
    const auto problems = slipsIn(text);
    ASSERT_EQ(problems.size(), 1u) << (problems.empty() ? "" : problems.back().error.message());
    EXPECT_EQ(problems[0].kind, Problem::Kind::assumed);
    EXPECT_NE(problems[0].error.what.find(GetParam().what), std::string::npos) << problems[0].error.message();
    EXPECT_NE(problems[0].error.remedy.find(GetParam().instead), std::string::npos)
        << problems[0].error.message();
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    EXPECT_LE(std::abs(std::stol(problems[0].error.place.substr(10)) - line), 2);
    const auto player = played(text);
    ASSERT_TRUE(player);
    EXPECT_NEAR(player->timeS(), 2.0, 1e-9) << "the stop trigger";
    EXPECT_NEAR(player->entities()[0].speedMps, 4.0, 1e-9) << "the event";
    EXPECT_NEAR(player->entities()[0].position.x, 114.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(
    Table, Slips,
    testing::Values(
        Slip{"Author", " author=\"a\"", "", "FileHeader has no attribute author", "left empty"},
        Slip{"Date", " date=\"d\"", "", "FileHeader has no attribute date", "left empty"},
        Slip{"NameOfAnAction", " name=\"goAction\"", "", "Action has no attribute name", "left empty"},
        Slip{"NameOfAnEvent", "<Event name=\"go\"", "<Event", "Event has no attribute name", "left empty"},
        Slip{"NameOfAVehicle", "<Vehicle name=\"car\"", "<Vehicle", "Vehicle has no attribute name",
             "left empty"},
        Slip{"Performance", R"(<Performance maxSpeed="70" maxDeceleration="10" maxAcceleration="5"/>)", "",
             "Vehicle has no element Performance", "that of a usual car is taken"},
        Slip{"Priority", " priority=\"parallel\"", "", "Event has no attribute priority",
             "overwrite is taken"},
        Slip{"Edge", " conditionEdge=\"none\"", "", "Condition has no attribute conditionEdge",
             "none is taken"},
        Slip{"DimensionOfAStep", " dynamicsDimension=\"time\"", "",
             "SpeedActionDynamics has no attribute dynamicsDimension", "time is taken"},
        Slip{"ValueOfAStep", " value=\"0.000000\"", "", "SpeedActionDynamics has no attribute value",
             "0 is taken"},
        Slip{"EventWithoutAction", "<Event name=\"go\"",
             "<Event name=\"nothing\" priority=\"parallel\"/><Event name=\"go\"", "an Event has no Action",
             "it does nothing"},
        Slip{"EmptyControllerAction", "<PrivateAction>",
             "<PrivateAction><ControllerAction/></PrivateAction><PrivateAction>", "ControllerAction is empty",
             "nothing is done"},
        Slip{"ControllerOfNoCatalogue", "</Vehicle></ScenarioObject>",
             "</Vehicle><ObjectController><CatalogReference catalogName=\"c\" "
             "entryName=\"e\"/></ObjectController></ScenarioObject>",
             "the catalogue entry c/e does not exist", "the actions of the scenario move the entity"},
        Slip{"EnvironmentOfNoCatalogue", "<Actions>",
             "<Actions><GlobalAction><EnvironmentAction><CatalogReference catalogName=\"c\" "
             "entryName=\"e\"/></EnvironmentAction></GlobalAction>",
             "the catalogue entry c/e does not exist", "the environment stays as it is"}),
    [](const testing::TestParamInfo<Slip>& test) { return std::string(test.param.name); });

/// A usual car is 4.5 m long, 1.8 m wide, has its rear axle 0.95 m before its end and 2.7 m between the
/// axles; the box is 5 m by 2 m.
TEST(Slips, AxlesAreFittedIntoTheBox)
{
    std::string text = soundText().text();
    const std::size_t at = text.find("<Axles>");
    text.erase(at, text.find("</Axles>") + 8 - at);
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->problems.size(), 1u);
    EXPECT_EQ(parsed->problems[0].kind, Problem::Kind::assumed);
    EXPECT_NE(parsed->problems[0].error.message().find("no element Axles"), std::string::npos);
    const auto& car = std::get<Vehicle>(parsed->scenario.entities[0].object);
    const double scale = 5.0 / 4.5, end = car.box.centre.x - 2.5;
    EXPECT_NEAR(car.rearAxle.positionXM, end + 0.95 * scale, 1e-9);
    EXPECT_NEAR(car.frontAxle->positionXM - car.rearAxle.positionXM, 2.7 * scale, 1e-9);
    EXPECT_NEAR(car.rearAxle.trackWidthM, 0.86 * 2.0, 1e-9);
    EXPECT_NEAR(car.rearAxle.positionZM, 0.5 * car.rearAxle.wheelDiameterM, 1e-9);
}

/// Only a reference point that is moved is told.
TEST(Slips, AReferencePointOffTheRearAxleIsTold)
{
    for (const auto& [value, count] : {std::pair("2.5", 1u), std::pair("-1", 1u), std::pair("1e1", 1u),
                                       std::pair("0.0", 0u), std::pair("-0", 0u)})
    {
        ScenarioText text;
        const std::size_t at = text.entities.find("<Properties/>");
        text.entities.replace(at, 13,
                              "<Properties><Property name=\"refpoint_x_offset\" value=\"" +
                                  std::string(value) + "\"/></Properties>");
        const auto parsed = parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
        ASSERT_TRUE(parsed);
        ASSERT_EQ(parsed->problems.size(), count) << value;
        for (const Problem& problem : parsed->problems)
            EXPECT_NE(problem.error.message().find("refpoint_x_offset"), std::string::npos);
    }
}

TEST(Slips, ACategoryThatIsNoneIsTold)
{
    const auto toldOf = [](const char* category)
    {
        std::string text = soundText().text();
        const std::string was = "vehicleCategory=\"car\"";
        text.replace(text.find(was), was.size(), std::string("vehicleCategory=\"") + category + "\"");
        const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
        return parsed && parsed->problems.size() == 1 ? parsed->problems[0].error.message() : std::string();
    };
    EXPECT_NE(toldOf("trcuk").find("did you mean truck?"), std::string::npos);
    EXPECT_NE(toldOf("Bus").find("did you mean bus?"), std::string::npos);
    EXPECT_NE(toldOf("spaceship").find("it is taken for a car; write car"), std::string::npos);
    for (const char* good : {"car", "bus", "motorbike", "semitractor", "helicopter"})
        EXPECT_EQ(toldOf(good), "") << good;
}

TEST(Slips, WhatTheMotionHangsOnIsRefusedAsBefore)
{
    for (const auto& [good, bad] :
         {std::pair("dynamicsShape=\"step\"", "dynamicsShape=\"linear\" shape=\"\""),
          std::pair(" s=\"100.000000\"", ""), std::pair(" laneId=\"-1\"", ""),
          std::pair("<ScenarioObject name=\"Lead\"", "<ScenarioObject")})
    {
        std::string text = soundText().text();
        const std::size_t at = text.find(good);
        ASSERT_NE(at, std::string::npos) << good;
        text.replace(at, std::string(good).size(), bad);
        if (std::string(bad).starts_with("dynamicsShape"))
            text.replace(text.find(" value=\"0.000000\""), 17, ""); // of a change that takes time
        const auto problems = slipsIn(text);
        EXPECT_TRUE(std::any_of(problems.begin(), problems.end(),
                                [](const Problem& problem)
                                { return problem.kind == Problem::Kind::invalid; }))
            << bad;
    }
}

/// What versions from 1.1 on allow is no slip.
TEST(Slips, AnEmptyObjectControllerAndAnInitWithoutActionsAreNone)
{
    ScenarioText text = soundText();
    text.entities.insert(text.entities.find("</ScenarioObject>"), "<ObjectController/>");
    EXPECT_TRUE(slipsIn(text.text()).empty());
    std::string bare = text.text();
    const std::size_t from = bare.find("<Actions>"), to = bare.find("</Actions>") + 10;
    bare.erase(from, to - from);
    EXPECT_TRUE(slipsIn(bare).empty());
}

TEST(Slips, RelativePositionsWithoutDistancesAreAtTheEntity)
{
    for (const char* position :
         {"<RelativeLanePosition entityRef=\"Ego\"/>", "<RelativeRoadPosition entityRef=\"Ego\"/>",
          "<RelativeObjectPosition entityRef=\"Ego\"/>", "<RelativeWorldPosition entityRef=\"Ego\"/>"})
    {
        ScenarioText text = soundText();
        text.privates += "</Private><Private entityRef=\"Lead\">" + teleport(position);
        const auto problems = slipsIn(text.text());
        ASSERT_EQ(problems.size(), 2u) << position;
        EXPECT_EQ(problems[0].kind, Problem::Kind::assumed);
        const auto player = roadplay::played(text, 0.0);
        EXPECT_NEAR(player->entities()[1].position.x, 100.0, 1e-6) << position;
        EXPECT_NEAR(player->entities()[1].position.y, -1.75, 1e-6) << position;
    }
}

TEST(Slips, NumbersThatOnlyBoundMayHaveNoBound)
{
    for (const char* most : {"INF", "1e10", "1.7976931348623157e+308"})
    {
        ScenarioText text = soundText();
        text.entities.replace(text.entities.find("maxAcceleration=\"5\""), 19,
                              std::string("maxAcceleration=\"") + most + "\"");
        text.stop =
            std::string(
                "<StopTrigger><ConditionGroup><Condition name=\"c\" delay=\"0\" conditionEdge=\"none\">"
                "<ByValueCondition><SimulationTimeCondition rule=\"greaterThan\" value=\"") +
            most + "\"/></ByValueCondition></Condition></ConditionGroup></StopTrigger>";
        EXPECT_TRUE(slipsIn(text.text()).empty()) << most;
        EXPECT_NEAR(roadplay::played(text, 3.0)->timeS(), 3.0, 1e-9) << "it never stops";
    }
    ScenarioText text = soundText();
    text.privates = teleport("<WorldPosition x=\"INF\" y=\"0\"/>"); // the control: a place is no bound
    EXPECT_EQ(slipsIn(text.text()).at(0).kind, Problem::Kind::invalid);
}

TEST(Slips, AnOffsetWithoutDynamicsIsThereAtOnce)
{
    ScenarioText text = soundText();
    text.stories = story(event(
        "go",
        R"(<PrivateAction><LateralAction><LaneOffsetAction continuous="false"><LaneOffsetTarget><AbsoluteTargetLaneOffset value="0.5"/></LaneOffsetTarget></LaneOffsetAction></LateralAction></PrivateAction>)",
        timeCondition(1.0)));
    ASSERT_EQ(slipsIn(text.text()).size(), 1u);
    EXPECT_EQ(slipsIn(text.text())[0].kind, Problem::Kind::assumed);
    EXPECT_NEAR(roadplay::played(text, 1.0)->entities()[0].position.y, -1.75, 1e-9);
    EXPECT_NEAR(roadplay::played(text, 1.1)->entities()[0].position.y, -1.25, 1e-9);
}

TEST(Slips, AnOffsetWithoutSideAccelerationIsToldAndNotMade)
{
    const auto textWith = [](const char* most, const char* shape)
    {
        ScenarioText text = soundText();
        text.stories = story(event("go",
                                   std::string("<PrivateAction><LateralAction><LaneOffsetAction "
                                               "continuous=\"false\"><LaneOffsetActionDynamics "
                                               "dynamicsShape=\"") +
                                       shape + "\" maxLateralAcc=\"" + most +
                                       "\"/><LaneOffsetTarget><AbsoluteTargetLaneOffset "
                                       "value=\"0.5\"/></LaneOffsetTarget></LaneOffsetAction>"
                                       "</LateralAction></PrivateAction>",
                                   timeCondition(1.0)));
        return text;
    };
    for (const char* const shape : {"cubic", "linear", "sinusoidal", "step"})
        for (const char* const zero : {"0", "0.0", "-0"})
        {
            const ScenarioText text = textWith(zero, shape);
            ASSERT_EQ(slipsIn(text.text()).size(), 1u) << zero << shape;
            EXPECT_EQ(slipsIn(text.text())[0].kind, Problem::Kind::assumed);
            EXPECT_NEAR(roadplay::played(text, 3.0)->entities()[0].position.y, -1.75, 1e-9) << zero << shape;
        }
    for (const char* const most : {"1000000", "INF", "1e300", "1.7e308"})
    {
        const ScenarioText text = textWith(most, "cubic");
        EXPECT_TRUE(slipsIn(text.text()).empty()) << most;
        EXPECT_NEAR(roadplay::played(text, 3.0)->entities()[0].position.y, -1.25, 1e-9) << most;
    }
}

TEST(Slips, ATimingWithoutAnyTimeIsNone)
{
    const std::string far = "<WorldPosition x=\"50\" y=\"0\"/>", start = "<WorldPosition x=\"0\" y=\"0\"/>";
    ScenarioText text = soundText();
    text.stories.clear();
    text.privates = speedAction(10.0) + followTrajectory(vertex(start) + vertex(far), kTiming);
    ASSERT_EQ(slipsIn(text.text()).size(), 1u);
    EXPECT_EQ(slipsIn(text.text())[0].kind, Problem::Kind::assumed);
    EXPECT_NEAR(roadplay::played(text, 2.0)->entities()[0].position.x, 20.0, 1e-6) << "by its speed";
    text.privates = speedAction(10.0) + followTrajectory(vertex(start, "0") + vertex(far), kTiming);
    EXPECT_EQ(slipsIn(text.text()).at(0).kind, Problem::Kind::invalid) << "the control";
}

TEST(Slips, OfTwoVerticesAtOneTimeTheFirstIsKept)
{
    const auto at = [](double x, const char* time)
    { return vertex("<WorldPosition x=\"" + std::to_string(x) + "\" y=\"0\"/>", time); };
    ScenarioText text = soundText();
    text.stories.clear();
    text.privates = followTrajectory(at(0.0, "0") + at(10.0, "1") + at(11.0, "1") + at(20.0, "2"), kTiming);
    const auto problems = slipsIn(text.text());
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].kind, Problem::Kind::assumed);
    EXPECT_NE(problems[0].error.what.find("vertex 3"), std::string::npos) << problems[0].error.message();
    EXPECT_NEAR(roadplay::played(text, 1.5)->entities()[0].position.x, 15.0, 1e-6);
    text.privates = followTrajectory(at(0.0, "0") + at(10.0, "1") + at(11.0, "0.5"), kTiming);
    EXPECT_EQ(slipsIn(text.text()).at(0).kind, Problem::Kind::invalid) << "the control: times that fall";
}

class Files : public testing::Test
{
protected:
    void SetUp() override
    {
        folder = std::filesystem::path(testing::TempDir()) / "slips_test";
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder / name) << text;
    }

    std::filesystem::path folder;
};

TEST_F(Files, ACatalogueLocationMayNameTheFile)
{
    write("cars.xosc", "<OpenSCENARIO><FileHeader revMajor=\"1\" revMinor=\"0\" date=\"d\" description=\"d\" "
                       "author=\"a\"/><Catalog name=\"Cars\">" +
                           kCar + "</Catalog></OpenSCENARIO>");
    ScenarioText text = soundText();
    text.catalogs =
        R"(<CatalogLocations><VehicleCatalog><Directory path="cars.xosc"/></VehicleCatalog></CatalogLocations>)";
    text.entities =
        R"(<ScenarioObject name="Ego"><CatalogReference catalogName="Cars" entryName="car"/></ScenarioObject>)";
    write("scene.xosc", text.text());
    const auto parsed = readScenario(folder / "scene.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed) << parsed.error().message();
    EXPECT_TRUE(parsed->problems.empty()) << parsed->problems[0].error.message();
    EXPECT_EQ(parsed->scenario.entities.at(0).box().lengthM, 5.0);
}

/// What is said of the roads of a scenario; empty: nothing. Behind "refused: ", where it is not played.
std::string saidOfRoads(const std::string& logicFile, const std::filesystem::path& file,
                        WithoutRoads without = WithoutRoads::refused)
{
    Scenario scenario;
    scenario.roadNetwork.logicFile = logicFile;
    scenario.roadNetwork.logicLine = {7};
    const auto missing = missingFiles(scenario, file, without);
    if (!missing) return "refused: " + missing.error().message();
    return missing->roads ? missing->roads->message() : "";
}

TEST_F(Files, RoadsThatAreNotThereAreRefusedWithPlaceAndRemedy)
{
    const std::filesystem::path file = folder / "a.xosc";
    write("there.xodr", "");
    EXPECT_EQ(saidOfRoads("", file), "") << "it names none";
    EXPECT_EQ(saidOfRoads("there.xodr", file), "");
    EXPECT_EQ(saidOfRoads("there", file), "");
    for (const std::string name : {"gone.xodr", "roads/gone", "..\\roads\\gone", "Town10HD.xodr", "./gone"})
    {
        EXPECT_EQ(saidOfRoads(name, file), "refused: " + file.string() + ":7: the LogicFile " + name +
                                               " is not there; correct its path, or play without roads "
                                               "(--without-roads)");
        EXPECT_EQ(saidOfRoads(name, file, WithoutRoads::played),
                  file.string() + ":7: the LogicFile " + name +
                      " is not there; instead: there are no roads; correct its path");
    }
}

TEST_F(Files, ASceneThatIsNotThereIsTold)
{
    Scenario scenario;
    scenario.roadNetwork.sceneGraphFile = "gone.osgb";
    scenario.roadNetwork.sceneLine = {8};
    const auto missing = missingFiles(scenario, folder / "a.xosc", WithoutRoads::refused);
    ASSERT_TRUE(missing && missing->scene);
    EXPECT_EQ(missing->scene->place, (folder / "a.xosc").string() + ":8");
    write("gone.osgb", "");
    const auto found = missingFiles(scenario, folder / "a.xosc", WithoutRoads::refused);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->scene);
}

/// A bare name is that of a map which another program brings along: its storyboards come without networks.
TEST_F(Files, ATownThatIsNotThereLeavesAPlayWithoutRoads)
{
    Scenario scenario;
    scenario.roadNetwork.logicFile = "Town01";
    EXPECT_EQ(saidOfRoads("Town01", folder / "a.xosc"),
              (folder / "a.xosc").string() +
                  ":7: the LogicFile Town01 is not there; instead: there are no roads; correct its path");
    const auto none = openRoads(scenario, folder);
    ASSERT_TRUE(none) << none.error().message();
    EXPECT_FALSE(*none);
    write("Town01.xodr", roadtexts::network(roadtexts::road(
                             "1", 100.0, roadtexts::straightPlan(100.0) + roadtexts::twoLanes())));
    EXPECT_EQ(saidOfRoads("Town01", folder / "a.xosc"), "");
    const auto roads = openRoads(scenario, folder);
    ASSERT_TRUE(roads) << roads.error().message();
    ASSERT_TRUE(*roads) << "the name with .xodr";
    EXPECT_EQ((*roads)->network().roads.size(), 1u);
}

TEST_F(Files, APlaceOnARoadThatIsNotThereIsRefusedWithTheName)
{
    auto parsed = parseScenario(soundText().text(), "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    parsed->scenario.roadNetwork.logicFile = "Town01";
    const auto player = ScenarioPlayer::create(std::move(parsed->scenario), {});
    ASSERT_FALSE(player);
    EXPECT_NE(player.error().message().find("the LogicFile Town01 is not there"), std::string::npos)
        << player.error().message();
}

} // namespace
} // namespace simulation
