// SPDX-License-Identifier: Apache-2.0
// Lights and signs of maps: where they stand, who is let pass when, and traffic at them.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/write/WriteNetwork.h>

#include "../simulation/TrafficWatch.h"
#include "MadeStreets.h"
#include "TestFolder.h"
#include "simulation/road/LightApproaches.h"
#include "simulation/road/SignalProgrammes.h"
#include "worldmaking/streets/WaitTags.h"

namespace streetsignals
{
namespace
{

using osgRoads::core::Road;
using osgRoads::core::RoadNetwork;
using osgRoads::core::Signal;

const MadeMap::MapTags kLight{{"highway", "traffic_signals"}};

MadeMap::MapTags lightTowards(const char* direction)
{
    return {{"highway", "traffic_signals"}, {"traffic_signals:direction", direction}};
}

/// A network as a world has it: written and read.
struct MadeNetwork
{
    RoadNetwork network;
    worldmaking::StreetReport report;
};

MadeNetwork networkOf(const MadeMap& map)
{
    const testsupport::TestFolder folder("signals");
    worldmaking::Streets streets = streetsOf(map, [](double, double) { return 100.0; });
    const auto file = folder / "roads.xodr";
    const auto written = osgRoads::core::writeNetwork(streets.network, file);
    EXPECT_TRUE(written) << (written ? "" : written.error().message());
    auto read = osgRoads::core::readNetwork(file);
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    EXPECT_TRUE(read->problems.empty()) << read->problems.front().message("roads.xodr");
    return {std::move(read->network), streets.report};
}

struct PlacedSignal
{
    const Road* road;
    const Signal* signal;
    bool atEnd() const { return signal->s > 0.5 * road->length; }
};

std::vector<PlacedSignal> signalsOf(const RoadNetwork& network, const std::string& type)
{
    std::vector<PlacedSignal> found;
    for (const Road& road : network.roads)
        for (const Signal& signal : road.signals)
            if (signal.type == type) found.push_back({&road, &signal});
    return found;
}

std::size_t objectsOf(const RoadNetwork& network, const std::string& word)
{
    std::size_t count = 0;
    for (const Road& road : network.roads)
        count += static_cast<std::size_t>(
            std::count_if(road.objects.begin(), road.objects.end(),
                          [&](const auto& object) { return object.type == word || object.subtype == word; }));
    return count;
}

std::vector<simulation::TrafficSignalController> programmesOf(const RoadNetwork& network)
{
    return simulation::signalProgrammes(simulation::RoadScene(network));
}

using States = std::map<std::string, std::string>;

States statesIn(const simulation::SignalPhase& phase)
{
    return {phase.states.begin(), phase.states.end()};
}

/// The light that holds for those who drive into a direction, in radians from the east.
std::string lightFor(const RoadNetwork& network, double headingRad)
{
    for (const auto& [road, signal] : signalsOf(network, "1000001"))
    {
        const double heading = road->referenceLine.at(signal->s).headingRad +
                               (signal->orientation == '-' ? 3.14159265358979 : 0.0);
        if (std::cos(heading - headingRad) > 0.9) return signal->id;
    }
    ADD_FAILURE() << "no light for " << headingRad;
    return {};
}

constexpr double kEast = 0.0, kNorth = 1.5707963, kWest = 3.1415926, kSouth = -1.5707963;

/// Each stage has those who face each other, and no other one.
void expectTwoStages(const RoadNetwork& network)
{
    const auto programmes = programmesOf(network);
    ASSERT_EQ(programmes.size(), 1u);
    std::set<std::string> greens;
    for (const auto& phase : programmes[0].phases)
    {
        States states = statesIn(phase);
        const std::string east = states[lightFor(network, kEast)], north = states[lightFor(network, kNorth)];
        EXPECT_EQ(east, states[lightFor(network, kWest)]) << phase.name;
        EXPECT_EQ(north, states[lightFor(network, kSouth)]) << phase.name;
        EXPECT_TRUE(east == "red" || north == "red") << phase.name;
        if (east == "green") greens.insert("east");
        if (north == "green") greens.insert("north");
    }
    EXPECT_EQ(greens.size(), 2u);
}

/// Four arms of 120 m about the origin, joined by a ring. `middle`, `arms`: tags of the nodes at the origin
/// and 15 m before it, to the east, north, west and south; all ways lead outwards. `feet`: of those at 9 m.
MadeMap litCrossing(const MadeMap::MapTags& middle, const std::vector<MadeMap::MapTags>& arms = {},
                    const std::vector<MadeMap::MapTags>& feet = {})
{
    MadeMap map;
    const int origin = map.node(0, 0, middle);
    std::vector<int> ring;
    for (std::size_t arm = 0; arm < 4; ++arm)
    {
        const double x = std::cos(kNorth * static_cast<double>(arm)),
                     y = std::sin(kNorth * static_cast<double>(arm));
        std::vector<int> way{origin};
        if (arm < feet.size()) way.push_back(map.node(9.0 * x, 9.0 * y, feet[arm]));
        if (arm < arms.size()) way.push_back(map.node(15.0 * x, 15.0 * y, arms[arm]));
        ring.push_back(map.node(120.0 * x, 120.0 * y));
        way.push_back(ring.back());
        map.way(way, {{"highway", "tertiary"}});
    }
    ring.push_back(ring.front());
    map.way(ring, {{"highway", "tertiary"}});
    return map;
}

TEST(StreetSignals, ALightAtTheMiddleIsForAllWhoCome)
{
    const MadeNetwork made = networkOf(litCrossing(kLight));
    const auto& network = made.network;
    const auto lights = signalsOf(network, "1000001");
    ASSERT_EQ(lights.size(), 4u);
    for (const PlacedSignal& light : lights)
    {
        EXPECT_TRUE(light.signal->isDynamic);
        EXPECT_EQ(light.signal->orientation, light.atEnd() ? '+' : '-');
        EXPECT_LT(light.atEnd() ? light.road->length - light.signal->s : light.signal->s, 2.0);
        const double rightwards = light.signal->orientation == '+' ? -light.signal->t : light.signal->t;
        EXPECT_GT(rightwards, 3.0);
        EXPECT_LT(rightwards, 6.0);
    }
    EXPECT_EQ(objectsOf(network, "stopLine"), 4u);
    ASSERT_EQ(network.controllers.size(), 1u);
    EXPECT_EQ(network.controllers[0].controls.size(), 4u);
    EXPECT_EQ(std::count_if(network.junctions.begin(), network.junctions.end(),
                            [&](const auto& junction)
                            { return junction.controllerIds == std::vector{network.controllers[0].id}; }),
              1);
    EXPECT_EQ(made.report.litPlaces, 1u);
    EXPECT_EQ(made.report.trafficLights, 4u);
    expectTwoStages(network);
}

/// All ways lead outwards, so those who come drive backward along them.
TEST(StreetSignals, LightsBesideTheMiddleAreForTheirDirection)
{
    const auto at = lightTowards("backward");
    const auto all = networkOf(litCrossing({}, {at, at, at, at}));
    EXPECT_EQ(signalsOf(all.network, "1000001").size(), 4u);
    expectTwoStages(all.network);
    const auto undirected = networkOf(litCrossing({}, {kLight, kLight, kLight, kLight}));
    expectTwoStages(undirected.network);
    // The fourth arm is forgotten in the map: it has a light all the same.
    const auto three = networkOf(litCrossing({}, {at, at, at, {}}));
    EXPECT_EQ(signalsOf(three.network, "1000001").size(), 4u);
    expectTwoStages(three.network);
    // The mutation: lights for those who leave are no lights of the crossing.
    const auto away = lightTowards("forward");
    const auto leaving = networkOf(litCrossing({}, {away, away, away, away}));
    for (const auto& junction : leaving.network.junctions)
        EXPECT_TRUE(junction.controllerIds.empty());
}

TEST(StreetSignals, ALightOfOneArmStopsThatStreetAlone)
{
    const auto one = networkOf(litCrossing({}, {lightTowards("backward"), {}, {}, {}}));
    EXPECT_EQ(signalsOf(one.network, "1000001").size(), 1u);
    EXPECT_EQ(one.report.litPlaces, 1u);
    for (const auto& junction : one.network.junctions)
        EXPECT_TRUE(junction.controllerIds.empty());
}

MadeMap streetWith(const MadeMap::MapTags& tags)
{
    MadeMap map;
    map.way({map.node(0, 0), map.node(150, 0, tags), map.node(300, 0)}, {{"highway", "secondary"}});
    return map;
}

TEST(StreetSignals, ACrossingForPeopleStopsBothDirections)
{
    const auto [network, report] =
        networkOf(streetWith({{"highway", "crossing"}, {"crossing", "traffic_signals"}}));
    EXPECT_EQ(signalsOf(network, "1000001").size(), 2u);
    const auto people = signalsOf(network, "1000002");
    ASSERT_EQ(people.size(), 2u);
    EXPECT_EQ(objectsOf(network, "crosswalk"), 1u);
    for (const PlacedSignal& light : signalsOf(network, "1000001"))
        EXPECT_NEAR(light.signal->s - 0.5 * light.road->length, light.signal->orientation == '+' ? -2.5 : 2.5,
                    0.1);
    const auto programmes = programmesOf(network);
    ASSERT_EQ(programmes.size(), 1u);
    std::map<std::string, double> walkS, driveS;
    for (const auto& phase : programmes[0].phases)
    {
        States states = statesIn(phase);
        ASSERT_EQ(states.size(), 4u) << phase.name;
        const std::string walk = states[people[0].signal->id];
        const std::string drive = states[lightFor(network, kEast)];
        EXPECT_EQ(drive, states[lightFor(network, kWest)]);
        EXPECT_EQ(walk, states[people[1].signal->id]);
        EXPECT_TRUE(walk == "red" || drive == "red") << phase.name;
        walkS[walk] += phase.durationS;
        driveS[drive] += phase.durationS;
    }
    EXPECT_GE(walkS["green"], 5.0);
    EXPECT_GE(driveS["green"], 30.0);
}

/// A crossing that is near to a junction without lights is not the junction's, in either direction.
TEST(StreetSignals, ACrossingBesideAnUnlitJunctionHasAProgrammeOfItsOwn)
{
    const auto made =
        networkOf(litCrossing({}, {{{"highway", "crossing"}, {"crossing", "traffic_signals"}}, {}, {}, {}}));
    const auto programmes = programmesOf(made.network);
    ASSERT_EQ(programmes.size(), 1u);
    EXPECT_EQ(signalsOf(made.network, "1000001").size(), 2u);
    for (const auto& phase : programmes[0].phases)
    {
        States states = statesIn(phase);
        EXPECT_EQ(states.size(), 4u);
        EXPECT_EQ(states[lightFor(made.network, kEast)], states[lightFor(made.network, kWest)]);
    }
    // The mutation: without the network's controller each direction has a programme.
    RoadNetwork without = made.network;
    without.controllers.clear();
    EXPECT_EQ(programmesOf(without).size(), 2u);
}

TEST(StreetSignals, ALightInTheMiddleOfAStreetIsForWhomTheMapSays)
{
    EXPECT_EQ(signalsOf(networkOf(streetWith(kLight)).network, "1000001").size(), 2u);
    const auto one = networkOf(streetWith(lightTowards("backward")));
    const auto lights = signalsOf(one.network, "1000001");
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_EQ(lights[0].signal->orientation, '-');
    EXPECT_TRUE(signalsOf(one.network, "1000002").empty());
    EXPECT_EQ(programmesOf(one.network).size(), 1u);
    const auto blinks =
        networkOf(streetWith({{"highway", "traffic_signals"}, {"traffic_signals", "blinker"}}));
    EXPECT_TRUE(signalsOf(blinks.network, "1000001").empty());
}

/// The post of a light above lanes stands beside the nearer edge; on the left may be the other carriageway.
TEST(StreetSignals, LightsAboveLanesHangFromTheRight)
{
    for (const char* direction : {"forward", "backward"})
    {
        MadeMap map;
        const int at = map.node(150, 0, kLight);
        map.way({map.node(0, 0), at, map.node(300, 0)},
                {{"highway", "secondary"},
                 {"oneway", direction == std::string("forward") ? "yes" : "-1"},
                 {"lanes", "2"},
                 {"sidewalk", "right"}});
        const auto made = networkOf(map);
        const auto lights = signalsOf(made.network, "1000001");
        ASSERT_EQ(lights.size(), 2u);
        int above = 0;
        for (const auto& [road, light] : lights)
        {
            if (light->zOffset < 3.0) continue;
            ++above;
            const auto lanes = osgRoads::core::extentAt(*road, light->s);
            const double toLeft = lanes.leftT - light->t, toRight = light->t - lanes.rightT;
            EXPECT_GT(light->orientation == '+' ? toLeft - toRight : toRight - toLeft, 0.4) << direction;
        }
        EXPECT_EQ(above, 1) << direction;
    }
}

/// A street that crosses two carriageways 14 m apart. `west`, `east`: tags of the crossings; `approach`: of
/// the nodes before them.
MadeMap dualCarriageway(const MadeMap::MapTags& crossing, const MadeMap::MapTags& approach)
{
    MadeMap map;
    const int west = map.node(-7, 0, crossing), east = map.node(7, 0, crossing);
    map.way({map.node(-150, 0), map.node(-25, 0, approach), west, east, map.node(25, 0, approach),
             map.node(150, 0)},
            {{"highway", "tertiary"}});
    map.way({map.node(-7, 150), map.node(-7, 22, approach), west, map.node(-7, -150)},
            {{"highway", "primary"}, {"oneway", "yes"}});
    map.way({map.node(7, -150), map.node(7, -22, approach), east, map.node(7, 150)},
            {{"highway", "primary"}, {"oneway", "yes"}});
    return map;
}

TEST(StreetSignals, TwoCrossingsOfADualCarriagewayHaveOneProgramme)
{
    for (const bool isAtMiddle : {true, false})
    {
        const auto made = networkOf(isAtMiddle ? dualCarriageway(kLight, {}) : dualCarriageway({}, kLight));
        EXPECT_EQ(signalsOf(made.network, "1000001").size(), 4u) << "none between both crossings";
        ASSERT_EQ(made.network.controllers.size(), 1u);
        for (const auto& junction : made.network.junctions)
            EXPECT_EQ(junction.controllerIds.size(), 1u);
        expectTwoStages(made.network);
        // The mutation: with controllers of their own they are two.
        RoadNetwork apart = made.network;
        apart.junctions[0].controllerIds.clear();
        EXPECT_EQ(programmesOf(apart).size(), 2u);
    }
}

/// People cross an arm when nobody has green who comes over it or drives straight into it, and the last one
/// is across when somebody has.
TEST(StreetSignals, PeopleCrossWithThoseWhomTheyDoNotMeet)
{
    const MadeMap::MapTags foot{{"highway", "crossing"}, {"crossing", "traffic_signals"}};
    const auto [network, report] = networkOf(litCrossing(kLight, {}, {foot, foot, foot, foot}));
    const auto people = signalsOf(network, "1000002");
    ASSERT_EQ(people.size(), 8u);
    EXPECT_EQ(signalsOf(network, "1000001").size(), 4u);
    const auto programmes = programmesOf(network);
    ASSERT_EQ(programmes.size(), 1u);
    for (const PlacedSignal& light : people)
    {
        std::string across; // who comes over the arm, whom those who drive straight into it face
        for (const auto& [road, signal] : signalsOf(network, "1000001"))
            if (road == light.road) across = signal->id;
        ASSERT_FALSE(across.empty());
        double greenS = 0.0, sinceS = 1e9, leastS = 1e9;
        for (int cycle = 0; cycle < 2; ++cycle)
            for (const auto& phase : programmes[0].phases)
            {
                States states = statesIn(phase);
                const bool mayWalk = states[light.signal->id] == "green";
                EXPECT_FALSE(mayWalk && states[across] != "red") << phase.name;
                if (states[across] == "green") leastS = std::min(leastS, sinceS);
                sinceS = mayWalk ? 0.0 : sinceS + phase.durationS;
                if (mayWalk) greenS += phase.durationS;
            }
        EXPECT_GE(greenS, 2.0 * 5.0);
        EXPECT_GE(leastS, 6.0 / 1.2) << "two lanes of 3 m";
        EXPECT_LT(leastS, 30.0);
    }
}

/// The crossing without lights is nearer to the stripes, but those who wait at them would stand in the other.
TEST(StreetSignals, PeopleCrossWithTheCrossingThatHasLights)
{
    MadeMap map;
    const int lit = map.node(0, 0, kLight), unlit = map.node(28, 0);
    const int foot = map.node(18, 0, {{"highway", "crossing"}, {"crossing", "traffic_signals"}});
    map.way({map.node(-120, 0), lit, foot, unlit, map.node(150, 0)}, {{"highway", "tertiary"}});
    map.way({map.node(0, -120), lit, map.node(0, 120)}, {{"highway", "tertiary"}});
    map.way({unlit, map.node(28, 120)}, {{"highway", "tertiary"}});
    const auto made = networkOf(map);
    EXPECT_EQ(signalsOf(made.network, "1000002").size(), 2u);
    EXPECT_EQ(signalsOf(made.network, "1000001").size(), 4u);
    EXPECT_EQ(programmesOf(made.network).size(), 1u);
}

TEST(StreetSignals, SignsAreForThoseWhoComeToTheCrossing)
{
    const MadeMap::MapTags stop{{"highway", "stop"}},
        give{{"highway", "give_way"}, {"direction", "backward"}},
        wrong{{"highway", "give_way"}, {"direction", "forward"}};
    const auto [network, report] = networkOf(litCrossing({}, {stop, give, wrong, {}}));
    EXPECT_EQ(report.waitSigns, 2u);
    EXPECT_EQ(signalsOf(network, "206").size(), 1u);
    EXPECT_EQ(signalsOf(network, "205").size(), 1u);
    EXPECT_EQ(objectsOf(network, "yieldLine"), 1u);
    EXPECT_TRUE(network.controllers.empty());
    for (const auto& [road, signal] : signalsOf(network, "206"))
        EXPECT_EQ(signal->orientation, signal->s > 0.5 * road->length ? '+' : '-');
    EXPECT_EQ(networkOf(litCrossing(kLight, {stop, give, {}, {}})).report.waitSigns, 0u) << "lights hold";
}

TEST(StreetSignals, TagsInListsAreRead)
{
    using worldmaking::waitTagsOf;
    EXPECT_TRUE(waitTagsOf({{"highway", "crossing; traffic_signals"}}).isLight);
    EXPECT_FALSE(waitTagsOf({{"highway", "not_traffic_signals"}}).isLight);
    EXPECT_TRUE(waitTagsOf({{"highway", "crossing"}, {"crossing", "traffic_signals;marked"}}).isFootLight);
    EXPECT_TRUE(waitTagsOf({{"highway", "crossing"}, {"crossing:signals", "yes"}}).isFootLight);
    EXPECT_TRUE(waitTagsOf({{"highway", "crossing"}, {"crossing", "marked"}}).isEmpty());
    EXPECT_FALSE(waitTagsOf({{"highway", "traffic_signals"}, {"traffic_signals", "emergency"}}).isLight);
}

/// Traffic around the crossings of a map.
void expectOrder(const MadeMap& map, double perKm, double untilS, double mostStandS)
{
    using namespace simulation::trafficnetworks;
    const auto roads = std::make_shared<const simulation::RoadScene>(networkOf(map).network);
    const auto player = playerOf(trafficAround({60.0, 25.0}, perKm, 1000.0), roads, 0, 30);
    ASSERT_TRUE(player);
    std::set<std::string> seenStates;
    const Watched seen = watch(*player, untilS,
                               [&]
                               {
                                   for (const auto& [light, state] : player->signalStates())
                                       seenStates.insert(state);
                               });
    EXPECT_EQ(seen.collisions, 0);
    EXPECT_LT(seen.longestStandS, mostStandS);
    EXPECT_GE(seen.most, 5u);
    EXPECT_EQ(seenStates, (std::set<std::string>{"attention", "green", "red", "yellow"}));
    testing::Test::RecordProperty("standsS", std::to_string(seen.longestStandS));
}

TEST(StreetSignals, TrafficKeepsOrderAtACrossingOfAMap)
{
    expectOrder(litCrossing(kLight), 15.0, 180.0, 120.0);
}

/// Three streets meet at a triangle of short ones, round which all drive the same way, as where a map draws
/// the islands of a junction. Those who drew turns without regard to whence they came went round it and back,
/// and waited in it for those who waited for them: one stood 118 s, and four pairs touched.
MadeMap triangle(const MadeMap::MapTags& tags)
{
    MadeMap map;
    std::vector<int> corners, ends;
    for (int i = 0; i < 3; ++i)
    {
        const double angle = 2.0943951 * i, x = std::cos(angle), y = std::sin(angle);
        corners.push_back(map.node(11.0 * x, 11.0 * y, tags));
        ends.push_back(map.node(120.0 * x, 120.0 * y));
        map.way({corners.back(), ends.back()}, {{"highway", "tertiary"}});
    }
    corners.push_back(corners.front());
    ends.push_back(ends.front());
    map.way(corners, {{"highway", "tertiary"}, {"oneway", "yes"}});
    map.way(ends, {{"highway", "tertiary"}});
    return map;
}

TEST(StreetSignals, TrafficPassesATriangleOfShortStreets)
{
    expectOrder(triangle(kLight), 40.0, 600.0, 60.0);
}

} // namespace
} // namespace streetsignals
