// SPDX-License-Identifier: Apache-2.0
// Typical mistakes of people who write scenarios: each is one line that names the file, the line of the
// mistake and the remedy.
#include <algorithm>

#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

const char* const kStoriesWithoutMistakes = R"(
<Story name="story"><Act name="act">
<ManeuverGroup name="group" maximumExecutionCount="1">
<Actors selectTriggeringEntities="false">
<EntityRef entityRef="Ego"/></Actors><Maneuver name="maneuver">
<Event name="first" priority="override" maximumExecutionCount="1">
<Action name="brake">
<PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" value="0"/><SpeedActionTarget>
<RelativeTargetSpeed entityRef="Lead" value="0" speedTargetValueType="delta" continuous="false"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction></Action>
<StartTrigger>
<ConditionGroup>
<Condition name="near" delay="0" conditionEdge="rising"><ByEntityCondition>
<TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="Ego"/></TriggeringEntities><EntityCondition>
<RelativeDistanceCondition entityRef="Lead" value="20" freespace="true" relativeDistanceType="longitudinal" coordinateSystem="entity" rule="lessThan"/></EntityCondition></ByEntityCondition></Condition>
</ConditionGroup></StartTrigger></Event>
<Event name="second" priority="override" maximumExecutionCount="1">
<Action name="change"><PrivateAction><LateralAction><LaneChangeAction>
<LaneChangeActionDynamics dynamicsShape="sinusoidal" dynamicsDimension="time" value="3"/><LaneChangeTarget>
<AbsoluteTargetLane value="-1"/></LaneChangeTarget></LaneChangeAction></LateralAction></PrivateAction></Action>
<StartTrigger><ConditionGroup><Condition name="after" delay="0" conditionEdge="none"><ByValueCondition>
<StoryboardElementStateCondition storyboardElementType="event" storyboardElementRef="first" state="endTransition"/></ByValueCondition></Condition></ConditionGroup></StartTrigger></Event>
</Maneuver></ManeuverGroup></Act></Story>
)";

/// Every element that a mistake is made in stands on a line of its own.
std::string textWithoutMistakes()
{
    ScenarioText text;
    text.declarations = R"(
<ParameterDeclarations>
<ParameterDeclaration name="speed" parameterType="double" value="20"><ConstraintGroup><ValueConstraint rule="lessThan" value="50"/></ConstraintGroup></ParameterDeclaration>
<ParameterDeclaration name="lanes" parameterType="integer" value="3"/>
<ParameterDeclaration name="wet" parameterType="boolean" value="false"/>
</ParameterDeclarations>
<VariableDeclarations><VariableDeclaration name="v" variableType="double" value="1"/></VariableDeclarations>
<MonitorDeclarations><MonitorDeclaration name="m" value="false"/></MonitorDeclarations>
)";
    text.entities = "\n" + text.entities + "\n<ScenarioObject name=\"Lead\">\n" + kCar +
                    "</ScenarioObject>\n<EntitySelection name=\"All\">\n<Members>\n<EntityRef "
                    "entityRef=\"Lead\"/>\n</Members>"
                    "</EntitySelection>\n";
    text.globals = R"(
<GlobalAction><EnvironmentAction><Environment name="e">
<TimeOfDay animation="true" dateTime="2025-06-13T06:00:00Z"/>
<Weather>
<Fog visualRange="500"/></Weather></Environment></EnvironmentAction></GlobalAction>
<GlobalAction>
<VariableAction variableRef="v"><SetAction value="3"/></VariableAction></GlobalAction>
<GlobalAction>
<SetMonitorAction monitorRef="m" value="true"/></GlobalAction>
)";
    text.privates = R"(
