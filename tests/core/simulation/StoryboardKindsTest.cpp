// SPDX-License-Identifier: Apache-2.0
// Kinds of conditions and actions that no file at hand holds: the instant at which an event starts, worked by
// hand. Each has a mutation of its file that must move the instant.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

constexpr double kKindStepS = 1.0 / 120.0;
constexpr double kNotStarted = -1.0;

std::unique_ptr<ScenarioPlayer> playingKind(const std::string& text)
{
    auto parsed = parseScenario(text, "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return nullptr;
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), {});
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

void playUpTo(ScenarioPlayer& player, double timeS)
{
    while (!player.isFinished() && player.timeS() < timeS - 1e-9)
        player.step();
}

/// When the event `b` has started first.
double startOfB(const std::string& text)
{
    const auto player = playingKind(text);
    if (!player) return kNotStarted;
    playUpTo(*player, 9.0);
    for (const StoryboardLogEntry& entry : player->log())
        if (entry.path.ends_with("::b") && entry.transition == StoryboardElementState::startTransition)
            return entry.timeS;
    return kNotStarted;
}

std::string whenValue(const std::string& condition)
{
    return R"(<ConditionGroup><Condition name="c" delay="0" conditionEdge="none"><ByValueCondition>)" +
           condition + "</ByValueCondition></Condition></ConditionGroup>";
}

std::string whenEgo(const std::string& condition, const std::string& edge = "none")
{
    return R"(<ConditionGroup><Condition name="c" delay="0" conditionEdge=")" + edge +
           R"("><ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="Ego"/></TriggeringEntities>
<EntityCondition>)" +
           condition + "</EntityCondition></ByEntityCondition></Condition></ConditionGroup>";
}

std::string globalAction(const std::string& action)
{
    return "<GlobalAction>" + action + "</GlobalAction>";
}

const std::string kOther = R"(<ScenarioObject name="Other">)" + kCar + "</ScenarioObject>";
const std::string kOtherAt50 =
    R"(<Private entityRef="Other">)" + teleport(R"(<WorldPosition x="50" y="0"/>)") + "</Private>";

/// Two cars, Ego at 10 m/s towards the other one, 50 m ahead.
ScenarioText twoCars()
{
    ScenarioText text;
    text.entities += kOther;
    text.globals = kOtherAt50;
    text.privates = teleport(R"(<WorldPosition x="0" y="0" h="0.5"/>)") +
                    teleport(R"(<WorldPosition x="0" y="0" h="0"/>)") + speedAction(10.0);
    return text;
}

std::string startsB(ScenarioText text, const std::string& trigger, const std::string& events = "")
{
    text.stories = story(events + event("b", speedAction(1.0), trigger));
    text.stop = stopAt(9.0);
    return text.text();
}

std::string withSignals(std::string text)
{
    const std::string signals = R"(<RoadNetwork><TrafficSignals>
<TrafficSignalController name="A"><Phase name="stop" duration="3"><TrafficSignalState trafficSignalId="1" state="red"/></Phase>
<Phase name="go" duration="2"><TrafficSignalState trafficSignalId="1" state="green"/></Phase></TrafficSignalController>
<TrafficSignalController name="B" delay="1" reference="A"><Phase name="stop" duration="3"><TrafficSignalState trafficSignalId="2" state="red"/></Phase>
<Phase name="go" duration="2"><TrafficSignalState trafficSignalId="2" state="green"/></Phase></TrafficSignalController>
</TrafficSignals></RoadNetwork>)";
    return text.replace(text.find("<RoadNetwork/>"), 14, signals);
}

std::string signalIs(const std::string& signal, const std::string& state)
{
    return whenValue("<TrafficSignalCondition name=\"" + signal + "\" state=\"" + state + "\"/>");
}

/// B's cycle runs one second behind that of A, before its start as well: green until 1 s, then red, green
/// again from 4 s on.
std::string risingSignal()
{
    std::string trigger = signalIs("2", "green");
    return trigger.replace(trigger.find("\"none\""), 6, "\"rising\"");
}

struct KindCase
{
    const char* name;
    std::string text;
    double startS;
    const char* replaced; ///< the mutation
    const char* by;
};

class StoryboardKinds : public testing::TestWithParam<KindCase>
{
};

TEST_P(StoryboardKinds, StartWhenTheFileSays)
{
    const KindCase& kind = GetParam();
    EXPECT_NEAR(startOfB(kind.text), kind.startS, 0.5 * kKindStepS);
    std::string mutation = kind.text;
    const std::size_t at = mutation.find(kind.replaced);
    ASSERT_NE(at, std::string::npos);
    mutation.replace(at, std::string(kind.replaced).size(), kind.by);
    EXPECT_GT(std::fabs(startOfB(mutation) - kind.startS), 0.5 * kKindStepS);
}

