// SPDX-License-Identifier: Apache-2.0
// Traffic on a straight road of 1000 m along x: when and where its vehicles are, worked by hand. Lane -1 lies
// at y = -1.75 and runs towards x, lane 1 at 1.75 and runs back. Vehicles without a car-following controller
// keep their speed.
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "../roads/RoadTexts.h"
#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

constexpr double kTrafficStepS = 0.01;

const std::string kKeepsSpeed = R"(<ControllerDistribution><ControllerDistributionEntry weight="1">
<Controller name="DefaultController"><Properties/></Controller></ControllerDistributionEntry></ControllerDistribution>)";

std::string
definition(const std::string& categories = R"(<VehicleCategoryDistributionEntry category="car" weight="1"/>)")
{
    return "<TrafficDefinition name=\"d\"><VehicleCategoryDistribution>" + categories +
           "</VehicleCategoryDistribution>" + kKeepsSpeed + "</TrafficDefinition>";
}

std::string trafficAction(const std::string& content, const std::string& name = "flow")
{
    return "<GlobalAction><TrafficAction trafficName=\"" + name + "\">" + content +
           "</TrafficAction></GlobalAction>";
}

std::string onLaneAt(double s)
{
    return "<Position><LanePosition roadId=\"1\" laneId=\"-1\" s=\"" + std::to_string(s) + "\"/></Position>";
}

std::string source(double s, const std::string& attributes = R"(rate="0.5" radius="0" speed="10")",
                   const std::string& mix = definition())
{
    return "<TrafficSourceAction " + attributes + ">" + onLaneAt(s) + mix + "</TrafficSourceAction>";
}

std::string swarm(const std::string& directions, const std::string& more = "")
{
    return R"(<TrafficSwarmAction semiMajorAxis="100" semiMinorAxis="10" innerRadius="20" offset="0" numberOfVehicles="6">
<CentralObject entityRef="Ego"/>)" +
           definition() + R"(<InitialSpeedRange lowerLimit="10" upperLimit="10"/>)" + directions + more +
           "</TrafficSwarmAction>";
}

std::string area(bool isContinuous, const std::string& shape)
{
    return std::string("<TrafficAreaAction continuous=\"") + (isContinuous ? "true" : "false") +
           "\" numberOfEntities=\"3\">" + definition() + "<TrafficArea>" + shape +
           "</TrafficArea></TrafficAreaAction>";
}

/// Ego stands at s = 500; `globals` are done at the start, `events` later.
std::string trafficText(const std::string& globals, const std::string& events = "")
{
    ScenarioText text;
    text.globals = globals;
    text.privates = "<PrivateAction><TeleportAction>" + onLaneAt(500.0) + "</TeleportAction></PrivateAction>";
    if (!events.empty()) text.stories = story(events);
    text.stop = stopAt(1000.0);
    std::string whole = text.text();
    return whole.replace(whole.find("<RoadNetwork/>"), 14,
                         "<RoadNetwork><LogicFile filepath=\"r.xodr\"/></RoadNetwork>");
}