<PrivateAction>
<TeleportAction><Position>
<WorldPosition x="1" y="2"/></Position></TeleportAction></PrivateAction>
<PrivateAction><LongitudinalAction><SpeedAction>
<SpeedActionDynamics dynamicsShape="linear" dynamicsDimension="time" value="2"/><SpeedActionTarget>
<AbsoluteTargetSpeed value="${$speed / 2}"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction>
<PrivateAction><RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape>
<Polyline>
<Vertex time="0"><Position><WorldPosition x="0" y="0"/></Position></Vertex>
<Vertex time="5"><Position>
<GeoPosition latitudeDeg="46" longitudeDeg="8"/></Position></Vertex></Polyline></Shape></Trajectory></TrajectoryRef>
<TimeReference><Timing domainAbsoluteRelative="relative" scale="1" offset="0"/></TimeReference>
<TrajectoryFollowingMode followingMode="position"/></FollowTrajectoryAction></RoutingAction></PrivateAction>
)";
    text.stories = kStoriesWithoutMistakes;
    text.stop = stopAt(9.0);
    return text.text();
}

struct Mistake
{
    const char* name;
    const char* replaced; ///< in the text without mistakes
    const char* by;
    const char* what;   ///< of the message
    const char* remedy; ///< of the message
};

/// What is said of a text: the first problem of the highest kind, or what keeps it from being played.
std::optional<foundation::Error> saidOf(const std::string& text)
{
    auto parsed = parseScenario(text, "m.xosc", {.tolerant = true, .parameters = {}});
    if (!parsed) return parsed.error();
    const Problem* worst = nullptr;
    for (const Problem& problem : parsed->problems)
        if (!worst || problem.kind > worst->kind) worst = &problem;
    if (worst) return worst->error;
    PlayerOptions options;
    options.origin = Geodetic{46.5, 8.0, 0.0};
    options.scenarioName = "m.xosc";
    Scenario scenario = parsed->scenario;
    for (Event& event : scenario.storyboard.stories[0].acts[0].groups[0].maneuvers[0].events)
        if (event.name == "second") event.actions.clear(); // its lane needs roads
    const auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    if (!player) return player.error();
    if (!(*player)->warnings().empty()) return (*player)->warnings().front();
    return std::nullopt;
}

class Mistakes : public testing::TestWithParam<Mistake>
{
};

TEST_P(Mistakes, AreOneLineWithPlaceAndRemedy)
{
    std::string text = textWithoutMistakes();
    const std::size_t at = text.find(GetParam().replaced);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::string(GetParam().replaced).size(), GetParam().by);
    const auto said = saidOf(text);
    ASSERT_TRUE(said) << "nothing is said";
    EXPECT_NE(said->what.find(GetParam().what), std::string::npos) << said->message();
    EXPECT_NE(said->remedy.find(GetParam().remedy), std::string::npos) << said->message();
    EXPECT_EQ(said->message().find('\n'), std::string::npos) << said->message();
    ASSERT_TRUE(said->place.starts_with("m.xosc:")) << said->message();
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    EXPECT_LE(std::abs(std::stol(said->place.substr(7)) - line), 3)
        << said->message() << "; it is in line " << line;
}

TEST(Mistakes, AreNotSeenWhereThereAreNone)
{
    const auto said = saidOf(textWithoutMistakes());
    EXPECT_FALSE(said) << said->message();
}

