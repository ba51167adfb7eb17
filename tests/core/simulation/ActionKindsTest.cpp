// SPDX-License-Identifier: Apache-2.0
// Kinds of actions that no file at hand holds, or that no other test works by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

std::string privateAction(const std::string& content)
{
    return "<PrivateAction>" + content + "</PrivateAction>";
}

std::string animation(const std::string& attributes, const std::string& type, double state)
{
    return privateAction("<AppearanceAction><AnimationAction " + attributes + "><AnimationType>" + type +
                         "</AnimationType><AnimationState state=\"" + std::to_string(state) +
                         "\"/></AnimationAction></AppearanceAction>");
}

const std::string kDoor =
    R"(<ComponentAnimation><VehicleComponent vehicleComponentType="doorFrontLeft"/></ComponentAnimation>)";

/// Ego at 10 m/s from s = 100, and what happens at 1 s.
ScenarioText atOne(const std::string& action)
{
    ScenarioText text;
    text.privates = roadplay::onLane(100.0) + speedAction(10.0);
    text.stories = story(event("a", action, timeCondition(1.0)));
    return text;
}

const EntityState& egoOf(const ScenarioPlayer& player)
{
    return player.entities()[0];
}

double endOfA(const ScenarioPlayer& player)
{
    for (const StoryboardLogEntry& entry : player.log())
        if (entry.path.ends_with("::a") && entry.transition == StoryboardElementState::endTransition)
            return entry.timeS;
    return -1.0;
}

TEST(Animations, ADoorOpensInItsTime)
{
    const auto text = atOne(animation(R"(loop="false" animationDuration="2")", kDoor, 0.8));
    EXPECT_TRUE(egoOf(*roadplay::played(text, 0.9)).animations.empty());
    EXPECT_NEAR(egoOf(*roadplay::played(text, 2.0)).animations.at("doorFrontLeft"), 0.4, 1e-9);
    const auto player = roadplay::played(text, 4.0);
    EXPECT_NEAR(egoOf(*player).animations.at("doorFrontLeft"), 0.8, 1e-9);
    EXPECT_NEAR(endOfA(*player), 3.0, 1e-9);
    EXPECT_NEAR(endOfA(*roadplay::played(atOne(animation("loop=\"false\"", kDoor, 1.0)), 4.0)), 1.01, 1e-9)
        << "without a duration it is done at once, and an event ends no earlier than in the next step";
}

TEST(Animations, OneThatRepeatsDoesNotEnd)
{
    const auto text = atOne(
        animation(R"(loop="true" animationDuration="2")", R"(<PedestrianAnimation motion="walking"/>)", 1.0));
    const auto player = roadplay::played(text, 6.0);
    EXPECT_NEAR(egoOf(*player).animations.at("walking"), 0.5, 1e-9) << "two courses and a half";
    EXPECT_LT(endOfA(*player), 0.0);
}

TEST(Animations, SeveralRunBesideOneAnother)
{
    ScenarioText text = atOne(animation(R"(loop="false" animationDuration="2")", kDoor, 1.0));
    text.stories =
        story(event("a", animation(R"(loop="false" animationDuration="2")", kDoor, 1.0), timeCondition(1.0)) +
              event("b",
                    animation(R"(loop="false" animationDuration="4")",
                              R"(<UserDefinedAnimation userDefinedAnimationType="crane"/>)", 1.0),
                    timeCondition(1.0)));
    const auto player = roadplay::played(text, 2.0);
    EXPECT_NEAR(egoOf(*player).animations.at("doorFrontLeft"), 0.5, 1e-9);
    EXPECT_NEAR(egoOf(*player).animations.at("crane"), 0.25, 1e-9);
}

constexpr const char* kLamp =
    R"(<PrivateAction><AppearanceAction><LightStateAction><LightType>%</LightType><LightState mode="$"/></LightStateAction></AppearanceAction></PrivateAction>)";

std::string lampAction(const std::string& type, const std::string& mode)
{
    std::string text = kLamp;
    text.replace(text.find('%'), 1, type);
    return text.replace(text.find('$'), 1, mode);
}

