// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <osgRoads/core/query/ChooseDrive.h>
#include <osgRoads/core/query/LaneRoute.h>
#include <osgRoads/core/query/LaneSpan.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

std::string lane(int id, const std::string& links, const std::string& type = "driving")
{
    return "<lane id=\"" + std::to_string(id) + "\" type=\"" + type + "\" level=\"false\"><link>" + links +
           "</link>" + kWidth + "</lane>";
}

std::string section(const std::string& left, const std::string& right, double s = 0.0)
{
    return "<laneSection s=\"" + std::to_string(s) + "\">" +
           (left.empty() ? "" : "<left>" + left + "</left>") +
           "<center><lane id=\"0\" type=\"none\" level=\"false\"/></center>" +
           (right.empty() ? "" : "<right>" + right + "</right>") + "</laneSection>";
}

std::string lanes(const std::string& sections)
{
    return "<lanes>" + sections + "</lanes>\n";
}

std::string planAt(double x, double length)
{
    return "<planView>" +
           geometry("s=\"0\" x=\"" + std::to_string(x) + "\" y=\"0\" hdg=\"0\"", length, "<line/>") +
           "</planView>\n";
}

/// Road 1 (100 m) – junction 5 with connecting road 2 (20 m) – road 3 (80 m), all along x; one lane each way.
std::string junctionText()
{
    const std::string toJunction = "<link><successor elementType=\"junction\" elementId=\"5\"/></link>";
    const std::string fromJunction = "<link><predecessor elementType=\"junction\" elementId=\"5\"/></link>";
    const std::string between =
        "<link><predecessor elementType=\"road\" elementId=\"1\" contactPoint=\"end\"/>"
        "<successor elementType=\"road\" elementId=\"3\" contactPoint=\"start\"/></link>";
    const std::string both = "<predecessor id=\"-1\"/><successor id=\"-1\"/>";
    return network(
        road("1", 100.0, toJunction + planAt(0.0, 100.0) + lanes(section(lane(1, ""), lane(-1, "")))) +
        road("2", 20.0, between + planAt(100.0, 20.0) + lanes(section("", lane(-1, both))),
             "junction=\"5\"") +
        road("3", 80.0, fromJunction + planAt(120.0, 80.0) + lanes(section(lane(1, ""), lane(-1, "")))) +
        "<junction id=\"5\" name=\"x\"><connection id=\"0\" incomingRoad=\"1\" connectingRoad=\"2\" "
        "contactPoint=\"start\"><laneLink from=\"-1\" to=\"-1\"/></connection></junction>\n");
}

TEST(LaneRoute, LeadsOverAJunction)
{
    const RoadNetwork read = sound(junctionText());
    const LaneGraph graph(read);
    const auto route = findRoute(read, graph, {0, 30.0, -1.0, 0.0}, {2, 50.0, -1.0, 0.0});
    ASSERT_TRUE(route) << route.error().message();
    ASSERT_EQ(route->legs.size(), 3u);
    EXPECT_EQ(route->legs[1].lane.road, 1);
    EXPECT_DOUBLE_EQ(route->lengthM, 70.0 + 20.0 + 50.0);
    const RoadPosition middle = route->at(read, 80.0);
    EXPECT_EQ(middle.road, 1);
    EXPECT_DOUBLE_EQ(middle.s, 10.0);
    EXPECT_DOUBLE_EQ(middle.t, -1.75);
    EXPECT_DOUBLE_EQ(route->at(read, 1000.0).s, 50.0);
}

TEST(LaneRoute, TellsWhyThereIsNone)
{
    const RoadNetwork read = sound(junctionText());
    const LaneGraph graph(read);
    EXPECT_EQ(findRoute(read, graph, {2, 50.0, 1.0, 0.0}, {0, 30.0, 1.0, 0.0}).error().message(),
              "route: no route leads to the goal; check the links of roads, lanes and junctions");
    EXPECT_EQ(findRoute(read, graph, {0, 30.0, -9.0, 0.0}, {2, 50.0, -1.0, 0.0}).error().what,
              "the start is on no lane that cars use");
    EXPECT_EQ(findRoute(read, graph, {0, 30.0, -1.0, 0.0}, {0, 20.0, -1.0, 0.0}).error().what,
              "the goal is behind the start on the same road");
}

/// Left lanes run against the road; in left-hand traffic right ones do.
TEST(LaneGraph, DirectionsFollowTheTrafficSide)
{
    for (const bool isLeftHand : {false, true})
    {
        const RoadNetwork read = sound(
            network(road("1", 100.0, straightPlan(100.0) + lanes(section(lane(1, ""), lane(-1, ""))),
                         isLeftHand ? "rule=\"LHT\" junction=\"-1\"" : "rule=\"RHT\" junction=\"-1\"")));
        const LaneGraph graph(read);
        ASSERT_EQ(graph.lanes().size(), 2u);
        EXPECT_TRUE(graph.find({0, 0, 1, isLeftHand}));
        EXPECT_TRUE(graph.find({0, 0, -1, !isLeftHand}));
        EXPECT_TRUE(graph.edges(0).empty()); // no change into oncoming traffic
    }
}

