// SPDX-License-Identifier: Apache-2.0
// Lanes of tags in a network: single tracks, lanes for turns in the middle, buses against a one-way street.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/LaneGraph.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/write/WriteNetwork.h>

#include "MadeStreets.h"
#include "TestFolder.h"

namespace
{

using namespace osgRoads::core;

double evenGround(double, double)
{
    return 500.0;
}

/// The network of a map as a file has it.
RoadNetwork networkOf(const MadeMap& map)
{
    const testsupport::TestFolder folder("lanes");
    const auto file = folder / "roads.xodr";
    const auto written = writeNetwork(streetsOf(map, evenGround).network, file);
    EXPECT_TRUE(written) << (written ? "" : written.error().message());
    auto read = readNetwork(file);
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    EXPECT_TRUE(read->problems.empty()) << read->problems.front().message("roads.xodr");
    return std::move(read->network);
}

/// Driving lanes of a road in its middle, and how wide they are together.
struct Paving
{
    int left = 0, right = 0, shared = 0, forBuses = 0;
    double widthM = 0.0;
};

Paving pavingOf(const Road& road)
{
    Paving paving;
    const LaneSection& section = road.sections.front();
    for (const auto* side : {&section.left, &section.right})
        for (const Lane& lane : *side)
        {
            if (lane.type != LaneType::driving) continue;
            ++(side == &section.left ? paving.left : paving.right);
            paving.shared += lane.direction == LaneDirection::both;
            paving.forBuses += !lane.access.empty() && lane.access.front().restriction == "bus";
            paving.widthM += lane.width.value(0.0);
        }
    return paving;
}

Paving pavingOf(std::initializer_list<std::pair<const char*, const char*>> tags)
{
    MadeMap map;
    map.way({map.node(-100, 0), map.node(100, 0)}, tags);
    return pavingOf(networkOf(map).roads.front());
}

void expectSound(const RoadNetwork& network)
{
    JointLimits limits;
    limits.laneStepM = 0.01;
    for (const Flaw& flaw : checkNetwork(network, limits).flaws)
        ADD_FAILURE() << flaw.message("lanes");
}

/// The ids of roads without junction that traffic on one lane of `road` gets to.
std::set<int> reachedFrom(const RoadNetwork& network, int road, bool isForward)
{
    const LaneGraph graph(network);
    std::vector<std::uint32_t> open;
    std::set<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < graph.lanes().size(); ++i)
        if (graph.lanes()[i].road == road && graph.lanes()[i].isForward == isForward) open.push_back(i);
    std::set<int> roads;
    while (!open.empty())
    {
        const std::uint32_t lane = open.back();
        open.pop_back();
        if (!seen.insert(lane).second) continue;
        const int on = graph.lanes()[lane].road;
        if (network.roads[static_cast<std::size_t>(on)].junction < 0) roads.insert(on);
        for (const auto& edge : graph.edges(lane))
            open.push_back(edge.to);
    }
    return roads;
}

} // namespace

TEST(StreetLanes, ASingleTrackIsOneLaneThatBothDirectionsUse)
{
    const Paving single = pavingOf({{"highway", "residential"}, {"lanes", "1"}});
    EXPECT_EQ(single.left + single.right, 1);
    EXPECT_EQ(single.shared, 1);
    EXPECT_GE(single.widthM, 3.0);
    EXPECT_LE(single.widthM, 4.0);
    const Paving two = pavingOf({{"highway", "residential"}});
    EXPECT_EQ(two.left + two.right, 2);
    EXPECT_EQ(two.shared, 0);
}

TEST(StreetLanes, ALaneInTheMiddleAndOneForBusesAreLanesOfTheNetwork)
{
    const Paving turn = pavingOf({{"highway", "secondary"},
                                  {"lanes", "3"},
                                  {"lanes:both_ways", "1"},
                                  {"lanes:forward", "1"},
                                  {"lanes:backward", "1"}});
    EXPECT_EQ(turn.left + turn.right, 3);
    EXPECT_EQ(turn.shared, 1);
    const Paving bus =
        pavingOf({{"highway", "secondary"}, {"oneway", "yes"}, {"oneway:bus", "no"}, {"lanes", "3"}});
    EXPECT_EQ(bus.right, 2);
    EXPECT_EQ(bus.left, 1);
    EXPECT_EQ(bus.forBuses, 1);
}

