// SPDX-License-Identifier: Apache-2.0
// Networks of small made maps, checked as roadtool checks a file; and what the checks see when something is
// moved.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/LaneGraph.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/write/WriteNetwork.h>

#include "MadeStreets.h"
#include "TestFolder.h"
#include "worldmaking/streets/ImpliedBridges.h"

namespace
{

using namespace osgRoads::core;
using worldmaking::Streets;

double hillside(double eastM, double northM)
{
    return 1000.0 + 0.06 * eastM + 0.04 * northM + 3.0 * std::sin(eastM / 90.0);
}

/// A village: a main road with three lanes for a part of it, a side street at each of two crossings, a
/// roundabout.
MadeMap village()
{
    MadeMap map;
    const int a = map.node(0, 0), b = map.node(150, 10), c = map.node(300, 0), d = map.node(420, 40);
    map.way({a, b}, {{"highway", "secondary"}, {"name", "Main"}});
    map.way({b, c}, {{"highway", "secondary"}, {"lanes", "3"}, {"sidewalk", "both"}});
    map.way({c, d}, {{"highway", "secondary"}});
    map.way({b, map.node(140, 90), map.node(200, 140)});
    map.way({c, map.node(310, -80)}, {{"highway", "service"}});
    std::vector<int> ring = {d};
    for (int i = 1; i < 8; ++i)
        ring.push_back(map.node(435.0 - 15.0 * std::cos(i * 0.785), 40.0 - 15.0 * std::sin(i * 0.785)));
    ring.push_back(d);
    map.way(ring, {{"highway", "secondary"}, {"junction", "roundabout"}});
    map.way({ring[4], map.node(560, 45)});
    return map;
}

/// Writes the network and reads it again: links are resolved then.
RoadNetwork readBack(const RoadNetwork& network, const testsupport::TestFolder& folder)
{
    const auto file = folder / "roads.xodr";
    const auto written = writeNetwork(network, file);
    EXPECT_TRUE(written) << (written ? "" : written.error().message());
    auto read = readNetwork(file);
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    EXPECT_TRUE(read->problems.empty()) << read->problems.front().message("roads.xodr");
    return std::move(read->network);
}

TEST(BuildStreets, AVillageOnAHillsideHasNoGapKinkOrStep)
{
    const testsupport::TestFolder folder("streets");
    const Streets streets = streetsOf(village(), hillside);
    const RoadNetwork network = readBack(streets.network, folder);
    JointLimits limits;
    limits.laneStepM = 0.01;
    const NetworkFlaws flaws = checkNetwork(network, limits);
    for (const Flaw& flaw : flaws.flaws)
        ADD_FAILURE() << flaw.message("village");
    EXPECT_GT(flaws.laneJoints, 30u);
    EXPECT_LE(steepestOf(network), 0.15 + 1e-9);
    EXPECT_EQ(streets.report.crossings, 4u);
}

TEST(BuildStreets, TheChecksSeeAConnectingRoadThatIsMovedOrRaised)
{
    const testsupport::TestFolder folder("streets");
    for (const bool isRaised : {false, true})
    {
        Streets streets = streetsOf(village(), hillside);
        const auto last = std::find_if(streets.network.roads.rbegin(), streets.network.roads.rend(),
                                       [](const Road& turn) {
                                           return !turn.sections.front().right.empty() &&
                                                  isForCars(turn.sections.front().right.front().type);
                                       });
        ASSERT_NE(last, streets.network.roads.rend());
        Road& road = *last;
        ASSERT_FALSE(road.junctionId.empty());
        if (isRaised)
        {
            std::vector<Cubic> pieces = road.elevation.pieces();
            for (Cubic& piece : pieces)
                piece.a += 0.06;
            road.elevation = CubicProfile(std::move(pieces));
        }
        else
            road.laneOffset = CubicProfile({Cubic{0.0, 0.02}});
        const NetworkFlaws flaws = checkNetwork(readBack(streets.network, folder));
        EXPECT_GE(flaws.count(isRaised ? FlawKind::step : FlawKind::gap), 2u);
    }
}

TEST(BuildStreets, EveryStreetCanBeReachedFromEveryOther)
{
    const testsupport::TestFolder folder("streets");
    const RoadNetwork network = readBack(streetsOf(village(), hillside).network, folder);
    for (const Junction& junction : network.junctions)
        for (const JunctionConnection& connection : junction.connections)
        {
            EXPECT_GE(connection.incomingRoad, 0);
            EXPECT_GE(connection.connectingRoad, 0);
        }
    std::size_t linked = 0;
    for (const Road& road : network.roads)
        if (!road.junctionId.empty()) linked += road.predecessor->index >= 0 && road.successor->index >= 0;
    // Beside the turns a crossing has edges at the corners where nobody turns.
    const std::size_t edges = std::count_if(
        network.roads.begin(), network.roads.end(),
        [](const Road& road)
        {
            return !road.junctionId.empty() &&
                   std::none_of(road.sections.front().right.begin(), road.sections.front().right.end(),
                                [](const Lane& lane) { return isForCars(lane.type); });
        });
    EXPECT_EQ(linked, streetsOf(village(), hillside).report.turns + edges);
}

TEST(BuildStreets, AForbiddenTurnHasNoConnectingRoad)
{
    MadeMap map;
    const int a = map.node(0, 0), b = map.node(100, 0), c = map.node(200, 0), d = map.node(100, 80);
    const int west = map.way({a, b}), north = map.way({b, d});
    map.way({b, c});
    EXPECT_EQ(streetsOf(map, hillside).report.turns, 6u);
    map.rule("no_left_turn", west, b, north);
    EXPECT_EQ(streetsOf(map, hillside).report.turns, 5u);
    map.rule("only_straight_on", north, b, west); // from the north to the west alone
    EXPECT_EQ(streetsOf(map, hillside).report.turns, 4u);
}

TEST(BuildStreets, SteepGroundIsCutToTheGradeOfTheClass)
{
    // A ridge of 30 m over 200 m: 30 % on either side; a primary road may have 10 %.
    const auto ridge = [](double eastM, double) { return 30.0 * std::exp(-std::pow(eastM / 120.0, 2.0)); };
    MadeMap map;
    map.way({map.node(-600, 0), map.node(600, 0)}, {{"highway", "primary"}});
    const Streets streets = streetsOf(map, ridge);
    EXPECT_LE(steepestOf(streets.network), 0.10 + 1e-9);
    EXPECT_GT(steepestOf(streets.network), 0.09);
    MadeMap lane;
    lane.way({lane.node(-600, 0), lane.node(600, 0)}, {{"highway", "unclassified"}});
    EXPECT_GT(steepestOf(streetsOf(lane, ridge).network), 0.14);
}

TEST(BuildStreets, ATunnelRunsBelowTheHillAndABridgeOverTheValley)
{
    const auto hill = [](double eastM, double) { return 80.0 * std::exp(-std::pow(eastM / 150.0, 2.0)); };
    for (const bool isTunnel : {true, false})
    {
        MadeMap map;
        const int a = map.node(-700, 0), b = map.node(-350, 0), c = map.node(350, 0), d = map.node(700, 0);
        map.way({a, b}, {{"highway", "secondary"}});
        map.way({b, c}, {{"highway", "secondary"}, {isTunnel ? "tunnel" : "bridge", "yes"}});
        map.way({c, d}, {{"highway", "secondary"}});
        const auto ground = [&](double eastM, double northM)
        { return isTunnel ? hill(eastM, northM) : -hill(eastM, northM); };
        const Streets streets = streetsOf(map, ground);
        ASSERT_EQ(streets.network.roads.size(), 1u);
        const Road& road = streets.network.roads[0];
        ASSERT_EQ(road.structures.size(), 1u);
        EXPECT_NEAR(road.structures[0].length, 700.0, 4.0);
        for (double s = 0.0; s <= road.length; s += 10.0)
            EXPECT_NEAR(road.elevation.value(s), 0.0, 3.0) << s; // 80 m of hill above or valley below
    }
}

TEST(BuildStreets, ABridgeHasHeadroomOverTheStreetBelow)
{
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"highway", "primary"}});
    const int b = map.node(0, -40), c = map.node(0, 40);
    map.way({map.node(0, -300), b});
    map.way({b, c}, {{"highway", "residential"}, {"bridge", "yes"}});
    map.way({c, map.node(0, 300)});
    const auto flat = [](double, double) { return 100.0; };
    const Streets streets = streetsOf(map, flat);
    EXPECT_EQ(streets.report.overpasses, 1u);
    EXPECT_EQ(streets.report.lostOverpasses, 0u);
    ASSERT_EQ(streets.network.roads.size(), 2u);
    const Road& below = streets.network.roads[0];
    const Road& above = streets.network.roads[1];
    EXPECT_GT(above.elevation.value(0.5 * above.length) - below.elevation.value(0.5 * below.length), 5.4);
}