/// The clock of the environment begins at 06:00:00 and goes on: 2 s later it is 06:00:02.
std::string atSix()
{
    ScenarioText text;
    text.globals = globalAction(
        R"(<EnvironmentAction><Environment name="e"><TimeOfDay animation="true" dateTime="2025-06-13T06:00:00Z"/>
</Environment></EnvironmentAction>)");
    return startsB(
        text,
        whenValue(R"(<TimeOfDayCondition dateTime="2025-06-13T08:00:02+02:00" rule="greaterOrEqual"/>)"));
}

/// 1 + 2 = 3, one step after the action at 1 s: b stands before a in the maneuver.
std::string withVariable()
{
    ScenarioText text;
    text.declarations =
        R"(<VariableDeclarations><VariableDeclaration name="v" variableType="double" value="1"/></VariableDeclarations>)";
    return startsB(
        text, whenValue(R"(<VariableCondition variableRef="v" value="3" rule="equalTo"/>)"),
        event(
            "a",
            globalAction(
                R"(<VariableAction variableRef="v"><ModifyAction><Rule><AddValue value="2"/></Rule></ModifyAction></VariableAction>)"),
            timeCondition(1.0)));
}

/// Ego looks along 0.5 rad before it is put straight; at 0 s it looks along 0.
std::string withAngle(const std::string& condition)
{
    return startsB(twoCars(), whenEgo(condition));
}

/// The gap is 50 − 10t: 20 at 3 s, −5 at 5.5 s, which is still within; the lane is free again one step later.
std::string withClearance()
{
    return startsB(
        twoCars(),
        whenEgo(
            R"(<RelativeClearanceCondition distanceForward="20" distanceBackward="5" freeSpace="false" oppositeLanes="false"/>)",
            "rising"));
}

/// With boxes (5 m, centre 1.4 m before the reference points) the gap is 20 when the points are 25 m apart:
/// at 2.5 s.
std::string withFreeSpace()
{
    return startsB(
        twoCars(),
        whenEgo(
            R"(<RelativeClearanceCondition distanceForward="20" distanceBackward="5" freeSpace="true" oppositeLanes="false"/>)",
            "falling"));
}

std::string withController(const std::string& trigger, const std::string& events = "")
{
    return withSignals(startsB(ScenarioText(), trigger, events));
}

const std::string kGoAtOne = event(
    "a",
    globalAction(
        R"(<InfrastructureAction><TrafficSignalAction><TrafficSignalControllerAction trafficSignalControllerRef="A" phase="go"/></TrafficSignalAction></InfrastructureAction>)"),
    timeCondition(1.0));

INSTANTIATE_TEST_SUITE_P(
    Table, StoryboardKinds,
    testing::Values(
        KindCase{"TimeOfDay", atSix(), 2.0, "animation=\"true\"", "animation=\"false\""},
        KindCase{"Variable", withVariable(), 1.0, "AddValue value=\"2\"", "AddValue value=\"1\""},
        KindCase{"Angle",
                 withAngle(R"(<AngleCondition angleType="heading" angle="6.2832" angleTolerance="0.001"/>)"),
                 0.0, "angle=\"6.2832\"", "angle=\"6.2\""},
        KindCase{
            "RelativeAngle",
            withAngle(
                R"(<RelativeAngleCondition entityRef="Other" angleType="heading" angle="0" angleTolerance="0.001"/>)"),
            0.0, "x=\"50\" y=\"0\"", "x=\"50\" y=\"0\" h=\"0.1\""},
        KindCase{"Clearance", withClearance(), 5.5 + kKindStepS, "distanceBackward=\"5\"",
                 "distanceBackward=\"6\""},
        KindCase{"ClearanceOfBoxes", withFreeSpace(), 2.5, "freeSpace=\"true\"", "freeSpace=\"false\""},
        KindCase{"PhaseOfASignal", withController(signalIs("1", "green")), 3.0, "duration=\"3\"",
                 "duration=\"3.5\""},
        KindCase{"DelayOfAController", withController(risingSignal()), 4.0, "delay=\"1\"", "delay=\"1.5\""},
        KindCase{"PhaseOfAController",
                 withController(whenValue(
                     R"(<TrafficSignalControllerCondition trafficSignalControllerRef="A" phase="go"/>)")),
                 3.0, "duration=\"3\"", "duration=\"2\""},
        KindCase{"PhaseThatIsBegun", withController(signalIs("1", "green"), kGoAtOne), 1.0, "phase=\"go\"",
                 "phase=\"stop\""}),
    [](const testing::TestParamInfo<KindCase>& test) { return std::string(test.param.name); });