TEST(LightStates, SwitchALampOnAndOff)
{
    const std::string brake = R"(<VehicleLight vehicleLightType="brakeLights"/>)";
    ScenarioText text = atOne("");
    text.stories = story(event("a", lampAction(brake, "on"), timeCondition(1.0)) +
                         event("b", lampAction(brake, "off"), timeCondition(2.0)) +
                         event("c", lampAction(R"(<UserDefinedLight userDefinedLightType="lantern"/>)", "on"),
                               timeCondition(2.0)));
    EXPECT_TRUE(egoOf(*roadplay::played(text, 0.9)).lamps.empty());
    EXPECT_TRUE(egoOf(*roadplay::played(text, 1.5)).lamps.at("brakeLights").isLit);
    EXPECT_FALSE(egoOf(*roadplay::played(text, 2.5)).lamps.at("brakeLights").isLit);
    EXPECT_TRUE(egoOf(*roadplay::played(text, 2.5)).lamps.at("lantern").isLit);
}

/// A tractor with its hitch 1 m behind the reference point, and a trailer whose coupler is 5 m before its
/// axle.
ScenarioText withTrailer(const std::string& events, bool isCoupledAtFirst)
{
    std::string tow = kCar, trailer = kCar;
    const auto addBefore = [](std::string& text, const std::string& added)
    { text.insert(text.find("<Properties/>"), added); };
    addBefore(tow, "<TrailerHitch dx=\"-1\"/>");
    if (isCoupledAtFirst) addBefore(tow, R"(<Trailer><TrailerRef entityRef="Cart"/></Trailer>)");
    addBefore(trailer, "<TrailerCoupler dx=\"5\"/>");
    ScenarioText text;
    text.entities = "<ScenarioObject name=\"Ego\">" + tow +
                    "</ScenarioObject><ScenarioObject name=\"Cart\">" + trailer + "</ScenarioObject>";
    text.globals = "<Private entityRef=\"Cart\">" + roadplay::onLane(60.0) + "</Private>";
    text.privates = roadplay::onLane(100.0) + speedAction(10.0);
    text.stories = story(events);
    return text;
}

const std::string kConnect =
    R"(<PrivateAction><TrailerAction><ConnectTrailerAction trailerRef="Cart"/></TrailerAction></PrivateAction>)";
const std::string kDisconnect =
    "<PrivateAction><TrailerAction><DisconnectTrailerAction/></TrailerAction></PrivateAction>";

TEST(TrailerActions, ATrailerIsDrawnFromThenOn)
{
    const auto text = withTrailer(event("a", kConnect, timeCondition(1.0)), false);
    EXPECT_NEAR(roadplay::played(text, 1.0)->entities()[1].position.x, 60.0, 1e-9);
    // At 3 s Ego is at 130 m: the hitch at 129 m, the axle of the trailer 5 m behind it.
    const auto player = roadplay::played(text, 3.0);
    EXPECT_NEAR(player->entities()[0].position.x, 130.0, 1e-9);
    EXPECT_NEAR(player->entities()[1].position.x, 124.0, 1e-9);
    EXPECT_NEAR(player->entities()[1].speedMps, 10.0, 1e-9);
}

TEST(TrailerActions, ATrailerThatIsLeftStaysWhereItIs)
{
    const auto text = withTrailer(event("a", kDisconnect, timeCondition(1.0)), true);
    EXPECT_NEAR(roadplay::played(text, 1.0)->entities()[1].position.x, 104.0, 1e-9);
    const auto player = roadplay::played(text, 3.0);
    EXPECT_NEAR(player->entities()[0].position.x, 130.0, 1e-9);
    EXPECT_NEAR(player->entities()[1].position.x, 104.0, 1e-9);
    EXPECT_NEAR(player->entities()[1].speedMps, 0.0, 1e-9);
}