TEST(BuildStreets, StreetsBeyondTheGroundAreLeftOutAndCounted)
{
    const auto west = [](double eastM, double) -> std::optional<double>
    {
        if (eastM > 1000.0) return std::nullopt;
        return 10.0;
    };
    MadeMap map;
    map.way({map.node(0, 0), map.node(100, 0)});
    map.way({map.node(900, 0), map.node(1100, 0)});
    const Streets streets = streetsOf(map, west);
    EXPECT_EQ(streets.network.roads.size(), 1u);
    EXPECT_EQ(streets.report.waysBeyondGround, 1u);
}

TEST(WriteNetwork, TellsWhatItWouldLose)
{
    const testsupport::TestFolder folder("streets");
    Streets streets = streetsOf(village(), hillside);
    streets.network.roads[0].signals.emplace_back().post = Signal::Post{};
    const auto written = writeNetwork(streets.network, folder / "lost.xodr");
    ASSERT_FALSE(written);
    EXPECT_NE(
        written.error().message().find(
            "road 0 has a signal with a post elsewhere, dependencies or references, which is not written"),
        std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "lost.xodr"));
}

/// The heights of two streets `apartM` beside each other, the second 8 m higher on a terrace, in their
/// middles.
double heightBetween(double apartM)
{
    MadeMap map;
    map.way({map.node(-150, 0), map.node(150, 0)});
    map.way({map.node(-150, apartM), map.node(150, apartM)});
    const Streets streets =
        streetsOf(map, [&](double, double northM) { return northM < 0.5 * apartM ? 1000.0 : 1008.0; });
    const auto& roads = streets.network.roads;
    return std::fabs(roads[1].elevation.value(0.5 * roads[1].length) -
                     roads[0].elevation.value(0.5 * roads[0].length));
}