TEST(StoryboardKinds, AnEntityIsDeletedAndAddedAgain)
{
    ScenarioText text = twoCars();
    const std::string of = R"(<EntityAction entityRef="Other">)";
    text.stories = story(
        event("a", globalAction(of + "<DeleteEntityAction/></EntityAction>"), timeCondition(1.0)) +
        event(
            "b",
            globalAction(
                of +
                R"(<AddEntityAction><Position><WorldPosition x="90" y="3"/></Position></AddEntityAction></EntityAction>)"),
            timeCondition(2.0)));
    text.stop = stopAt(9.0);
    const auto player = playingKind(text.text());
    ASSERT_TRUE(player);
    playUpTo(*player, 0.5);
    EXPECT_TRUE(player->entities()[1].isPresent);
    playUpTo(*player, 1.5);
    EXPECT_FALSE(player->entities()[1].isPresent);
    playUpTo(*player, 2.5);
    EXPECT_TRUE(player->entities()[1].isPresent);
    EXPECT_EQ(player->entities()[1].position, glm::dvec3(90.0, 3.0, 0.0));
}

TEST(StoryboardKinds, ADeletedEntityCollidesWithNothing)
{
    for (const bool isDeleted : {false, true})
    {
        ScenarioText text = twoCars();
        text.stories = story(
            event("a",
                  globalAction(R"(<EntityAction entityRef=")" + std::string(isDeleted ? "Other" : "Ego") +
                               R"("><DeleteEntityAction/></EntityAction>)"),
                  timeCondition(isDeleted ? 1.0 : 8.0)) +
            event("b", speedAction(1.0),
                  whenEgo(R"(<CollisionCondition><EntityRef entityRef="Other"/></CollisionCondition>)")));
        text.stop = stopAt(9.0);
        // The boxes are 5 m long: they touch when the points are 5 m apart, at 4.5 s.
        EXPECT_NEAR(startOfB(text.text()), isDeleted ? kNotStarted : 4.5, 1.01 * kKindStepS);
    }
}

TEST(StoryboardKinds, AnEntityThatIsAddedIsNotThereBefore)
{
    ScenarioText text = twoCars();
    text.globals.clear();
    text.stories = story(event(
        "a",
        globalAction(
            R"(<EntityAction entityRef="Other"><AddEntityAction><Position><WorldPosition x="9" y="9"/></Position></AddEntityAction></EntityAction>)"),
        timeCondition(1.0)));
    text.stop = stopAt(9.0);
    const auto player = playingKind(text.text());
    ASSERT_TRUE(player);
    EXPECT_FALSE(player->entities()[1].isPresent);
    playUpTo(*player, 1.5);
    EXPECT_TRUE(player->entities()[1].isPresent);
}

TEST(StoryboardKinds, HidingAnEntityShowsInItsState)
{
    ScenarioText text = twoCars();
    text.stories = story(event(
        "a",
        R"(<PrivateAction><VisibilityAction graphics="false" sensors="true" traffic="true"/></PrivateAction>)",
        timeCondition(1.0)));
    text.stop = stopAt(9.0);
    const auto player = playingKind(text.text());
    ASSERT_TRUE(player);
    EXPECT_TRUE(player->entities()[0].isVisible);
    playUpTo(*player, 1.5);
    EXPECT_FALSE(player->entities()[0].isVisible);
    EXPECT_TRUE(player->entities()[0].isPresent);
}

TEST(StoryboardKinds, ASelectionActsAsItsMembers)
{
    for (const std::string members : {R"(<EntityRef entityRef="Ego"/><EntityRef entityRef="Other"/>)",
                                      R"(<ByType objectType="vehicle"/>)"})
    {
        ScenarioText text = twoCars();
        text.entities +=
            "<EntitySelection name=\"Both\"><Members>" + members + "</Members></EntitySelection>";
        text.stories = story(event("a", speedAction(7.0), timeCondition(1.0)));
        const std::size_t at = text.stories.find("<EntityRef entityRef=\"Ego\"/></Actors>");
        text.stories.replace(at, 26, "<EntityRef entityRef=\"Both\"/>");
        text.stop = stopAt(9.0);
        const auto player = playingKind(text.text());
        ASSERT_TRUE(player);
        playUpTo(*player, 2.0);
        EXPECT_EQ(player->entities()[0].speedMps, 7.0);
        EXPECT_EQ(player->entities()[1].speedMps, 7.0);
    }
}

TEST(StoryboardKinds, AMonitorSaysWhatHasBeen)
{
    ScenarioText text;
    text.declarations =
        R"(<MonitorDeclarations><MonitorDeclaration name="m" value="false"/></MonitorDeclarations>)";
    text.stories = story(
        event("a", globalAction(R"(<SetMonitorAction monitorRef="m" value="true"/>)"), timeCondition(1.0)));
    text.stop = stopAt(9.0);
    const auto player = playingKind(text.text());
    ASSERT_TRUE(player);
    playUpTo(*player, 0.5);
    EXPECT_FALSE(player->monitors().at("m"));
    playUpTo(*player, 1.5);
    EXPECT_TRUE(player->monitors().at("m"));
}

} // namespace
} // namespace simulation
