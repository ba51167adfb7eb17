// SPDX-License-Identifier: Apache-2.0
// Controllers, lamps and distances sideways on a straight road: values worked by hand.
#include <algorithm>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "../roads/RoadTexts.h"
#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/player/controllers/SpeedControllers.h"
#include "simulation/road/FollowingModel.h"
#include "simulation/scenario/ControllerKinds.h"

namespace simulation
{
namespace
{

constexpr double kControlStepS = 0.01;

std::shared_ptr<const RoadScene> straightRoads(double length)
{
    return std::make_shared<const RoadScene>(roadtexts::sound(roadtexts::network(
        roadtexts::road("1", length, roadtexts::straightPlan(length) + roadtexts::twoLanes()))));
}

std::string onLane(double s)
{
    return teleport("<LanePosition roadId=\"1\" laneId=\"-1\" s=\"" + std::to_string(s) + "\"/>");
}

std::string activated(bool isActive = true)
{
    return std::string("<PrivateAction><ControllerAction><ActivateControllerAction lateral=\"false\" "
                       "longitudinal=\"") +
           (isActive ? "true" : "false") + "\"/></ControllerAction></PrivateAction>";
}

/// Ego with a controller 60 m behind Other, which drives at 10 m/s.
ScenarioText following(const std::string& controller)
{
    ScenarioText text;
    text.entities = R"(<ScenarioObject name="Ego">)" + kCar + "<ObjectController>" + controller +
                    R"(</ObjectController></ScenarioObject><ScenarioObject name="Other">)" + kCar +
                    "</ScenarioObject>";
    text.globals = R"(<Private entityRef="Other">)" + onLane(70.0) + speedAction(10.0) + "</Private>";
    text.privates = onLane(10.0) + speedAction(20.0) + activated();
    return text;
}

std::unique_ptr<ScenarioPlayer> playedOnRoad(ScenarioText text, double timeS, double roadM = 3000.0)
{
    text.stop = stopAt(1000.0); // else it ends with its story
    auto parsed = parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return nullptr;
    for (const Problem& problem : parsed->problems)
        ADD_FAILURE() << problem.error.message();
    PlayerOptions options;
    options.clock = FixedClock::forStep(kControlStepS);
    options.roads = straightRoads(roadM);
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return nullptr;
    while (!(*player)->isFinished() && (*player)->timeS() < timeS - 1e-9)
        (*player)->step();
    return std::move(*player);
}

std::string controllerOf(const std::string& kind, const std::string& properties)
{
    return "<Controller name=\"" + kind + "\"><Properties>" + properties + "</Properties></Controller>";
}

std::string property(const std::string& name, const std::string& value)
{
    return "<Property name=\"" + name + "\" value=\"" + value + "\"/>";
}

double gapM(const ScenarioPlayer& player)
{
    return player.entities()[1].position.x - player.entities()[0].position.x - 5.0;
}

/// The lead has moved when the controller looks; at the end of the step it is nearer by the own way, 0.1 m.
constexpr double kSeenBeforeM = 10.0 * kControlStepS;

TEST(Controllers, AdaptiveCruiseKeepsItsTimeGap)
{
    // 3 m and 2 s of 10 m/s.
    const auto player =
        playedOnRoad(following(controllerOf("ACCController", property("timeGap", "2"))), 60.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(player->entities()[0].speedMps, 10.0, 1e-3);
    EXPECT_NEAR(gapM(*player), 23.0 - kSeenBeforeM, 0.01);
}

TEST(Controllers, AdaptiveCruiseDrivesItsSetSpeedWhereTheRoadIsFree)
{
    ScenarioText text =
        following(controllerOf("ACCController", property("mode", "override") + property("setSpeed", "25")));
    text.globals = R"(<Private entityRef="Other">)" + onLane(2900.0) + "</Private>";
    // 3.5 m/s² from 20 m/s: 23.5 m/s after a second.
    EXPECT_NEAR(playedOnRoad(text, 1.0)->entities()[0].speedMps, 23.5, 1e-6);
    EXPECT_NEAR(playedOnRoad(text, 5.0)->entities()[0].speedMps, 25.0, 1e-3);
}

TEST(Controllers, SpeedActionsSetTheSpeedOfAnAdditiveOneAndNotOfAnOverridingOne)
{
    for (const bool isAdditive : {true, false})
    {
        ScenarioText text =
            following(controllerOf("ACCController", property("mode", isAdditive ? "additive" : "override") +
                                                        property("setSpeed", "20")));
        text.globals = R"(<Private entityRef="Other">)" + onLane(2900.0) + "</Private>";
        text.stories = story(event("a", speedAction(15.0), timeCondition(1.0)));
        EXPECT_NEAR(playedOnRoad(text, 20.0)->entities()[0].speedMps, isAdditive ? 15.0 : 20.0, 1e-3);
    }
}

TEST(Controllers, TheIntelligentDriverKeepsItsGap)
{
    // (2 m + 1.5 s · 10 m/s) / √(1 − (10 / 20)⁴) = 17.557 m.
    const auto player =
        playedOnRoad(following(controllerOf("IntelligentDriver", property("desiredSpeed", "20"))), 120.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(player->entities()[0].speedMps, 10.0, 1e-3);
    EXPECT_NEAR(gapM(*player), 17.0 / std::sqrt(1.0 - 1.0 / 16.0) - kSeenBeforeM, 0.02);
}

TEST(Controllers, NobodyDrivesAnInteractiveOneAndTheScenarioTakesItBack)
{
    ScenarioText text = following(controllerOf("InteractiveController", ""));
    text.stories = story(event("a", activated(false), timeCondition(1.0)) +
                         event("b", speedAction(7.0), timeCondition(2.0)));
    EXPECT_EQ(playedOnRoad(text, 1.5)->entities()[0].position.x, 10.0);
    EXPECT_EQ(playedOnRoad(text, 3.0)->entities()[0].speedMps, 7.0);
}

TEST(Controllers, OneMayBeAssignedLater)
{
    ScenarioText text = following(controllerOf("DefaultController", ""));
    text.stories = story(
        event("a",
              "<PrivateAction><ControllerAction><AssignControllerAction activateLongitudinal=\"true\">" +
                  controllerOf("ACCController", property("timeGap", "2")) +
                  "</AssignControllerAction></ControllerAction></PrivateAction>",
              timeCondition(0.5)));
    EXPECT_NEAR(gapM(*playedOnRoad(text, 60.0)), 23.0 - kSeenBeforeM, 0.01);
}

TEST(Controllers, OneThatIsNotPlayedIsToldWithItsLine)
{
    const std::string text = following(controllerOf("SumoController", "")).text();
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->problems.size(), 1u);
    EXPECT_NE(parsed->problems[0].error.message().find("the controller SumoController is not played"),
              std::string::npos);
}

std::vector<Problem> problemsWith(const std::string& kind)
{
    const std::string text = following(controllerOf(kind, "")).text();
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    return parsed ? parsed->problems : std::vector<Problem>();
}

TEST(Controllers, AnUnknownOneIsToldWithTheNamesOfAllThatThereAre)
{
    const std::vector<Problem> problems = problemsWith("SumoController");
    ASSERT_EQ(problems.size(), 1u);
    const std::string message = problems[0].error.message();
    EXPECT_EQ(message.find('\n'), std::string::npos);
    for (const ControllerKind& kind : controllerKinds())
    {
        EXPECT_NE(message.find(kind.name), std::string::npos) << kind.name;
        EXPECT_TRUE(problemsWith(std::string(kind.name)).empty()) << kind.name;
        for (const std::string_view other : kind.otherNames)
            EXPECT_TRUE(problemsWith(std::string(other)).empty()) << other;
        // One letter off is another name.
        EXPECT_EQ(problemsWith(std::string(kind.name) + "s").size(), 1u) << kind.name;
    }
}

/// The kinds of the speed that have no maker, and the makers that have no kind.
std::string strayOf(std::span<const SpeedControllerMaker> makers)
{
    std::string stray;
    for (const ControllerKind& kind : controllerKinds())
        if (kind.role == ControllerRole::speed || kind.standsWithoutPerson)
            if (std::none_of(makers.begin(), makers.end(),
                             [&](const SpeedControllerMaker& maker) { return maker.name == kind.name; }))
                stray += std::string(kind.name) + " has no maker\n";
    for (const SpeedControllerMaker& maker : makers)
    {
        const ControllerKind* const kind = findControllerKind(maker.name);
        if (!kind || (kind->role != ControllerRole::speed && !kind->standsWithoutPerson))
            stray += std::string(maker.name) + " is no kind that sets a speed\n";
    }
    return stray;
}

TEST(Controllers, EachThatSetsASpeedHasAKindAndAMaker)
{
    const std::span<const SpeedControllerMaker> makers(kSpeedControllers);
    EXPECT_EQ(strayOf(makers), "");
    EXPECT_EQ(strayOf(makers.subspan(1)), "ACCController has no maker\n");
    std::vector<SpeedControllerMaker> more(makers.begin(), makers.end());
    more.push_back({"Autopilot", makeAdaptiveCruise});
    EXPECT_EQ(strayOf(more), "Autopilot is no kind that sets a speed\n");
}

TEST(FollowingModel, CrowdsByTheSquareOfTheWantedShareOfTheGap)
{
    // It wants 2 m, 1.5 s of 20 m/s and 20·10 / (2·√(2·4.5)) m: 2 + 30 + 33.333.
    const Following behind{20.0, 65.333333333333333, 10.0, 2.0, 1.5 * 20.0, 2.0, 4.5};
    EXPECT_NEAR(crowding(behind), 1.0, 1e-12);
    Following twice = behind;
    twice.gapM *= 2.0;
    EXPECT_NEAR(crowding(twice), 0.25, 1e-12);
    Following standing{0.0, 2.0, 0.0, 2.0, 0.0, 2.0, 4.5};
    EXPECT_NEAR(crowding(standing), 1.0, 1e-12);
    standing.leadMps = 15.0; // one that drives away is not closer than one that stands
    EXPECT_NEAR(crowding(standing), 1.0, 1e-12);
}

TEST(LateralDistance, IsKeptAtOnceOrNoFasterThanAllowed)
{
    for (const bool isLimited : {false, true})
    {
        ScenarioText text = following(controllerOf("DefaultController", ""));
        text.stories = story(event(
            "a",
            std::string(
                R"(<PrivateAction><LateralAction><LateralDistanceAction entityRef="Other" distance="1.5" freespace="false" continuous="false" displacement="leftToReferencedEntity">)") +
                (isLimited ? R"(<DynamicConstraints maxSpeed="0.5"/>)" : "") +
                "</LateralDistanceAction></LateralAction></PrivateAction>",
            timeCondition(1.0)));
        // Other drives at y = −1.75; half a second later 0.25 m are done of the 1.5 m.
        EXPECT_NEAR(playedOnRoad(text, 1.5)->entities()[0].position.y, isLimited ? -1.5 : -0.25, 0.006);
        EXPECT_NEAR(playedOnRoad(text, 5.0)->entities()[0].position.y, -0.25, 1e-9);
    }
}

TEST(Lamps, FlashAsTheirStateSays)
{
    ScenarioText text = following(controllerOf("DefaultController", ""));
    text.privates +=
        R"(<PrivateAction><AppearanceAction><LightStateAction><LightType><VehicleLight vehicleLightType="indicatorLeft"/></LightType>
<LightState mode="flashing" flashingOnDuration="0.4" flashingOffDuration="0.6"/></LightStateAction></AppearanceAction></PrivateAction>)";
    const auto isLit = [&](double timeS)
    { return playedOnRoad(text, timeS)->entities()[0].lamps.at("indicatorLeft").isLit; };
    EXPECT_TRUE(isLit(0.39));
    EXPECT_FALSE(isLit(0.4));
    EXPECT_FALSE(isLit(0.99));
    EXPECT_TRUE(isLit(1.0));
}

/// Where Ego is after each second, from where it begins.
std::vector<glm::dvec3> relativeTrack(double shiftM)
{
    const auto world = [&](double x, double y)
    {
        return "<WorldPosition x=\"" + std::to_string(x + shiftM) + "\" y=\"" + std::to_string(y - shiftM) +
               "\" z=\"0\" h=\"0\"/>";
    };
    ScenarioText text;
    text.privates = teleport(world(0, 0)) + speedAction(10.0) +
                    followTrajectory(vertex(world(0, 0)) + vertex(world(30, 5)) + vertex(world(60, -8)),
                                     "<None/>", "follow");
    text.stories = story(event(
        "a",
        R"(<PrivateAction><RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape>
<Clothoid curvature="0.05" curvaturePrime="0.001" length="50"><Position><RelativeObjectPosition entityRef="Ego" dx="0" dy="0"/></Position></Clothoid></Shape>
</Trajectory></TrajectoryRef><TimeReference><None/></TimeReference><TrajectoryFollowingMode followingMode="position"/></FollowTrajectoryAction></RoutingAction></PrivateAction>)",
        timeCondition(6.5)));
    text.stop = stopAt(1000.0);
    auto parsed = parseScenario(text.text(), "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    PlayerOptions options;
    options.clock = FixedClock::forStep(kControlStepS);
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    std::vector<glm::dvec3> track;
    const glm::dvec3 start = (*player)->entities()[0].position;
    for (int second = 0; second < 12; ++second)
    {
        for (int step = 0; step < 100; ++step)
            (*player)->step();
        track.push_back((*player)->entities()[0].position - start);
    }
    return track;
}

TEST(Shift, ATenThousandKilometresAwayTheSameHappens)
{
    const auto here = relativeTrack(0.0), there = relativeTrack(1e7);
    for (std::size_t i = 0; i < here.size(); ++i)
        EXPECT_LT(glm::length(here[i] - there[i]), 1e-3) << i;
    EXPECT_GT(glm::length(here.back()), 50.0);
}

} // namespace
} // namespace simulation
