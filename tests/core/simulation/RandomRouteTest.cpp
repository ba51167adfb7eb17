// SPDX-License-Identifier: Apache-2.0
// Which road is taken in a junction: by chance, or by the strategy of a route. Road 1 leads along x to a
// junction at x = 100, from there road 2 straight on (100 m), and road 3 to the left (an arc of 50 m). With a
// square of roads behind it, two ways lead to one goal.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "RoadPlay.h"
#include "simulation/road/RouteWay.h"

namespace simulation
{
namespace
{

/// The reference line of a road.
struct RoadCourse
{
    std::string start;
    double length;
    std::string shape;
};

std::string linked(const std::string& id, const RoadCourse& course, const std::string& link,
                   const std::string& junction = "-1", const std::string& kind = "")
{
    return "<road id=\"" + id + "\" length=\"" + std::to_string(course.length) + "\" junction=\"" + junction +
           "\"><link>" + link + "</link>" + kind + "<planView>" +
           roadtexts::geometry("s=\"0\" " + course.start, course.length, course.shape) + "</planView>" +
           roadtexts::twoLanes() + "</road>\n";
}

std::string connection(const std::string& id, const std::string& road)
{
    return "<connection id=\"" + id + "\" incomingRoad=\"1\" connectingRoad=\"" + road +
           R"(" contactPoint="start"><laneLink from="-1" to="-1"/></connection>)";
}

roadplay::Roads fork()
{
    const std::string back = R"(<predecessor elementType="road" elementId="1" contactPoint="end"/>)";
    return std::make_shared<const RoadScene>(roadtexts::sound(roadtexts::network(
        linked("1", {R"(x="0" y="0" hdg="0")", 100.0, "<line/>"},
               R"(<successor elementType="junction" elementId="9"/>)") +
        linked("2", {R"(x="100" y="0" hdg="0")", 100.0, "<line/>"}, back, "9") +
        linked("3", {R"(x="100" y="0" hdg="0")", 50.0, R"(<arc curvature="0.02"/>)"}, back, "9") +
        "<junction id=\"9\" name=\"j\">" + connection("0", "2") + connection("1", "3") + "</junction>\n")));
}

ScenarioText towardsTheFork(const std::string& more)
{
    ScenarioText text;
    text.privates = roadplay::onLane(50.0) + speedAction(10.0) + more;
    return text;
}

const std::string kRandomRoute =
    "<PrivateAction><RoutingAction><RandomRouteAction/></RoutingAction></PrivateAction>";

/// Whether Ego has turned to the left after 8 s, 30 m behind the junction's begin.
bool turnsLeft(const std::string& more, std::uint64_t seed)
{
    return roadplay::played(towardsTheFork(more), 8.0, fork(), seed)->entities()[0].position.y > 2.0;
}

TEST(RandomRoute, TakesEachRoadAboutAsOften)
{
    int left = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed)
        left += turnsLeft(kRandomRoute, seed) ? 1 : 0;
    EXPECT_GT(left, 18); // 30 are expected; three standard deviations are 11.6
    EXPECT_LT(left, 42);
    for (std::uint64_t seed = 0; seed < 5; ++seed)
    {
        EXPECT_EQ(turnsLeft(kRandomRoute, seed), turnsLeft(kRandomRoute, seed)) << "by the seed alone";
        EXPECT_FALSE(turnsLeft("", seed)) << "without it straight on";
    }
}