TEST(StreetLanes, BothDirectionsOfASingleTrackGoThroughItsCrossings)
{
    MadeMap map;
    const int middle = map.node(0, 0);
    for (const auto& [east, north] : {std::pair(150, 0), {-150, 20}, {10, 140}})
        map.way({middle, map.node(east, north)}, {{"highway", "residential"}, {"lanes", "1"}});
    map.way({middle, map.node(-20, -150)}, {{"highway", "residential"}});
    const RoadNetwork network = networkOf(map);
    expectSound(network);
    EXPECT_EQ(network.junctions.front().connections.size(), 12u);
    for (int road = 0; road < 4; ++road) // ways lead away from the crossing: backward goes into it
        EXPECT_EQ(reachedFrom(network, road, false).size(), 4u) << road;
}

TEST(StreetLanes, AStreetThatNarrowsToASingleTrackStaysOneInBothDirections)
{
    MadeMap map;
    const int a = map.node(-300, 0), b = map.node(-100, 0), c = map.node(100, 0), d = map.node(300, 0);
    map.way({a, b}, {{"highway", "tertiary"}});
    map.way({b, c}, {{"highway", "tertiary"}, {"lanes", "1"}});
    map.way({c, d}, {{"highway", "tertiary"}, {"oneway", "yes"}});
    const RoadNetwork network = networkOf(map);
    expectSound(network);
    const LaneGraph graph(network);
    const auto& sections = network.roads.front().sections;
    ASSERT_EQ(sections.size(), 5u); // with two tapers
    // Forward: from the first lane on the right to the last section. Backward: from the single track to the
    // first.
    const auto ends = [&](LaneKey from)
    {
        std::set<std::uint32_t> seen;
        std::set<int> reached;
        std::vector<std::uint32_t> open = {*graph.find(from)};
        while (!open.empty())
        {
            const std::uint32_t lane = open.back();
            open.pop_back();
            if (!seen.insert(lane).second) continue;
            reached.insert(graph.lanes()[lane].section);
            for (const auto& edge : graph.edges(lane))
                open.push_back(edge.to);
        }
        return reached;
    };
    EXPECT_TRUE(ends({0, 0, -1, true}).contains(4));
    EXPECT_TRUE(ends({0, 2, -1, false}).contains(0));
}

TEST(StreetLanes, CarsDoNotTurnIntoALaneForBusesAgainstAOneWayStreet)
{
    MadeMap map;
    const int middle = map.node(0, 0);
    map.way({map.node(-150, 0), middle},
            {{"highway", "secondary"}, {"oneway", "yes"}, {"busway", "opposite_lane"}});
    map.way({middle, map.node(150, 0)}, {{"highway", "secondary"}});
    map.way({middle, map.node(0, 150)}, {{"highway", "secondary"}});
    const RoadNetwork network = networkOf(map);
    expectSound(network);
    EXPECT_FALSE(reachedFrom(network, 1, false).contains(0));
    EXPECT_TRUE(reachedFrom(network, 0, false).contains(1)); // its road leads away from the crossing
}

TEST(StreetLanes, SpeedsOfBothDirectionsStandWithTheirLanes)
{
    MadeMap map;
    map.way({map.node(-100, 0), map.node(100, 0)},
            {{"highway", "primary"}, {"maxspeed:forward", "70"}, {"maxspeed:backward", "30 mph"}});
    const RoadNetwork network = networkOf(map);
    const LaneSection& section = network.roads.front().sections.front();
    ASSERT_FALSE(section.left.front().speeds.empty());
    ASSERT_FALSE(section.right.front().speeds.empty());
    EXPECT_NEAR(*section.right.front().speeds.front().metresPerSecond, 70.0 / 3.6, 1e-6);
    EXPECT_NEAR(*section.left.front().speeds.front().metresPerSecond, 13.4112, 1e-6);
}