INSTANTIATE_TEST_SUITE_P(
    Table, Mistakes,
    testing::Values(
        Mistake{"MisspeltElement", "<Fog", "<Fogg", "the element Fogg is no element", "did you mean Fog?"},
        Mistake{"LowerCaseElement", "<Fog", "<fog", "the element fog is no element", "did you mean Fog?"},
        Mistake{"MisspeltChoice", "<AbsoluteTargetLane ", "<AbsoluteTargetLan ", "is no element of",
                "did you mean AbsoluteTargetLane?"},
        Mistake{"MisplacedElement", "<Weather>", "<Weather>\n<Actors/>", "does not belong in Weather",
                "passed over"},
        Mistake{"MisspeltAttribute", "visualRange=", "visualrange=", "Fog has no attribute visualRange",
                "add it"},
        Mistake{"MissingAttribute", "x=\"1\" y=\"2\"", "x=\"1\"", "WorldPosition has no attribute y",
                "add it"},
        Mistake{"AttributeTooMuch", "x=\"1\" y=\"2\"", "x=\"1\" y=\"2\" heading=\"1\"",
                "the attribute heading of WorldPosition", "passed over"},
        Mistake{"TwoActionsInOne", "<PrivateAction>\n<Tele", "<PrivateAction><VisibilityAction/>\n<Tele",
                "does not belong in PrivateAction", "passed over"},
        Mistake{"DecimalComma", "x=\"1\"", "x=\"1,5\"", "not a finite number: \"1,5\"",
                "write a point, not a comma: 1.5"},
        Mistake{"UnitBehindNumber", "x=\"1\"", "x=\"1 m\"", "not a finite number: \"1 m\"", "without a unit"},
        Mistake{"EmptyNumber", "x=\"1\"", "x=\"\"", "not a finite number", "write a number"},
        Mistake{"ParameterWithoutDollar", "x=\"1\"", "x=\"speed\"", "not a finite number: \"speed\"",
                "write $speed"},
        Mistake{"UndeclaredParameter", "x=\"1\"", "x=\"$sped\"",
                "the parameter $sped in WorldPosition/x is not declared", "declare it"},
        Mistake{"OpenExpression", "${$speed / 2}", "${$speed / 2", "does not end with }", "close it"},
        Mistake{"UnknownFunction", "${$speed / 2}", "${half($speed)}", "the function or name half is unknown",
                "correct the expression"},
        Mistake{"DivisionByZero", "${$speed / 2}", "${$speed / 0}", "division by zero",
                "correct the expression"},
        Mistake{"WordForANumber", "name=\"speed\" parameterType=\"double\" value=\"20\"",
                "name=\"speed\" parameterType=\"double\" value=\"fast\"",
                "\"fast\" of the parameter speed is no double", "write one"},
        Mistake{"FractionForAnInteger", "value=\"3\"/>\n<Par", "value=\"3.5\"/>\n<Par", "is no integer",
                "write one"},
        Mistake{"YesForTrue", "parameterType=\"boolean\" value=\"false\"",
                "parameterType=\"boolean\" value=\"yes\"", "is no boolean", "write true or false"},
        Mistake{"BrokenConstraint", "value=\"20\"", "value=\"60\"", "breaks the parameter's constraints",
                "change it"},
        Mistake{"ParameterTwice", "name=\"lanes\"", "name=\"speed\"", "the parameter speed stands twice",
                "rename one"},
        Mistake{"UndeclaredVariable", "variableRef=\"v\"", "variableRef=\"w\"",
                "the variable w is not declared", "declare it"},
        Mistake{"UndeclaredMonitor", "monitorRef=\"m\"", "monitorRef=\"n\"", "the monitor n is not declared",
                "declare it"},
        Mistake{"WordOfAnEnumeration", "rule=\"lessThan\" value=\"50\"", "rule=\"less\" value=\"50\"",
                "ValueConstraint/rule has the unknown value \"less\"",
                "write equalTo, greaterThan, lessThan"},
        Mistake{"CapitalInAWord", "dynamicsShape=\"linear\"", "dynamicsShape=\"Linear\"",
                "the unknown value \"Linear\"", "write step, linear, cubic or sinusoidal"},
        Mistake{"FlagThatIsNone", "closed=\"false\"", "closed=\"no\"", "the unknown value \"no\"",
                "write true or false"},
        Mistake{"UnknownEntity", "<Private entityRef=\"Ego\"", "<Private entityRef=\"ego2\"",
                "the entity ego2 does not exist", "did you mean Ego?"},
        Mistake{"UnknownActor", "<EntityRef entityRef=\"Ego\"/></Actors>",
                "<EntityRef entityRef=\"Truck\"/></Actors>", "the entity Truck does not exist",
                "name one of Entities"},
        Mistake{"UnknownReference", "<RelativeTargetSpeed entityRef=\"Lead\"",
                "<RelativeTargetSpeed entityRef=\"Laed\"", "the entity Laed does not exist",
                "did you mean Lead?"},
        Mistake{"EntityTwice", "ScenarioObject name=\"Lead\"", "ScenarioObject name=\"Ego\"",
                "the entity Ego stands twice", "rename one"},
        Mistake{"EmptyEntity", "<EntitySelection name", "<ScenarioObject name=\"x\"/><EntitySelection name",
                "the ScenarioObject is empty", "add a Vehicle"},
        Mistake{"EmptySelection", "<EntityRef entityRef=\"Lead\"/>\n</Members>", "</Members>",
                "the EntitySelection has no members", "name entities"},
        Mistake{"NegativeLength", "length=\"5\"", "length=\"-5\"", "Dimensions/length is negative",
                "write 0 or more"},
        Mistake{"NoActors", "<EntityRef entityRef=\"Ego\"/></Actors>", "</Actors>",
                "a private action without actors", "add an EntityRef"},
        Mistake{"EventWithoutAction", "<StartTrigger><ConditionGroup><Condition name=\"after\"",
                "</Event><Event name=\"third\" priority=\"skip\"><StartTrigger><ConditionGroup><Condition "
                "name=\"after\"",
                "an Event has no Action", "add one"},
        Mistake{"CountOfNothing", "name=\"group\" maximumExecutionCount=\"1\"",
                "name=\"group\" maximumExecutionCount=\"many\"", "is not a finite number: \"many\"",
                "write a number"},
        Mistake{"NegativeDelay", "delay=\"0\"", "delay=\"-1\"", "Condition/delay is negative",
                "write 0 or more"},
        Mistake{"EmptyGroup", "<ConditionGroup>\n", "<ConditionGroup/><ConditionGroup>\n",
                "a ConditionGroup without a Condition", "it never triggers; add one"},
        Mistake{"NobodyTriggers", "<EntityRef entityRef=\"Ego\"/></TriggeringEntities>",
                "</TriggeringEntities>", "TriggeringEntities has no EntityRef", "name an entity"},
        Mistake{"UnknownElementRef", "storyboardElementRef=\"first\"", "storyboardElementRef=\"frist\"",
                "the storyboard element frist does not exist", "correct the reference"},
        Mistake{"OtherElementType", "storyboardElementType=\"event\"", "storyboardElementType=\"act\"",
                "the storyboard element first does not exist", "correct the reference"},
        Mistake{"LaneZero", "AbsoluteTargetLane value=\"-1\"", "AbsoluteTargetLane value=\"0\"",
                "AbsoluteTargetLane/value is 0", "the id of a lane"},
        Mistake{"DateOfTheWrongForm", "2025-06-13T06:00:00Z", "13.06.2025 06:00", "is not a date and time",
                "write it as 2025"},
        Mistake{"NoSight", "visualRange=\"500\"", "visualRange=\"0\"", "Fog/visualRange is 0", "in metres"},
        Mistake{"DegreesAsRadians", "latitudeDeg=\"46\"", "latitude=\"46\"",
                "GeoPosition/latitude is out of range", "give degrees as latitudeDeg"},
        Mistake{"LatitudeAndLongitudeSwapped", "latitudeDeg=\"46\" longitudeDeg=\"8\"",
                "latitudeDeg=\"146\" longitudeDeg=\"8\"", "latitudeDeg is out of range", "give degrees"},
        Mistake{"TimesOutOfOrder", "time=\"5\"", "time=\"0\"", "is not later than the one before",
                "order the vertices"},
        Mistake{"VertexWithoutTime", " time=\"5\"", "", "has no time", "add its time"},
        Mistake{"OneVertex",
                "<Vertex time=\"0\"><Position><WorldPosition x=\"0\" y=\"0\"/></Position></Vertex>", "",
                "a Polyline needs two vertices", "add vertices"},
        Mistake{"PlaceOnARoadWithoutRoads", "<WorldPosition x=\"1\" y=\"2\"/>",
                "<LanePosition roadId=\"1\" laneId=\"-1\" s=\"5\"/>", "names no LogicFile", "OpenDRIVE"},
        Mistake{"UnknownCatalogue", "<ScenarioObject name=\"Lead\">\n",
                "<ScenarioObject name=\"x\"><CatalogReference catalogName=\"cars\" "
                "entryName=\"vw\"/></ScenarioObject><ScenarioObject name=\"Lead\">\n",
                "the catalogue entry cars/vw does not exist", "CatalogLocations"},
        Mistake{"NewerStandard", "revMajor=\"1\"", "revMajor=\"2\"", "OpenSCENARIO XML 2 is unknown",
                "convert"},
        Mistake{"TagNotClosed", "</Weather>", "", "not well-formed XML", "correct the file"}),
    [](const testing::TestParamInfo<Mistake>& test) { return std::string(test.param.name); });

} // namespace
} // namespace simulation
