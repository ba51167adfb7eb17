// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

/// A spiral, an arc and a line one behind the other, banked and climbing, `away` metres east of the origin.
std::string windingRoad(double away)
{
    const double heading = 0.5 * 0.02 * 50.0; // after the spiral
    const Clothoid spiral(0.0, 0.02, 50.0);
    const PlanElement arc(50.0, 60.0, glm::dvec2(away, 0.0) + spiral.at(50.0).position, heading,
                          ArcShape{0.02});
    const PlanPoint end = arc.at(60.0);
    const auto start = [](double s, glm::dvec2 at, double headingRad)
    {
        char text[160];
        std::snprintf(text, sizeof text, R"(s="%.17g" x="%.17g" y="%.17g" hdg="%.17g")", s, at.x, at.y,
                      headingRad);
        return std::string(text);
    };
    const std::string plan =
        "<planView>" +
        geometry(start(0.0, {away, 0.0}, 0.0), 50.0, R"(<spiral curvStart="0" curvEnd="0.02"/>)") +
        geometry(start(50.0, arc.at(0.0).position, heading), 60.0, R"(<arc curvature="0.02"/>)") +
        geometry(start(110.0, end.position, end.headingRad), 40.0, "<line/>") + "</planView>";
    return network(
        road("7", 150.0,
             plan + R"(<elevationProfile><elevation s="0" a="3" b="0.04" c="0" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a="0.02" b="0.0005" c="0" d="0"/></lateralProfile>)" +
                 twoLanes()));
}

/// World → road undoes road → world, also far from the origin.
TEST(RoadLocator, InvertsPositionsFarFromTheOrigin)
{
    for (const double away : {0.0, 1e7})
    {
        const RoadNetwork read = sound(windingRoad(away));
        const RoadLocator locator(read);
        for (double s = 0.5; s < 150.0; s += 7.3)
            for (const double t : {-3.4, -1.0, 0.0, 2.5, 3.5})
            {
                const auto onSurface = locator.nearest(glm::dvec2(surfacePoint(read.roads[0], s, t)));
                ASSERT_TRUE(onSurface);
                EXPECT_NEAR(onSurface->position.s, s, 3e-8) << away;
                EXPECT_NEAR(onSurface->position.t, t, 3e-8) << away;
                EXPECT_LT(onSurface->distance, 1e-7);
                const auto above = locator.nearest(worldPosition(read, {0, s, t, 1.5}));
                EXPECT_NEAR(above->position.s, s, 3e-8);
                EXPECT_NEAR(above->position.t, t, 3e-8);
                EXPECT_NEAR(above->position.h, 1.5, 3e-8);
            }
    }
}

TEST(RoadLocator, BesideAndBeyondTheRoad)
{
    const RoadNetwork read = sound(network(road("1", 100.0, straightPlan(100.0) + twoLanes())));
    const RoadLocator locator(read);
    const auto beside = locator.nearest(glm::dvec2(40.0, 10.0));
    EXPECT_DOUBLE_EQ(beside->position.s, 40.0);
    EXPECT_DOUBLE_EQ(beside->position.t, 10.0);
    EXPECT_NEAR(beside->distance, 6.5, 1e-12);
    const auto beyond = locator.nearest(glm::dvec2(103.0, -7.5));
    EXPECT_DOUBLE_EQ(beyond->position.s, 100.0);
    EXPECT_NEAR(beyond->distance, 5.0, 1e-12);
    EXPECT_FALSE(locator.nearest(glm::dvec2(40.0, 10.0), 6.0));
    EXPECT_TRUE(locator.nearest(glm::dvec2(40.0, 10.0), 7.0));
}

/// Feet on curves are found to rounding only; a point on the lanes is still at no distance.
TEST(RoadLocator, PointsOnACurveAreWithinNoDistance)
{
    const std::string bend =
        "<planView>" +
        geometry(R"(s="0" x="3" y="-2" hdg="0.4")", 100.0, R"(<spiral curvStart="0" curvEnd="0.03"/>)") +
        "</planView>";
    const RoadNetwork read = sound(network(road("1", 100.0, bend + twoLanes())));
    const RoadLocator locator(read);
    for (double s = 0.5; s < 100.0; s += 0.7)
        EXPECT_EQ(locator.within(glm::dvec2(surfacePoint(read.roads[0], s, 1.1)), 0.0).size(), 1u) << s;
}

/// A bridge 6 m above a road that crosses it at right angles.
TEST(RoadLocator, TellsABridgeFromTheRoadBelow)
{
    const std::string bridge =
        "<planView>" + geometry(R"(s="0" x="50" y="-50" hdg="1.5707963267948966")", 100.0, "<line/>") +
        R"(</planView><elevationProfile><elevation s="0" a="6" b="0" c="0" d="0"/></elevationProfile>)";
    const RoadNetwork read = sound(network(road("low", 100.0, straightPlan(100.0) + twoLanes()) +
                                           road("high", 100.0, bridge + twoLanes())));
    const RoadLocator locator(read);
    EXPECT_EQ(locator.nearest(glm::dvec3(50.5, 0.3, 0.4))->position.road, 0);
    EXPECT_EQ(locator.nearest(glm::dvec3(50.5, 0.3, 5.0))->position.road, 1);
    EXPECT_NEAR(locator.nearest(glm::dvec3(50.5, 0.3, 5.0))->position.h, -1.0, 1e-12);
    const std::vector<RoadMatch> all = locator.within(glm::dvec2(50.5, 0.3), 1.0);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].position.road, 0); // its reference line is nearer
    EXPECT_EQ(locator.within(glm::dvec2(80.0, 0.0), 1.0).size(), 1u);
}

/// The index finds what a look at every road finds.
TEST(RoadLocator, AgreesWithASearchOfEverything)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-300.0, 300.0), angle(-3.0, 3.0), bend(-0.03, 0.03);
    std::string roads;
    for (int i = 0; i < 60; ++i)
    {
        const std::string start = "s=\"0\" x=\"" + std::to_string(place(random)) + "\" y=\"" +
                                  std::to_string(place(random)) + "\" hdg=\"" +
                                  std::to_string(angle(random)) + "\"";
        const std::string shape = "<spiral curvStart=\"" + std::to_string(bend(random)) + "\" curvEnd=\"" +
                                  std::to_string(bend(random)) + "\"/>";
        roads += road(std::to_string(i), 80.0,
                      "<planView>" + geometry(start, 80.0, shape) + "</planView>" + twoLanes());
    }
    const RoadNetwork read = sound(network(roads));
    const RoadLocator locator(read);
    for (int i = 0; i < 200; ++i)
    {
        const glm::dvec2 point(place(random), place(random));
        double best = 1e9;
        for (const Road& candidate : read.roads)
            for (double s = 0.0; s <= 80.0; s += 0.25)
                for (const double t : {-3.5, -1.75, 0.0, 1.75, 3.5})
                    best = std::min(best, glm::length(point - glm::dvec2(surfacePoint(candidate, s, t))));
        const auto found = locator.nearest(point);
        ASSERT_TRUE(found);
        EXPECT_LE(found->distance, best + 1e-9);
        EXPECT_GE(found->distance, best - 1.0); // the samples are 1.75 m apart
    }
}

} // namespace