TEST(StreetLanes, LanesForBusesFollowEachWayOfTellingThem)
{
    using TagList = std::initializer_list<std::pair<const char*, const char*>>;
    const auto expect = [](const TagList& tags, int left, int right, int forBuses)
    {
        const Paving paving = pavingOf(tags);
        EXPECT_EQ((std::array{paving.left, paving.right, paving.forBuses}),
                  (std::array{left, right, forBuses}))
            << (tags.end() - 1)->first;
    };
    expect({{"highway", "primary"}, {"lanes", "4"}, {"busway", "lane"}}, 2, 2, 2);
    expect({{"highway", "primary"}, {"lanes", "2"}, {"busway:right", "lane"}}, 1, 2, 1);
    expect({{"highway", "primary"}, {"lanes", "1"}, {"oneway", "yes"}, {"busway:right", "lane"}}, 0, 2, 1);
    expect({{"highway", "primary"}, {"lanes", "4"}, {"lanes:psv", "2"}}, 2, 2, 2);
    expect({{"highway", "primary"}, {"lanes", "3"}, {"oneway", "yes"}, {"bus:lanes", "yes|yes|designated"}},
           0, 3, 1);
    expect({{"highway", "primary"},
            {"lanes", "5"},
            {"oneway", "yes"},
            {"psv:lanes", "yes|yes|yes|designated|no"},
            {"bus:lanes", "yes|yes|yes|designated|designated"}},
           0, 5, 2);
    expect({{"highway", "primary"},
            {"lanes", "4"},
            {"lanes:forward", "3"},
            {"lanes:backward", "1"},
            {"bicycle:lanes:forward", "yes|yes|yes|designated"},
            {"bus:lanes:forward", "yes|yes|designated|designated"}},
           1, 3, 1);
    expect({{"highway", "primary"}, {"lanes", "2"}, {"oneway", "yes"}, {"oneway:psv", "no"}}, 1, 1, 1);
    expect({{"highway", "primary"}, {"lanes", "4"}, {"bus:lanes:backward", "|designated"}}, 2, 2, 1);
}

/// The strips for bicycles of a road: left and right, raised ones by -1.
std::pair<int, int> cyclesOf(const Road& road)
{
    std::pair<int, int> strips;
    for (const auto& [side, count] : {std::pair(&road.sections.front().left, &strips.first),
                                      {&road.sections.front().right, &strips.second}})
        for (const Lane& lane : *side)
            if (lane.type == LaneType::biking) *count = lane.heights.empty() ? 1 : -1;
    return strips;
}

TEST(StreetLanes, CycleLanesAreStripsOfThePavingAndTracksLieBehindTheKerb)
{
    using TagList = std::initializer_list<std::pair<const char*, const char*>>;
    const auto expect = [](const TagList& tags, int left, int right)
    {
        MadeMap map;
        const int a = map.node(-100, 0), b = map.node(0, 0), c = map.node(100, 0);
        map.way({a, b}, tags);
        map.way({b, c}, {{"highway", "secondary"}});
        map.way({b, map.node(0, 100)});
        const RoadNetwork network = networkOf(map);
        EXPECT_EQ(cyclesOf(network.roads.front()), std::pair(left, right)) << (tags.end() - 1)->first;
        expectSound(network);
    };
    expect({{"highway", "secondary"}, {"width", "10"}, {"cycleway", "lane"}}, 1, 1);
    expect({{"highway", "secondary"}, {"cycleway:right", "lane"}}, 0, 1);
    expect({{"highway", "secondary"}, {"cycleway:right", "no"}, {"cycleway:left", "track"}}, -1, 0);
    expect({{"highway", "residential"}, {"cycleway:both", "track"}}, -1, -1);
    expect({{"highway", "residential"}, {"oneway", "yes"}, {"cycleway", "lane"}}, 0, 1);
    expect({{"highway", "residential"}, {"oneway", "yes"}, {"cycleway", "opposite_lane"}}, 1, 0);
    expect({{"highway", "residential"}, {"cycleway", "shared_lane"}}, 0, 0);
    MadeMap wide;
    wide.way({wide.node(-100, 0), wide.node(100, 0)},
             {{"highway", "secondary"}, {"cycleway", "lane"}, {"width", "10"}});
    EXPECT_NEAR(pavingOf(networkOf(wide).roads.front()).widthM, 7.0, 1e-6) << "10 m less two strips";
}