/// From the fork two ways lead to road 6: over 2 (100 m, 30 km/h) or over 3 and 4 and 5 (40 m each, 100 km/h,
/// without a junction road).
roadplay::Roads twoWays()
{
    const auto between = [](const std::string& before, const std::string& after)
    {
        return "<predecessor elementType=\"road\" elementId=\"" + before +
               "\" contactPoint=\"end\"/><successor elementType=\"road\" elementId=\"" + after +
               "\" contactPoint=\"start\"/>";
    };
    const auto limit = [](const char* kmh)
    { return std::string("<type s=\"0\" type=\"rural\"><speed max=\"") + kmh + "\" unit=\"km/h\"/></type>"; };
    // The pieces need not touch: links alone are followed here.
    return std::make_shared<const RoadScene>(
        osgRoads::core::parseNetwork(
            roadtexts::network(
                linked("1", {R"(x="0" y="0" hdg="0")", 100.0, "<line/>"},
                       R"(<successor elementType="junction" elementId="9"/>)") +
                linked("2", {R"(x="100" y="0" hdg="0")", 100.0, "<line/>"}, between("1", "6"), "9",
                       limit("30")) +
                linked("3", {R"(x="100" y="0" hdg="0")", 40.0, "<line/>"}, between("1", "4"), "9",
                       limit("100")) +
                linked("4", {R"(x="140" y="0" hdg="0")", 40.0, "<line/>"}, between("3", "5"), "7",
                       limit("100")) +
                linked("5", {R"(x="180" y="0" hdg="0")", 40.0, "<line/>"}, between("4", "6"), "-1",
                       limit("100")) +
                linked("6", {R"(x="220" y="0" hdg="0")", 50.0, "<line/>"},
                       R"(<predecessor elementType="road" elementId="5" contactPoint="end"/>)") +
                "<junction id=\"9\" name=\"j\">" + connection("0", "2") + connection("1", "3") +
                "</junction>\n"),
            "test.xodr")
            ->network);
}

std::vector<std::string> roadsOf(RouteStrategy strategy, std::uint64_t seed = 0)
{
    const auto roads = twoWays();
    Route route;
    route.waypoints = {LanePosition{{}, "1", -1, 10.0, 0.0, {}}, LanePosition{{}, "6", -1, 10.0, 0.0, {}}};
    route.strategies = {RouteStrategy::shortest, strategy};
    RandomDraw draw(seed, "route", 0);
    const auto way = wayOfRoute(*roads, route, &draw);
    std::vector<std::string> ids;
    for (const int road : way.value_or(RoadWay{}))
        ids.push_back(roads->network().roads[static_cast<std::size_t>(road)].id);
    return ids;
}

TEST(RouteStrategies, ChooseByLengthTimeJunctionsOrChance)
{
    const std::vector<std::string> over2{"1", "2", "6"}, over3{"1", "3", "4", "5", "6"};
    EXPECT_EQ(roadsOf(RouteStrategy::shortest), over2) << "100 m against 120 m";
    EXPECT_EQ(roadsOf(RouteStrategy::fastest), over3) << "12 s against 4.3 s";
    EXPECT_EQ(roadsOf(RouteStrategy::leastIntersections), over2) << "one road in a junction against two";
    std::set<std::vector<std::string>> drawn;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
        drawn.insert(roadsOf(RouteStrategy::random, seed));
        EXPECT_EQ(roadsOf(RouteStrategy::random, seed), roadsOf(RouteStrategy::random, seed));
    }
    EXPECT_EQ(drawn, (std::set<std::vector<std::string>>{over2, over3}));
}

TEST(RouteStrategies, AreReadWithTheirWaypoints)
{
    const auto route = [](const std::string& strategy)
    {
        const auto waypoint = [](const std::string& road, const std::string& how)
        {
            return "<Waypoint routeStrategy=\"" + how + "\"><Position><LanePosition roadId=\"" + road +
                   "\" laneId=\"-1\" s=\"10\"/></Position></Waypoint>";
        };
        return "<PrivateAction><RoutingAction><AssignRouteAction><Route name=\"r\" closed=\"false\">" +
               waypoint("1", "shortest") + waypoint("3", strategy) +
               "</Route></AssignRouteAction></RoutingAction></PrivateAction>";
    };
    for (const char* const strategy : {"shortest", "fastest", "leastIntersections", "random"})
        EXPECT_TRUE(turnsLeft(route(strategy), 0)) << strategy;
    EXPECT_FALSE(turnsLeft("", 0));
    EXPECT_FALSE(parseScenario(towardsTheFork(route("quickest")).text(), "test.xosc"));
}

} // namespace
} // namespace simulation