TEST(BuildStreets, StreetsCloseToEachOtherHaveHeightsThatFitTogether)
{
    EXPECT_LT(heightBetween(9.0), 2.0);
    EXPECT_NEAR(heightBetween(40.0), 8.0, 0.1); // the first could fail
}

TEST(BuildStreets, ATurnBetweenTwoBridgesIsABridge)
{
    MadeMap map;
    const int middle = map.node(0, 0);
    map.way({map.node(-100, 0), middle}, {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({middle, map.node(100, 0)}, {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({middle, map.node(0, 100)});
    const Streets streets = streetsOf(map, [](double, double) { return 1000.0; });
    std::size_t bridges = 0, turns = 0;
    for (const Road& road : streets.network.roads)
    {
        if (road.junctionId.empty()) continue;
        ++turns;
        if (road.structures.empty()) continue;
        ++bridges;
        EXPECT_EQ(road.structures.front().kind, StructureKind::bridge);
        EXPECT_NEAR(road.structures.front().length, road.length, 1e-6);
    }
    EXPECT_EQ(turns, 6u);
    EXPECT_EQ(bridges, 2u); // straight on, in both directions
}

/// How many bridges a street needs that runs 5 m beside another, `higherM` above it.
std::size_t bridgesBeside(double higherM)
{
    const auto straight = [](double northM, double heightM)
    {
        MadeMap map;
        map.way({map.node(-60, northM), map.node(60, northM)});
        return streetsOf(map, [heightM](double, double) { return heightM; }).network.roads.front();
    };
    RoadNetwork network;
    network.roads = {straight(0.0, 1000.0), straight(0.0, 1000.0 + higherM)};
    network.roads[1].id = "1";
    network.roads[1].laneOffset = CubicProfile({Cubic{0.0, 6.0}});
    network.index();
    const std::size_t count = worldmaking::addImpliedBridges(network);
    EXPECT_TRUE(network.roads[0].structures.empty());
    EXPECT_EQ(network.roads[1].structures.size(), count);
    return count;
}

TEST(BuildStreets, AStreetThatNoGroundCanCarryBesideALowerOneIsABridge)
{
    EXPECT_EQ(bridgesBeside(8.0), 1u);
    EXPECT_EQ(bridgesBeside(0.8), 0u); // a bed and the skirt of the surface hide that
}

} // namespace