std::unique_ptr<ScenarioPlayer> trafficPlayer(const std::string& text, std::uint64_t seed = 0,
                                              std::shared_ptr<const RoadScene> roads = nullptr)
{
    auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return nullptr;
    for (const Problem& problem : parsed->problems)
        ADD_FAILURE() << problem.error.message();
    PlayerOptions options;
    options.clock = FixedClock::forStep(kTrafficStepS);
    options.seed = seed;
    options.roads =
        roads ? std::move(roads)
              : std::make_shared<const RoadScene>(roadtexts::sound(roadtexts::network(
                    roadtexts::road("1", 1000.0, roadtexts::straightPlan(1000.0) + roadtexts::twoLanes()))));
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

void playTraffic(ScenarioPlayer& player, double timeS)
{
    while (player.timeS() < timeS - 1e-9)
        player.step();
}

/// The vehicles of the traffic that are there, from the farthest along x.
std::vector<EntityState> present(const ScenarioPlayer& player)
{
    std::vector<EntityState> there;
    for (const EntityState& state : player.entities())
        if (state.name != "Ego" && state.isPresent) there.push_back(state);
    std::sort(there.begin(), there.end(),
              [](const EntityState& a, const EntityState& b) { return a.position.x > b.position.x; });
    return there;
}

std::vector<double> placesAfter(const std::string& text, double timeS)
{
    const auto player = trafficPlayer(text);
    std::vector<double> places;
    if (!player) return places;
    playTraffic(*player, timeS);
    for (const EntityState& state : present(*player))
        places.push_back(state.position.x);
    return places;
}

void expectPlaces(const std::vector<double>& places, const std::vector<double>& expected)
{
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(places[i], expected[i], 1e-6) << i;
}

TEST(TrafficSource, LetsAVehicleAppearEveryTwoSeconds)
{
    // At 0, 2 … 10 s, each at 10 m/s from x = 100.
    expectPlaces(placesAfter(trafficText(trafficAction(source(100.0))), 10.0),
                 {200, 180, 160, 140, 120, 100});
    const auto half = trafficText(trafficAction(source(100.0, R"(rate="0.25" radius="0" speed="10")")));
    expectPlaces(placesAfter(half, 10.0), {200, 160, 120});
}

TEST(TrafficSource, WaitsForRoom)
{
    // At 1 m/s a car has left the place with 8 m of room behind it after 12.5 m of way: 12.5 s, not 2 s.
    const auto slow = trafficText(trafficAction(source(100.0, R"(rate="0.5" radius="0" speed="1")")));
    EXPECT_EQ(placesAfter(slow, 12.4).size(), 1u);
    EXPECT_EQ(placesAfter(slow, 12.6).size(), 2u);
}

TEST(TrafficSource, SpreadsOverTheLanesAroundItsPlace)
{
    const auto player =
        trafficPlayer(trafficText(trafficAction(source(100.0, R"(rate="2" radius="30" velocity="10")"))));
    ASSERT_TRUE(player);
    playTraffic(*player, 20.0);
    bool isThere[2] = {false, false};
    for (const EntityState& state : present(*player))
    {
        EXPECT_NEAR(std::fabs(state.position.y), 1.75, 1e-9);
        isThere[state.position.y > 0.0 ? 1 : 0] = true;
    }
    EXPECT_TRUE(isThere[0] && isThere[1]) << "both lanes are within the radius";
}

TEST(TrafficSource, MakesTheVehiclesOfItsDistribution)
{
    for (const char* const category : {"bus", "truck"})
    {
        const std::string entries =
            std::string("<VehicleCategoryDistributionEntry category=\"car\" weight=\"0\"/>"
                        "<VehicleCategoryDistributionEntry category=\"") +
            category + "\" weight=\"2\"/>";
        const auto player = trafficPlayer(trafficText(
            trafficAction(source(100.0, R"(rate="0.5" radius="0" speed="10")", definition(entries)))));
        ASSERT_TRUE(player);
        const auto& entities = player->scenario().entities;
        ASSERT_GT(entities.size(), 10u);
        for (std::size_t i = 1; i < entities.size(); ++i)
            EXPECT_EQ(std::get<Vehicle>(entities[i].object).category, category);
    }
}

TEST(TrafficSource, TakesTheObjectsOf13)
{
    const std::string mix =
        "<TrafficDistribution><TrafficDistributionEntry "
        "weight=\"1\"><EntityDistribution><EntityDistributionEntry "
        "weight=\"1\"><ScenarioObjectTemplate>" +
        kCar +
        R"(<ObjectController><Controller name="DefaultController"><Properties/></Controller></ObjectController>
</ScenarioObjectTemplate></EntityDistributionEntry></EntityDistribution></TrafficDistributionEntry></TrafficDistribution>)";
    const auto player =
        trafficPlayer(trafficText(trafficAction(source(100.0, R"(rate="0.5" radius="0" speed="10")", mix))));
    ASSERT_TRUE(player);
    EXPECT_EQ(player->scenario().entities.back().box().lengthM, 5.0);
    playTraffic(*player, 3.0);
    ASSERT_EQ(present(*player).size(), 2u);
    EXPECT_NEAR(present(*player)[0].position.x, 130.0, 1e-6);
}

TEST(TrafficStop, LetsThoseDriveOnThatAreThere)
{
    const auto stopped = [](const std::string& name)
    {
        return trafficText(trafficAction(source(100.0)),
                           event("a", trafficAction("<TrafficStopAction/>", name), timeCondition(5.0)));
    };
    expectPlaces(placesAfter(stopped("flow"), 10.0), {200, 180, 160});
    EXPECT_EQ(placesAfter(stopped("another"), 10.0).size(), 6u);
}

