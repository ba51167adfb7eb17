// SPDX-License-Identifier: Apache-2.0
// Habits of other authors and programs, found by writing storyboards as they do: none of them may stop a
// play.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

std::vector<Problem> problemsIn(const std::string& text)
{
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    return parsed ? parsed->problems : std::vector<Problem>();
}

bool stops(const Problem& problem)
{
    return problem.kind == Problem::Kind::invalid || problem.kind == Problem::Kind::unknown;
}

/// Ego at 20 m/s; `actions` are done at the start.
ScenarioText authored(const std::string& actions)
{
    ScenarioText text;
    text.privates = roadplay::onLane(100.0) + speedAction(20.0) + actions;
    return text;
}

TEST(OtherAuthors, AssignAndOverrideAControllerInOneActionOf10)
{
    const auto text = [](const std::string& brake)
    {
        return authored(
            R"(<PrivateAction><ControllerAction><AssignControllerAction><Controller name="DefaultController"><Properties/></Controller></AssignControllerAction>
<OverrideControllerValueAction><Throttle value="0" active="false"/><Brake value="0.5" active=")" +
            brake +
            R"("/><Clutch value="0" active="false"/><ParkingBrake value="0" active="false"/><Gear number="0" active="false"/></OverrideControllerValueAction></ControllerAction></PrivateAction>)");
    };
    EXPECT_TRUE(problemsIn(text("true").text()).empty());
    EXPECT_NEAR(roadplay::played(text("true"), 2.0)->entities()[0].speedMps, 10.0, 1e-9);
    EXPECT_NEAR(roadplay::played(text("false"), 2.0)->entities()[0].speedMps, 20.0, 1e-9);
}

TEST(OtherAuthors, KeepCriteriaAsConditionsOnParametersThatNobodyDeclares)
{
    ScenarioText text = authored("");
    text.stop =
        R"(<StopTrigger><ConditionGroup><Condition name="criteria_CollisionTest" delay="0" conditionEdge="rising"><ByValueCondition>
<ParameterCondition parameterRef="" value="" rule="lessThan"/></ByValueCondition></Condition></ConditionGroup></StopTrigger>)";
    const auto problems = problemsIn(text.text());
    ASSERT_EQ(problems.size(), 1u) << problems.back().error.message();
    EXPECT_FALSE(stops(problems[0]));
    EXPECT_NE(problems[0].error.message().find("never true"), std::string::npos);
    EXPECT_NEAR(roadplay::played(text, 5.0)->timeS(), 5.0, 1e-9) << "it does not end the play";
}

TEST(OtherAuthors, WriteADollarBeforeTheNameOfADeclaration)
{
    ScenarioText text = authored("");
    text.declarations =
        R"(<ParameterDeclarations><ParameterDeclaration name="$v" parameterType="double" value="7"/></ParameterDeclarations>)";
    text.privates +=
        R"(<PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" value="0"/>
<SpeedActionTarget><AbsoluteTargetSpeed value="$v"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction>)";
    EXPECT_TRUE(problemsIn(text.text()).empty());
    EXPECT_EQ(roadplay::played(text, 1.0)->entities()[0].speedMps, 7.0);
}

TEST(OtherAuthors, NameObjectControllersAndRoles)
{
    ScenarioText text = authored(
        R"(<PrivateAction><ControllerAction><ActivateControllerAction longitudinal="true" lateral="false" objectControllerRef="second"/></ControllerAction></PrivateAction>)");
    text.header =
        R"(<FileHeader revMajor="1" revMinor="3" date="d" description="d" author="a"><Properties><Property name="tool" value="x"/></Properties></FileHeader>)";
    const auto controller = [](const std::string& name, const std::string& kind)
    {
        return "<ObjectController name=\"" + name + "\" controllerType=\"movement\"><Controller name=\"" +
               kind + "\"><Properties/></Controller></ObjectController>";
    };
    std::string car = kCar;
    car.replace(car.find("vehicleCategory"), 0, "role=\"police\" ");
    text.entities = "<ScenarioObject name=\"Ego\">" + car + controller("second", "InteractiveController") +
                    controller("third", "DefaultController") + "</ScenarioObject>";
    EXPECT_TRUE(problemsIn(text.text()).empty());
    EXPECT_EQ(roadplay::played(text, 1.0)->entities()[0].speedMps, 0.0) << "nobody drives the second one";
}

TEST(OtherAuthors, NameFoldersOfCataloguesThatAreNotThere)
{
    ScenarioText text = authored("");
    text.catalogs =
        R"(<CatalogLocations><ControllerCatalog><Directory path="nowhere"/></ControllerCatalog></CatalogLocations>)";
    const auto file = std::filesystem::path(testing::TempDir()) / "other_authors.xosc";
    std::ofstream(file) << text.text();
    const auto parsed = readScenario(file, {.tolerant = true, .parameters = {}});
    std::filesystem::remove(file);
    ASSERT_TRUE(parsed) << parsed.error().message();
    ASSERT_EQ(parsed->problems.size(), 1u);
    EXPECT_FALSE(stops(parsed->problems[0]));
    EXPECT_NE(parsed->problems[0].error.message().find("nowhere does not exist"), std::string::npos);
}

} // namespace
} // namespace simulation