/// Lane -2 begins in the second section: from lane -1 one goes straight on, or changes.
TEST(LaneRoute, ChangesLanesAndFollowsSections)
{
    const RoadNetwork read = sound(
        network(road("1", 100.0,
                     straightPlan(100.0) +
                         lanes(section("", lane(-1, "<successor id=\"-1\"/>")) +
                               section("", lane(-1, "<predecessor id=\"-1\"/>") + lane(-2, ""), 40.0)))));
    const LaneGraph graph(read);
    const auto route = findRoute(read, graph, {0, 10.0, -1.0, 0.0}, {0, 90.0, -5.0, 0.0});
    ASSERT_TRUE(route) << route.error().message();
    ASSERT_EQ(route->legs.size(), 3u);
    EXPECT_TRUE(route->legs[2].isLaneChange);
    EXPECT_EQ(route->legs[2].lane.lane, -2);
    EXPECT_DOUBLE_EQ(route->lengthM, 80.0);
}

/// Two roads that meet end to end: one drives out of the first and against s on the second.
TEST(LaneRoute, GoesAgainstRoadsThatRunTheOtherWay)
{
    const std::string first =
        "<link><successor elementType=\"road\" elementId=\"2\" contactPoint=\"end\"/></link>";
    const std::string second =
        "<link><successor elementType=\"road\" elementId=\"1\" contactPoint=\"end\"/></link>";
    const std::string back = "<planView>" +
                             geometry(R"(s="0" x="200" y="0" hdg="3.141592653589793")", 100.0, "<line/>") +
                             "</planView>";
    const RoadNetwork read = sound(
        network(road("1", 100.0,
                     first + straightPlan(100.0) + lanes(section("", lane(-1, "<successor id=\"1\"/>")))) +
                road("2", 100.0, second + back + lanes(section(lane(1, "<successor id=\"-1\"/>"), "")))));
    const LaneGraph graph(read);
    const auto route = findRoute(read, graph, {0, 10.0, -1.0, 0.0}, {1, 30.0, 1.0, 0.0});
    ASSERT_TRUE(route) << route.error().message();
    EXPECT_NEAR(route->lengthM, 90.0 + 70.0, 1e-12);
    EXPECT_NEAR(worldPosition(read, route->at(read, 100.0)).x, 110.0, 1e-9);
}

TEST(ChooseDrive, LeadsThroughTheJunctionWithTheSurplusLeftOutBefore)
{
    const RoadNetwork read = sound(junctionText());
    const LaneRoute drive = chooseDrive(read, LaneGraph(read), 150.0);
    ASSERT_EQ(drive.legs.size(), 3u);
    EXPECT_EQ(drive.legs[0].lane, (LaneKey{0, 0, -1, true}));
    EXPECT_EQ(drive.legs[1].lane.road, 1);
    EXPECT_EQ(drive.legs[2].lane.road, 2);
    // 100 + 20 + 80 m are 50 m too many, but half of the drive may lie before the junction.
    EXPECT_DOUBLE_EQ(drive.legs[0].sFrom, 25.0);
    EXPECT_DOUBLE_EQ(drive.lengthM, 175.0);
}

TEST(ChooseDrive, DrivesAShortRoadToItsEndInTheOutermostLane)
{
    const RoadNetwork read = sound(network(road(
        "1", 60.0,
        planAt(0.0, 60.0) + lanes(section("", lane(-1, "") + lane(-2, "") + lane(-3, "", "sidewalk"))))));
    const LaneRoute drive = chooseDrive(read, LaneGraph(read), 500.0);
    ASSERT_EQ(drive.legs.size(), 1u);
    EXPECT_EQ(drive.legs[0].lane.lane, -2);
    EXPECT_DOUBLE_EQ(drive.legs[0].sTo, 60.0);
    EXPECT_DOUBLE_EQ(drive.lengthM, 60.0);
    EXPECT_TRUE(chooseDrive(RoadNetwork(), LaneGraph(RoadNetwork()), 500.0).legs.empty());
}

/// The outer lane ends with the first section: the drive goes on in the inner one.
TEST(ChooseDrive, ChangesToTheLaneThatGoesOn)
{
    const RoadNetwork read = sound(network(
        road("1", 300.0,
             planAt(0.0, 300.0) + lanes(section("", lane(-1, "<successor id=\"-1\"/>") + lane(-2, "")) +
                                        section("", lane(-1, "<predecessor id=\"-1\"/>"), 100.0)))));
    const LaneRoute drive = chooseDrive(read, LaneGraph(read), 280.0);
    ASSERT_EQ(drive.legs.size(), 3u);
    EXPECT_EQ(drive.legs[0].lane.lane, -2);
    EXPECT_TRUE(drive.legs[1].isLaneChange);
    EXPECT_EQ(drive.legs[2].lane, (LaneKey{0, 1, -1, true}));
}

} // namespace