TEST(TrafficSink, LetsVehiclesVanishNearItsPlace)
{
    const auto withSink = [](const std::string& attributes, const std::string& mix = "")
    {
        return trafficText(trafficAction(source(100.0)) +
                           trafficAction("<TrafficSinkAction " + attributes + ">" + onLaneAt(150.0) + mix +
                                             "</TrafficSinkAction>",
                                         "sink"));
    };
    expectPlaces(placesAfter(withSink("radius=\"3\""), 10.0), {140, 120, 100});
    // One each 4 s: that of 0 s at 4.7 s; that of 2 s is gone past at 6.7 to 7.3 s, since the next is taken
    // from 8.7 s on.
    expectPlaces(placesAfter(withSink(R"(radius="3" rate="0.25")"), 10.0), {180, 140, 120, 100});
    expectPlaces(placesAfter(withSink(R"(radius="3" rate="0")"), 10.0), {200, 180, 160, 140, 120, 100});
    expectPlaces(
        placesAfter(withSink("radius=\"3\"",
                             definition(R"(<VehicleCategoryDistributionEntry category="bus" weight="1"/>)")),
                    10.0),
        {200, 180, 160, 140, 120, 100});
}

TEST(Traffic, ThatWouldNotBeThereIsTold)
{
    const auto told = [](const std::string& actions) -> std::string
    {
        const auto player = trafficPlayer(trafficText(actions));
        return player && player->warnings().size() == 1 ? player->warnings()[0].message() : std::string();
    };
    const auto sink = [](const std::string& rate)
    {
        return trafficAction("<TrafficSinkAction radius=\"9\"" + rate + ">" + onLaneAt(500.0) +
                             "</TrafficSinkAction>");
    };
    std::string nobody = swarm("");
    nobody.replace(nobody.find("numberOfVehicles=\"6\""), 20, "numberOfVehicles=\"0\"");
    for (const auto& [line, said] :
         {std::pair(told(trafficAction(source(100.0, R"(rate="0" radius="0" speed="10")"))),
                    "the rate 0; instead: no vehicle appears; write how many appear"),
          std::pair(told(sink(" rate=\"0\"")), "the rate 0; instead: no vehicle vanishes"),
          std::pair(told(trafficAction(nobody)), "asks for 0 vehicles; instead: no vehicle appears")})
        EXPECT_NE(line.find(said), std::string::npos) << said << ": " << line;
    for (const std::string rate : {"", " rate=\"0.5\""}) // the control
        EXPECT_EQ(told(sink(rate)), "") << rate;
    EXPECT_EQ(told(trafficAction(source(100.0))), "");
}

TEST(TrafficSink, LeavesTheEntitiesOfTheFile)
{
    const auto player = trafficPlayer(trafficText(
        trafficAction("<TrafficSinkAction radius=\"9\">" + onLaneAt(500.0) + "</TrafficSinkAction>")));
    ASSERT_TRUE(player);
    playTraffic(*player, 1.0);
    EXPECT_TRUE(player->entities()[0].isPresent);
}

TEST(Traffic, VanishesAtTheEndOfTheRoad)
{
    // From x = 950: those of 6, 8 and 10 s are there at 10 s.
    expectPlaces(placesAfter(trafficText(trafficAction(source(950.0))), 10.0), {990, 970, 950});
}

constexpr const char* kSameWay = R"(<DirectionOfTravelDistribution same="1" opposite="0"/>)";

TEST(TrafficSwarm, StaysAroundItsEntity)
{
    const auto player = trafficPlayer(trafficText(trafficAction(swarm(kSameWay))));
    ASSERT_TRUE(player);
    ASSERT_EQ(present(*player).size(), 6u);
    for (const EntityState& state : present(*player))
    {
        const double apart = std::fabs(state.position.x - 500.0);
        EXPECT_TRUE(apart >= 19.9 && apart <= 100.0) << apart;
    }
    std::size_t sum = 0, appeared = 0;
    std::vector<EntityState> before = present(*player);
    for (int i = 0; i < 6000; ++i)
    {
        player->step();
        const auto now = present(*player);
        sum += now.size();
        for (const EntityState& state : now)
        {
            EXPECT_LE(std::fabs(state.position.x - 500.0), 100.0);
            EXPECT_NEAR(state.position.y, -1.75, 1e-9) << "it drives the same way as Ego";
            EXPECT_NEAR(state.speedMps, 10.0, 1e-9);
        }
        appeared +=
            now.size() > 0 && before.size() > 0 && now.back().position.x < before.back().position.x - 1.0;
        before = now;
    }
    EXPECT_GT(sum, 6000u * 5u) << "of six, five are there on the average at least";
    EXPECT_GT(appeared, 5u) << "others take the places of those that have left";
}

