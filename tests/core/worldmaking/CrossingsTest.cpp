// SPDX-License-Identifier: Apache-2.0
// Ways that cross in small made maps: each finds its room, and a world that is damaged there is found.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgRoads/core/query/RoadSurface.h>

#include "MadeCrossings.h"
#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/WayLevel.h"

namespace
{

using namespace worldmaking;
using namespace madecrossings;

double highestOf(const Road& road)
{
    double most = -1e9;
    for (int i = 0; i <= 400; ++i)
        most = std::max(most, road.elevation.value(road.length * i / 400.0));
    return most;
}

double lowestOf(const Road& road)
{
    double least = 1e9;
    for (int i = 0; i <= 400; ++i)
        least = std::min(least, road.elevation.value(road.length * i / 400.0));
    return least;
}

TEST(WayLevels, TheLayerDecidesThenBridgeAndTunnel)
{
    const WayLevel bridge = levelOf({{"bridge", "viaduct"}}), tunnel = levelOf({{"tunnel", "yes"}}),
                   ground = levelOf({});
    EXPECT_EQ(bridge.layer, 1);
    EXPECT_EQ(tunnel.layer, -1);
    EXPECT_EQ(aboveOf(bridge, ground), 1);
    EXPECT_EQ(aboveOf(tunnel, ground), -1);
    EXPECT_EQ(aboveOf(levelOf({{"layer", "-1"}}), ground), -1);
    EXPECT_EQ(aboveOf(levelOf({{"bridge", "yes"}, {"layer", "2"}}), bridge), 1);
    EXPECT_EQ(aboveOf(levelOf({{"tunnel", "yes"}, {"layer", "-2"}}), tunnel), -1);
    EXPECT_EQ(aboveOf(levelOf({{"bridge", "yes"}, {"layer", "0"}}), ground), 1);
    EXPECT_EQ(aboveOf(bridge, levelOf({{"bridge", "yes"}})), 0);
    EXPECT_EQ(levelOf({{"tunnel", "building_passage"}}).place, StreetPlace::ground);
    EXPECT_EQ(levelOf({{"layer", "first"}}).layer, 0);
}

TEST(Crossings, ABridgeStandsOverTwoTracksWithWiresAndTheyStayOnTheGround)
{
    MadeMap map;
    addStreet(map, 0, "over", {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    addAcross(map, -3, {{"railway", "rail"}, {"electrified", "contact_line"}});
    addAcross(map, 3, {{"railway", "rail"}, {"electrified", "contact_line"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_GT(highestOf(made.road("over")), 206.9); // 5.9 m of wire, a deck of 1.2 m
    EXPECT_LE(steepestOf(made.streets.network), 0.12 + 1e-9);
    for (const Track& track : made.streets.tracks)
        for (const double heightM : track.heightsM)
            EXPECT_NEAR(heightM, 200.0, 0.05);
    EXPECT_TRUE(made.faults().empty());
    EXPECT_TRUE(made.streets.report.notes.empty());
}

TEST(Crossings, ALevelCrossingStaysLevelAndTheRailsLieInTheStreet)
{
    MadeMap map;
    const int shared = map.node(0, 0);
    map.way({map.node(-300, 0), shared, map.node(300, 0)}, {{"highway", "tertiary"}, {"name", "street"}});
    map.way({map.node(0, -300), shared, map.node(0, 300)}, {{"railway", "rail"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_EQ(made.streets.report.levelCrossings, 1u);
    const Road& street = made.road("street");
    EXPECT_LT(highestOf(street), 200.3);
    EXPECT_TRUE(street.structures.empty());
    double leastM = 1e9;
    for (const Track& track : made.streets.tracks)
        for (const double heightM : track.heightsM)
            leastM = std::min(leastM, heightM + kRailTopM);
    EXPECT_NEAR(leastM, highestOf(street) + 0.02, 0.02);
    EXPECT_TRUE(made.faults().empty());
}

TEST(Crossings, TwoStreetsBesideEachOtherCrossARailwayOnTheirLevels)
{
    // Carriageways of one road, 14 m apart, on a slope along the railway.
    MadeMap map;
    for (const double northM : {-7.0, 7.0})
        map.way({map.node(-400, northM), map.node(0, northM), map.node(400, northM)},
                {{"highway", "secondary"}, {"oneway", "yes"}, {"name", northM < 0.0 ? "first" : "second"}});
    map.way({map.node(0, -300), map.node(0, -7), map.node(0, 7), map.node(0, 300)}, {{"railway", "rail"}});
    const MadeCrossing made = crossingOf(map, [](double eastM, double northM)
                                         { return 200.0 + 0.02 * northM + 0.5 * std::sin(0.02 * eastM); });
    EXPECT_TRUE(made.faults().empty());
    for (const char* name : {"first", "second"})
    {
        const Road& road = made.road(name);
        const double streetM = road.elevation.value(0.5 * road.length);
        const glm::dvec2 at = road.referenceLine.at(0.5 * road.length).position;
        for (const RailLine& line : made.rails())
            for (const glm::dvec3& place : line.points)
                if (glm::distance(glm::dvec2(place), at) < 0.5)
                {
                    EXPECT_NEAR(place.z + kRailTopM, streetM, 0.05) << name;
                }
    }
}

TEST(Crossings, AtANodeOfOneLineAloneCountOnce)
{
    MadeMap map;
    map.way({map.node(-400, 0), map.node(0, 0), map.node(400, 0)},
            {{"highway", "secondary"}, {"name", "main"}});
    map.way({map.node(0, -300), map.node(0, 300)}, {{"railway", "rail"}}); // no node where they cross
    const MadeCrossing made = crossingOf(map);
    EXPECT_EQ(made.streets.report.overpassesLeftOpen, 1u);
    EXPECT_EQ(made.streets.report.notes.size(), 1u);
    EXPECT_TRUE(made.faults().empty());
}

TEST(Crossings, AStreetOverAStreetOverARailwayHasThreeLevels)
{
    MadeMap map;
    addStreet(map, 0, "middle", {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    addAcross(map, 12, {{"railway", "rail"}});
    const int b = map.node(-12, -60), c = map.node(-12, 60);
    map.way({map.node(-12, -500), b}, {{"highway", "secondary"}, {"name", "top"}});
    map.way({b, c}, {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "2"}});
    map.way({c, map.node(-12, 500)}, {{"highway", "secondary"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_EQ(made.streets.report.overpasses, 2u);
    EXPECT_GT(made.road("top").elevation.value(500.0), made.road("middle").elevation.value(388.0) + 5.7);
    EXPECT_GT(highestOf(made.road("middle")), 200.0 + 6.2);
    EXPECT_TRUE(made.faults().empty());
}

TEST(Crossings, ATunnelBelowATunnelAndBothBelowTheGround)
{
    MadeMap map;
    addStreet(map, 0, "upper", {{"highway", "secondary"}, {"tunnel", "yes"}, {"layer", "-1"}});
    const int b = map.node(0, -60), c = map.node(0, 60);
    map.way({map.node(0, -500), b}, {{"highway", "secondary"}, {"name", "lower"}});
    map.way({b, c}, {{"highway", "secondary"}, {"tunnel", "yes"}, {"layer", "-2"}});
    map.way({c, map.node(0, 500)}, {{"highway", "secondary"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_LT(lowestOf(made.road("upper")), 200.0 - 6.8); // a roof at 6.8 m
    EXPECT_LT(lowestOf(made.road("lower")), 200.0 - 13.4);
    EXPECT_TRUE(made.faults().empty());
    EXPECT_TRUE(made.streets.report.notes.empty());
}

TEST(Crossings, ATunnelBelowNothingIsDugInAndLayerAloneGoesBelow)
{
    MadeMap map;
    addStreet(map, -200, "nothing", {{"highway", "secondary"}, {"tunnel", "yes"}}, 40.0);
    addStreet(map, 0, "layer", {{"highway", "secondary"}, {"layer", "-1"}}, 40.0);
    map.way({map.node(0, -80), map.node(0, 80)}, {{"highway", "residential"}, {"name", "over"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_LT(lowestOf(made.road("nothing")), 193.2);
    EXPECT_LT(lowestOf(made.road("layer")), 194.5);
    EXPECT_NEAR(highestOf(made.road("over")), 200.0, 0.1);
    EXPECT_EQ(made.road("over").structures.size(), 1u); // the ground below it is gone
    EXPECT_TRUE(made.road("layer").structures.empty());
    EXPECT_TRUE(made.faults().empty());
}

namespace
{

/// A street with a tunnel in its middle, others joined so near to it that ramps have no room, and one over it
/// if asked for.
MadeMap passageMap(double tunnelM, const char* over = nullptr)
{
    const double halfM = 0.5 * tunnelM, joinM = halfM + 8.0;
    MadeMap map;
    const int a = map.node(-joinM, 0), b = map.node(-halfM, 0), c = map.node(halfM, 0),
              d = map.node(joinM, 0);
    map.way({map.node(-300, 0), a, b}, {{"highway", "residential"}});
    map.way({b, c}, {{"highway", "residential"}, {"tunnel", "yes"}, {"layer", "-1"}});
    map.way({c, d, map.node(300, 0)}, {{"highway", "residential"}});
    map.way({map.node(-joinM, -200), a, map.node(-joinM, 200)}, {{"highway", "residential"}});
    map.way({map.node(joinM, -200), d, map.node(joinM, 200)}, {{"highway", "residential"}});
    if (over) map.way({map.node(0, -200), map.node(0, 200)}, {{"highway", over}});
    return map;
}

std::size_t tunnelsOf(const MadeCrossing& made)
{
    std::size_t tunnels = 0;
    for (const Road& road : made.streets.network.roads)
        for (const auto& structure : road.structures)
            tunnels += structure.kind == StructureKind::tunnel ? 1 : 0;
    return tunnels;
}

} // namespace

TEST(Crossings, AShortTunnelWithoutAHillOrRoomForRampsIsOpen)
{
    for (const double tunnelM : {4.0, 9.0, 16.0, 30.0, 44.0, 58.0})
    {
        const MadeCrossing made = crossingOf(passageMap(tunnelM));
        EXPECT_EQ(tunnelsOf(made), 0u) << tunnelM;
        EXPECT_TRUE(made.faults().empty()) << tunnelM;
        EXPECT_EQ(made.streets.report.bareTunnels, 0u) << tunnelM;
        for (const Road& road : made.streets.network.roads)
            EXPECT_NEAR(lowestOf(road), 200.0, 0.1) << tunnelM;
        EXPECT_NE(made.streets.report.notes.back().find("1 short tunnels of streets"), std::string::npos);
    }
}

TEST(Crossings, ATunnelStaysWhereSomethingPassesOverItOrAHillCoversIt)
{
    EXPECT_EQ(tunnelsOf(crossingOf(passageMap(30.0, "secondary"))), 1u);
    EXPECT_EQ(tunnelsOf(crossingOf(passageMap(90.0))), 1u) << "too long to be a passage";
    const auto hill = [](double eastM, double) { return std::fabs(eastM) < 14.0 ? 215.0 : 200.0; };
    EXPECT_EQ(tunnelsOf(crossingOf(passageMap(30.0), hill)), 1u);
}

TEST(Crossings, ABridgeKeepsClearOfAStreetThatIsClosedToCars)
{
    const auto bridgeOver = [](const std::vector<std::pair<const char*, const char*>>& below)
    {
        MadeMap map;
        map.way({map.node(-300, 0), map.node(300, 0)}, below);
        const int b = map.node(0, -40), c = map.node(0, 40);
        map.way({map.node(0, -400), b}, {{"highway", "secondary"}, {"name", "over"}});
        map.way({b, c}, {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
        map.way({c, map.node(0, 400)}, {{"highway", "secondary"}});
        return highestOf(crossingOf(map).road("over"));
    };
    const double path = bridgeOver({{"highway", "footway"}});
    EXPECT_GT(path, 202.0);
    EXPECT_NEAR(bridgeOver({{"highway", "service"}, {"motor_vehicle", "no"}}), path, 0.1);
    EXPECT_LT(bridgeOver({{"barrier", "fence"}}), path - 1.0) << "the control: nothing to keep clear of";
}

TEST(Crossings, ARailwayBridgeRisesInItsGradeOverAStreetAndAPath)
{
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"highway", "secondary"}, {"name", "below"}});
    map.way({map.node(-300, 20), map.node(300, 20)}, {{"highway", "footway"}});
    const int b = map.node(0, -40), c = map.node(0, 40);
    map.way({map.node(0, -600), b}, {{"railway", "rail"}});
    map.way({b, c}, {{"railway", "rail"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({c, map.node(0, 600)}, {{"railway", "rail"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_NEAR(highestOf(made.road("below")), 200.0, 0.05);
    double mostM = 0.0, steepest = 0.0;
    for (const Track& track : made.streets.tracks)
        for (std::size_t i = 0; i < track.points.size(); ++i)
        {
            mostM = std::max(mostM, track.heightsM[i]);
            if (i > 0)
                steepest = std::max(steepest, std::fabs(track.heightsM[i] - track.heightsM[i - 1]) /
                                                  glm::distance(track.points[i], track.points[i - 1]));
        }
    EXPECT_GT(mostM, 205.4);
    EXPECT_LE(steepest, 0.0401);
    EXPECT_TRUE(made.faults().empty());
}

TEST(Crossings, ARiverUnderAStreetWithoutABridgeGetsOneAndAStreamACulvert)
{
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"highway", "secondary"}, {"name", "street"}});
    addAcross(map, -100, {{"waterway", "stream"}});
    addAcross(map, 100, {{"waterway", "river"}, {"width", "20"}});
    const MadeCrossing made = crossingOf(map);
    const Road& street = made.road("street");
    ASSERT_EQ(street.structures.size(), 1u);
    EXPECT_EQ(street.structures[0].kind, StructureKind::bridge);
    EXPECT_NEAR(street.structures[0].s + 0.5 * street.structures[0].length, 400.0, 3.0);
    EXPECT_GT(street.structures[0].length, 22.0);
    EXPECT_GT(highestOf(street), 202.0);
}

TEST(Crossings, ABridgeOverAPathHasItsHeadroomAndAStreetUnderARunwayATunnel)
{
    MadeMap map;
    addStreet(map, 0, "over", {{"highway", "residential"}, {"bridge", "yes"}}, 15.0);
    addAcross(map, 0, {{"highway", "cycleway"}});
    EXPECT_GT(highestOf(crossingOf(map).road("over")), 203.6); // 2.5 m, and a deck of 1.2 m
    MadeMap field;
    addStreet(field, 0, "under", {{"highway", "secondary"}, {"layer", "-1"}}, 60.0);
    addAcross(field, 0, {{"aeroway", "runway"}, {"width", "30"}});
    const MadeCrossing made = crossingOf(field);
    EXPECT_LT(lowestOf(made.road("under")), 193.3);
    ASSERT_EQ(made.road("under").structures.size(), 1u);
    EXPECT_EQ(made.road("under").structures[0].kind, StructureKind::tunnel);
}

TEST(Crossings, AMotorwayJunctionSeparatesWhatCrossesAndJoinsWhatMeets)
{
    MadeMap map;
    for (const double northM : {-8.0, 8.0})
        map.way(northM < 0.0 ? std::vector<int>{map.node(-600, northM), map.node(600, northM)}
                             : std::vector<int>{map.node(600, northM), map.node(-600, northM)},
                {{"highway", "motorway"}, {"oneway", "yes"}});
    const int a = map.node(0, -300), south = map.node(0, -140), b = map.node(0, -35), c = map.node(0, 35),
              north = map.node(0, 140), d = map.node(0, 300);
    map.way({a, south, b}, {{"highway", "secondary"}, {"name", "over"}});
    map.way({b, c}, {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({c, north, d}, {{"highway", "secondary"}});
    map.way({south, map.node(120, -100), map.node(260, -40), map.node(420, -20)},
            {{"highway", "motorway_link"}, {"oneway", "yes"}});
    map.way({north, map.node(-120, 100), map.node(-260, 40), map.node(-420, 20)},
            {{"highway", "motorway_link"}, {"oneway", "yes"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_EQ(made.streets.report.overpasses, 2u);
    EXPECT_EQ(made.streets.report.crossings, 2u);
    EXPECT_TRUE(made.faults().empty());
}

TEST(Crossings, ObliqueInACurveOnASlopeAndInShortPiecesAllHaveRoom)
{
    const Height slope = [](double eastM, double northM) { return 200.0 + 0.05 * eastM + 0.01 * northM; };
    for (const bool isSloping : {false, true})
        for (const int form : {0, 1, 2})
        {
            MadeMap map;
            if (form == 0) // oblique, by 27°
                map.way({map.node(-400, -200), map.node(400, 200)}, {{"railway", "rail"}});
            else
                addAcross(map, 0, {{"railway", "rail"}});
            if (form == 1) // a bend of the street on the bridge
            {
                const int b = map.node(-40, -15), c = map.node(40, -15);
                map.way({map.node(-400, -200), b}, {{"highway", "secondary"}, {"name", "over"}});
                map.way({b, map.node(-15, -3), map.node(0, 0), map.node(15, -3), c},
                        {{"highway", "secondary"}, {"bridge", "yes"}});
                map.way({c, map.node(400, -200)}, {{"highway", "secondary"}});
            }
            else if (form == 2) // a chain of short ways with layers of their own
            {
                std::vector<int> nodes;
                for (int i = 0; i <= 6; ++i)
                    nodes.push_back(map.node(-30.0 + 10.0 * i, 0));
                map.way({map.node(-400, 0), nodes.front()}, {{"highway", "secondary"}, {"name", "over"}});
                for (int i = 0; i < 6; ++i)
                    map.way({nodes[static_cast<std::size_t>(i)], nodes[static_cast<std::size_t>(i) + 1]},
                            {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", i % 2 ? "1" : "2"}});
                map.way({nodes.back(), map.node(400, 0)}, {{"highway", "secondary"}});
            }
            else
                addStreet(map, 0, "over", {{"highway", "secondary"}, {"bridge", "yes"}});
            const MadeCrossing made = crossingOf(map, isSloping ? slope : Height(level));
            EXPECT_TRUE(made.faults().empty()) << form << isSloping;
            EXPECT_EQ(made.road("over").structures.size(), 1u) << form << isSloping;
            EXPECT_LE(steepestOf(made.streets.network), 0.1201) << form << isSloping;
        }
}

TEST(Crossings, ABridgeWithoutRoomForRampsSaysSoAndTheOtherGivesWay)
{
    MadeMap map; // crossings of streets 25 m from the railway on both sides
    const int a = map.node(-25, 0), b = map.node(-15, 0), c = map.node(15, 0), d = map.node(25, 0);
    map.way({map.node(-200, 0), a, b}, {{"highway", "secondary"}, {"name", "short"}});
    map.way({b, c}, {{"highway", "secondary"}, {"bridge", "yes"}});
    map.way({c, d, map.node(200, 0)}, {{"highway", "secondary"}});
    map.way({map.node(-25, -200), a, map.node(-25, 200)}, {{"highway", "residential"}});
    map.way({map.node(25, -200), d, map.node(25, 200)}, {{"highway", "residential"}});
    addAcross(map, 0, {{"railway", "rail"}, {"usage", "main"}});
    const MadeCrossing made = crossingOf(map);
    double lowestTrackM = 1e9;
    for (const Track& track : made.streets.tracks)
        for (const double heightM : track.heightsM)
            lowestTrackM = std::min(lowestTrackM, heightM);
    EXPECT_LT(lowestTrackM, 199.0); // one up, the other down
    const bool isKept = made.faults().empty();
    EXPECT_TRUE(isKept || !made.streets.report.notes.empty());
    for (const std::string& note : made.streets.report.notes)
        EXPECT_NE(note.find("clear instead of 4.5 m"), std::string::npos) << note;
}

TEST(Crossings, AnOpenCrossingIsToldWithItsPlaceAndARemedy)
{
    MadeMap map;
    map.way({map.node(-200, 0), map.node(200, 0)}, {{"highway", "secondary"}, {"name", "one"}});
    map.way({map.node(0, -200), map.node(0, 200)}, {{"highway", "secondary"}, {"name", "two"}});
    const MadeCrossing made = crossingOf(map);
    ASSERT_EQ(made.streets.report.notes.size(), 1u);
    const std::string& note = made.streets.report.notes.front();
    EXPECT_NE(note.find("'one' (way 1) and street 'two' (way 2) cross at 42.50000, 1.50000"),
              std::string::npos)
        << note;
    EXPECT_NE(note.find("give them a common node"), std::string::npos) << note;
}

TEST(CrossingCheck, SeesABridgeThatIsLoweredAndRailsThatAreRaisedOrEndAtIt)
{
    MadeMap map;
    addStreet(map, 0, "over", {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    addAcross(map, 0, {{"railway", "rail"}});
    MadeCrossing made = crossingOf(map);
    ASSERT_TRUE(made.faults().empty());
    auto rails = made.rails();
    for (glm::dvec3& place : rails[0].points)
        place.z += 2.5;
    auto faults = made.faultsWith(rails);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].flaw, CrossingFlaw::rails);
    EXPECT_TRUE(faults[0].isRoadAbove);
    EXPECT_LT(faults[0].foundM, 4.0);
    rails = made.rails();
    std::erase_if(rails[0].points,
                  [&](const glm::dvec3& place) { return place.y > rails[0].points[0].y + 300.0; });
    faults = made.faultsWith(rails);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].flaw, CrossingFlaw::railEnd);
    rails = made.rails();
    const std::size_t half = rails[0].points.size() / 2;
    rails.push_back({{rails[0].points.begin() + static_cast<std::ptrdiff_t>(half), rails[0].points.end()}});
    rails[0].points.resize(half + 1);
    EXPECT_TRUE(made.faultsWith(rails).empty()); // two lines that go on in each other
    for (glm::dvec3& place : rails[1].points)
        place.z -= 0.8;
    EXPECT_EQ(made.faultsWith(rails).size(), 2u); // a step, seen from both
    for (Road& road : made.streets.network.roads)
        road.elevation = osgRoads::core::CubicProfile({osgRoads::core::Cubic{0.0, 203.0}});
    EXPECT_EQ(made.faults().front().flaw, CrossingFlaw::rails);
}

TEST(CrossingCheck, SeesATunnelOnLevelGroundAndAStreetTooCloseToAnother)
{
    MadeMap map;
    addStreet(map, 0, "under", {{"highway", "secondary"}, {"tunnel", "yes"}}, 40.0);
    map.way({map.node(0, -80), map.node(0, 80)}, {{"highway", "residential"}, {"name", "over"}});
    MadeCrossing made = crossingOf(map);
    ASSERT_TRUE(made.faults().empty());
    for (Road& road : made.streets.network.roads)
        if (road.name == "under")
            road.elevation = osgRoads::core::CubicProfile({osgRoads::core::Cubic{0.0, 197.0}});
    const auto faults = made.faults();
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_EQ(faults[0].flaw, CrossingFlaw::roads);
    EXPECT_EQ(faults[1].flaw, CrossingFlaw::tunnel);
    EXPECT_NEAR(faults[1].foundM, 3.8, 0.05);
}

TEST(Crossings, AreTheSameInEveryRun)
{
    MadeMap map;
    addStreet(map, 0, "over", {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}});
    addAcross(map, 0, {{"railway", "rail"}});
    const MadeCrossing a = crossingOf(map), b = crossingOf(map);
    ASSERT_EQ(a.streets.tracks.size(), b.streets.tracks.size());
    for (std::size_t i = 0; i < a.streets.tracks.size(); ++i)
        EXPECT_EQ(a.streets.tracks[i].heightsM, b.streets.tracks[i].heightsM);
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(a.road("over").elevation.value(10.0 * i), b.road("over").elevation.value(10.0 * i));
}

} // namespace