/// The arrows of a road, by their distance from its end and their place across.
std::vector<std::string> arrowsOf(const Road& road)
{
    std::vector<std::pair<std::pair<double, double>, std::string>> found;
    for (const RoadObject& object : road.objects)
        if (object.type == "roadMark")
            found.push_back({{road.length - object.s, -object.t}, object.subtype + object.orientation});
    std::sort(found.begin(), found.end());
    std::vector<std::string> names;
    for (const auto& [at, name] : found)
        names.push_back(name);
    return names;
}

TEST(StreetLanes, ArrowsStandOnLanesBeforeCrossingsAndNowhereElse)
{
    using TagList = std::initializer_list<std::pair<const char*, const char*>>;
    const auto crossing = [](const TagList& tags, bool isToEast = true)
    {
        MadeMap map;
        const int a = map.node(-100, 0), b = map.node(0, 0), c = map.node(100, 0);
        map.way(isToEast ? std::vector{a, b} : std::vector{b, a}, tags);
        map.way({b, c}, {{"highway", "secondary"}});
        map.way({b, map.node(0, 100)});
        const RoadNetwork network = networkOf(map);
        expectSound(network);
        return arrowsOf(network.roads.front());
    };
    const auto oneway = crossing({{"highway", "primary"},
                                  {"oneway", "yes"},
                                  {"lanes", "3"},
                                  {"turn:lanes", "left|through|through;right"}});
    EXPECT_EQ(oneway, (std::vector<std::string>{"arrowLeft+", "arrowStraight+", "arrowStraightRight+",
                                                "arrowLeft+", "arrowStraight+", "arrowStraightRight+"}));
    const auto ofBuses = crossing({{"highway", "primary"},
                                   {"oneway", "yes"},
                                   {"lanes", "2"},
                                   {"bus:lanes", "yes|designated"},
                                   {"turn:lanes", "left;through|right"},
                                   {"turn:bus:lanes", "left|through;right"}});
    EXPECT_EQ(ofBuses, (std::vector<std::string>{"arrowStraightLeft+", "arrowStraightRight+",
                                                 "arrowStraightLeft+", "arrowStraightRight+"}))
        << "that of buses on their lane alone";
    const auto besideBicycles = crossing({{"highway", "primary"},
                                          {"oneway", "yes"},
                                          {"lanes", "2"},
                                          {"vehicle:lanes", "yes|no|yes"},
                                          {"bicycle:lanes", "yes|designated|yes"},
                                          {"turn:lanes", "left|through|right"}});
    EXPECT_EQ(besideBicycles,
              (std::vector<std::string>{"arrowLeft+", "arrowRight+", "arrowLeft+", "arrowRight+"}))
        << "without that of bicycles in the middle";
    EXPECT_EQ(
        crossing(
            {{"highway", "primary"}, {"lanes", "3"}, {"lanes:forward", "2"}, {"turn:lanes:forward", "left|"}})
            .size(),
        2u);
    EXPECT_EQ(crossing({{"highway", "primary"},
                        {"lanes", "3"},
                        {"lanes:backward", "2"},
                        {"turn:lanes:backward", "left|through"}},
                       false)
                  .size(),
              4u)
        << "drawn away from the crossing";
    EXPECT_EQ(crossing({{"highway", "primary"},
                        {"lanes", "3"},
                        {"lanes:backward", "2"},
                        {"turn:lanes:backward", "left|through"}})
                  .size(),
              0u)
        << "at a dead end";
    EXPECT_EQ(
        crossing(
            {{"highway", "primary"}, {"oneway", "yes"}, {"lanes", "2"}, {"turn:lanes", "left|through|right"}})
            .size(),
        0u)
        << "one too many";
    EXPECT_EQ(crossing({{"highway", "primary"},
                        {"oneway", "yes"},
                        {"lanes", "2"},
                        {"turn:lanes", "slight_left|merge_to_left|"}}),
              (std::vector<std::string>{"arrowLeft+", "arrowMergeLeft+", "arrowLeft+", "arrowMergeLeft+"}))
        << "the last entry is a lane for bicycles";
    EXPECT_EQ(
        crossing({{"highway", "primary"}, {"oneway", "yes"}, {"lanes", "2"}, {"turn:lanes", "none|none"}})
            .size(),
        0u);
}