TEST(TrafficSwarm, DrivesAgainstItsEntityWhereTheWeightsSaySo)
{
    const auto player = trafficPlayer(
        trafficText(trafficAction(swarm(R"(<DirectionOfTravelDistribution same="0" opposite="1"/>)"))));
    ASSERT_TRUE(player);
    ASSERT_EQ(present(*player).size(), 6u);
    for (const EntityState& state : present(*player))
        EXPECT_NEAR(state.position.y, 1.75, 1e-9);
}

TEST(Traffic, IsTheSameForASeedAndAnotherForAnother)
{
    const auto track = [](std::uint64_t seed)
    {
        std::vector<double> places;
        const auto player = trafficPlayer(trafficText(trafficAction(swarm(""))), seed);
        playTraffic(*player, 5.0);
        for (const EntityState& state : present(*player))
            places.push_back(state.position.x);
        return places;
    };
    EXPECT_EQ(track(7), track(7));
    EXPECT_NE(track(7), track(8));
}

constexpr const char* kStretch =
    R"(<RoadRange length="100"><RoadCursor roadId="1" s="100"><Lane id="-1"/></RoadCursor></RoadRange>)";
constexpr const char* kTwoCursors =
    R"(<RoadRange><RoadCursor roadId="1" s="100"><Lane id="-1"/></RoadCursor><RoadCursor roadId="1" s="200"/></RoadRange>)";
const std::string kRectangle =
    R"(<Polygon><Position><WorldPosition x="100" y="-3"/></Position><Position><WorldPosition x="200" y="-3"/></Position>
<Position><WorldPosition x="200" y="0"/></Position><Position><WorldPosition x="100" y="0"/></Position></Polygon>)";

TEST(TrafficArea, IsFilledOnceOrAgainAndAgain)
{
    for (const std::string& shape : {std::string(kStretch), std::string(kTwoCursors), kRectangle})
        for (const bool isContinuous : {false, true})
        {
            const auto player = trafficPlayer(trafficText(trafficAction(area(isContinuous, shape))));
            ASSERT_TRUE(player);
            const auto first = present(*player);
            ASSERT_EQ(first.size(), 3u);
            for (const EntityState& state : first)
            {
                EXPECT_TRUE(state.position.x >= 100.0 && state.position.x <= 200.0) << state.position.x;
                EXPECT_NEAR(state.position.y, -1.75, 1e-9);
            }
            playTraffic(*player, 20.0);
            const auto last = present(*player);
            ASSERT_EQ(last.size(), 3u);
            for (std::size_t i = 0; i < last.size(); ++i)
                if (isContinuous)
                    EXPECT_TRUE(last[i].position.x >= 100.0 && last[i].position.x <= 200.0);
                else // 50 km/h, since the road has no limit
                    EXPECT_NEAR(last[i].position.x - first[i].position.x, 20.0 * 50.0 / 3.6, 1e-6);
        }
}

TEST(Traffic, FollowsTheVehicleAheadWhereNoControllerIsNamed)
{
    // Behind Ego, which stands at 500 m, the usual driver stops; one that keeps its speed drives through it.
    const std::string usual = R"(<TrafficDefinition name="d"><VehicleCategoryDistribution>
<VehicleCategoryDistributionEntry category="car" weight="1"/></VehicleCategoryDistribution></TrafficDefinition>)";
    const auto farthest = [](const std::string& mix)
    {
        return placesAfter(
                   trafficText(trafficAction(source(400.0, R"(rate="0.01" radius="0" speed="10")", mix))),
                   30.0)
            .at(0);
    };
    EXPECT_LT(farthest(usual), 500.0 - 1.1 - 3.55); // the back of Ego, the front of the car
    EXPECT_GT(farthest(usual), 485.0);
    EXPECT_NEAR(farthest(definition()), 700.0, 1e-6);
}

TEST(Traffic, WithoutRoadsIsToldAndNotMade)
{
    std::string text = trafficText(trafficAction(source(100.0)));
    const std::string logic = "<LogicFile filepath=\"r.xodr\"/>";
    text.replace(text.find(logic), logic.size(), "");
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->problems.size(), 1u);
    EXPECT_NE(parsed->problems[0].error.message().find("traffic without a LogicFile"), std::string::npos);
}

} // namespace
} // namespace simulation