TEST(UserDefinedActions, AreToldWithTheirLineAndDoneAtOnce)
{
    ScenarioText text = atOne("<UserDefinedAction><CustomCommandAction "
                              "type=\"horn\">loud</CustomCommandAction></UserDefinedAction>");
    text.stories = story(
        event("a",
              "<UserDefinedAction><CustomCommandAction "
              "type=\"horn\">loud</CustomCommandAction></UserDefinedAction>",
              timeCondition(1.0)) +
        event(
            "b", speedAction(3.0),
            R"(<ConditionGroup><Condition name="c" delay="0" conditionEdge="none"><ByValueCondition><StoryboardElementStateCondition storyboardElementType="event" storyboardElementRef="a" state="completeState"/></ByValueCondition></Condition></ConditionGroup>)"));
    const auto parsed = parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->problems.size(), 1u) << "once";
    EXPECT_EQ(parsed->problems[0].kind, Problem::Kind::unsupported);
    EXPECT_NE(parsed->problems[0].error.message().find("UserDefinedAction"), std::string::npos);
    EXPECT_EQ(parsed->problems[0].error.place.substr(0, 10), "test.xosc:");
    EXPECT_EQ(egoOf(*roadplay::played(text, 0.9)).speedMps, 10.0);
    EXPECT_EQ(egoOf(*roadplay::played(text, 2.0)).speedMps, 3.0) << "what waits for its end goes on";
}

TEST(ParameterActions, AddMultiplyAndSet)
{
    const auto changes = [](const std::string& change)
    {
        ScenarioText text = atOne("<GlobalAction><ParameterAction parameterRef=\"p\">" + change +
                                  "</ParameterAction></GlobalAction>");
        text.declarations =
            R"(<ParameterDeclarations><ParameterDeclaration name="p" parameterType="double" value="4"/></ParameterDeclarations>)";
        text.stories = story(
            event("a",
                  "<GlobalAction><ParameterAction parameterRef=\"p\">" + change +
                      "</ParameterAction></GlobalAction>",
                  timeCondition(1.0)) +
            event(
                "b", speedAction(3.0),
                R"(<ConditionGroup><Condition name="c" delay="0" conditionEdge="none"><ByValueCondition><ParameterCondition parameterRef="p" value="6" rule="equalTo"/></ByValueCondition></Condition></ConditionGroup>)"));
        return egoOf(*roadplay::played(text, 2.0)).speedMps == 3.0;
    };
    EXPECT_TRUE(changes("<ModifyAction><Rule><AddValue value=\"2\"/></Rule></ModifyAction>"));
    EXPECT_TRUE(changes("<ModifyAction><Rule><MultiplyByValue value=\"1.5\"/></Rule></ModifyAction>"));
    EXPECT_TRUE(changes("<SetAction value=\"6\"/>"));
    EXPECT_FALSE(changes("<SetAction value=\"7\"/>"));
}

TEST(SpeedActions, EachShapeAndDimensionTakesItsTime)
{
    // From 10 to 20 m/s. Over 4 s half the change is done after 2 s; at a rate of 2.5 m/s² it takes 4 s; over
    // 60 m, at 15 m/s in the mean, 4 s. A sinusoidal change whose steepest slope is 2.5 m/s² takes π/2 times
    // as long, a cubic one 1.5 times.
    const auto half =
        [](const std::string& shape, const std::string& dimension, double value, double durationS)
    {
        const auto text = atOne(speedAction(20.0, shape, dimension, value));
        EXPECT_NEAR(egoOf(*roadplay::played(text, 1.0 + 0.5 * durationS)).speedMps, 15.0, 0.03)
            << shape << dimension;
        EXPECT_NEAR(egoOf(*roadplay::played(text, 1.0 + durationS + 0.02)).speedMps, 20.0, 1e-9)
            << shape << dimension;
        EXPECT_LT(egoOf(*roadplay::played(text, 1.0 + 0.9 * durationS)).speedMps, 19.9) << shape << dimension;
    };
    half("linear", "time", 4.0, 4.0);
    half("linear", "rate", 2.5, 4.0);
    half("linear", "distance", 60.0, 4.0);
    half("cubic", "time", 4.0, 4.0);
    half("cubic", "rate", 2.5, 6.0);
    half("sinusoidal", "time", 4.0, 4.0);
    half("sinusoidal", "rate", 2.5, 4.0 * std::acos(-1.0) / 2.0);
}

} // namespace
} // namespace simulation
