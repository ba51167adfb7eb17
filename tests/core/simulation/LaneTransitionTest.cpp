// SPDX-License-Identifier: Apache-2.0
// Lane changes over the joints of roads, by distance, slowly, in reverse and with other actions; every result
// worked by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

std::string laneChange(int lane, const std::string& dimension, double value, double offset = 0.0)
{
    return "<PrivateAction><LateralAction><LaneChangeAction targetLaneOffset=\"" + std::to_string(offset) +
           "\"><LaneChangeActionDynamics dynamicsShape=\"linear\" dynamicsDimension=\"" + dimension +
           "\" value=\"" + std::to_string(value) + "\"/><LaneChangeTarget><AbsoluteTargetLane value=\"" +
           std::to_string(lane) +
           "\"/></LaneChangeTarget></LaneChangeAction></LateralAction></PrivateAction>";
}

/// Ego at a speed on a lane at 10 m, looking along x.
ScenarioText driving(double speed, const std::string& stories, int lane = -1)
{
    ScenarioText text;
    const std::string turn = lane > 0
                                 ? "<Orientation type=\"relative\" h=\"3.14159265358979\"/></LanePosition>"
                                 : "</LanePosition>";
    text.privates =
        teleport("<LanePosition roadId=\"1\" laneId=\"" + std::to_string(lane) + "\" s=\"10\">" + turn) +
        speedAction(speed);
    text.stories = story(stories);
    return text;
}

/// Two roads of 100 m along x, joined end to end: s of the second falls along x.
roadplay::Roads joinedEndToEnd()
{
    const auto linked = [](const std::string& other)
    {
        return "<link><successor elementType=\"road\" elementId=\"" + other +
               "\" contactPoint=\"end\"/></link>\n";
    };
    std::string lanes = roadtexts::twoLanes();
    for (const auto& [id, next] : {std::pair("1", "-1"), std::pair("-1", "1")})
    {
        const std::string opening = std::string("<lane id=\"") + id + "\" type=\"driving\" level=\"false\">";
        lanes.insert(lanes.find(opening) + opening.size(),
                     std::string("<link><successor id=\"") + next + "\"/></link>");
    }
    const std::string back =
        "<planView>" +
        roadtexts::geometry(R"(s="0" x="200" y="0" hdg="3.14159265358979")", 100.0, "<line/>") +
        "</planView>\n";
    return std::make_shared<const RoadScene>(roadtexts::sound(
        roadtexts::network(roadtexts::road("1", 100.0, linked("2") + roadtexts::straightPlan(100.0) + lanes) +
                           roadtexts::road("2", 100.0, linked("1") + back + lanes))));
}

/// From y = -1.75 to the left, where lane 1 of the first road and lane -1 of the second one have their middle
/// at 1.75.
TEST(LaneTransition, GoesOnOverARoadThatRunsTheOtherWay)
{
    const auto text = driving(20.0, event("a", laneChange(1, "time", 5.0, 0.5), timeCondition(2.0)));
    const auto y = [&](double timeS)
    { return roadplay::played(text, timeS, joinedEndToEnd())->entities()[0].position.y; };
    EXPECT_NEAR(y(2.0), -1.75, 1e-9);
    EXPECT_NEAR(y(4.5), -1.75 + 0.5 * 4.0, 1e-6) << "half of it, at 59 m";
    EXPECT_NEAR(y(6.5), -1.75 + 0.9 * 4.0, 1e-6) << "beyond the joint, at 100 m";
    EXPECT_NEAR(y(7.5), 2.25, 1e-6) << "the offset is to the left of the first road";
    EXPECT_GT(roadplay::played(text, 7.5, joinedEndToEnd())->entities()[0].position.x, 115.0);
}

/// By 25 m along the lane: what goes sideways is no part of them. 3.5 m aside: the way is sqrt(25^2 + 3.5^2)
/// m long.
TEST(LaneTransition, CountsItsDistanceAlongTheLane)
{
    const auto text = driving(5.0, event("a", laneChange(1, "distance", 25.0), timeCondition(1.0)));
    const double endS = 1.0 + std::hypot(25.0, 3.5) / 5.0;
    const auto before = roadplay::played(text, endS - 0.1)->entities()[0];
    EXPECT_LT(before.position.y, 1.74);
    EXPECT_NEAR(before.headingDeg, std::atan2(3.5, 25.0) * 180.0 / M_PI, 1e-6);
    EXPECT_NEAR(roadplay::played(text, endS + 0.02)->entities()[0].position.y, 1.75, 1e-9);
    EXPECT_NEAR(roadplay::played(text, endS)->entities()[0].position.x, 10.0 + 5.0 + 25.0, 0.06);
}

TEST(LaneTransition, WaitsWhileTheEntityStands)
{
    const auto text = driving(0.0, event("a", laneChange(1, "time", 2.0), timeCondition(1.0)) +
                                       event("b", speedAction(10.0), timeCondition(4.0)));
    EXPECT_NEAR(roadplay::played(text, 4.0)->entities()[0].position.y, -1.75, 1e-9)
        << "nobody slides sideways";
    EXPECT_NEAR(roadplay::played(text, 5.0)->entities()[0].position.y, 0.0, 0.04)
        << "half a change after 1 s";
    EXPECT_NEAR(roadplay::played(text, 6.1)->entities()[0].position.y, 1.75, 1e-9);
}

TEST(LaneTransition, IsNoFasterThanTheEntity)
{
    // 3.5 m in 1 s at 1 m/s: it takes 3.5 s, sideways.
    const auto text = driving(1.0, event("a", laneChange(1, "time", 1.0), timeCondition(1.0)));
    EXPECT_NEAR(roadplay::played(text, 3.0)->entities()[0].position.y, -1.75 + 2.0, 0.026) << "within a step";
    EXPECT_NEAR(roadplay::played(text, 4.6)->entities()[0].position.y, 1.75, 1e-9);
}

/// Backwards at 10 m/s to the left: the nose looks to the right of the lane.
TEST(LaneTransition, TurnsTheNoseAwayInReverse)
{
    ScenarioText text = driving(-10.0, event("a", laneChange(1, "time", 3.5), timeCondition(1.0)));
    text.privates = roadplay::onLane(100.0) + speedAction(-10.0);
    const auto half = roadplay::played(text, 2.75)->entities()[0];
    EXPECT_NEAR(half.position.y, 0.0, 1e-6);
    EXPECT_NEAR(std::remainder(half.headingDeg, 360.0), -std::asin(0.1) * 180.0 / M_PI, 1e-6);
    EXPECT_LT(half.position.x, 75.0);
}

/// 1 m/s sideways for 3.5 s; from 1.5 s after its begin on the speed falls from 10 by 2 m/s². In each step
/// the lane change moves the entity by the speed before it falls, a speed action that was there first by the
/// speed after it.
TEST(LaneTransition, MovesByTheSpeedBeforeALaterSpeedAction)
{
    const auto xAfter = [](bool isSpeedFirst)
    {
        const std::string change = event("a", laneChange(1, "time", 3.5), timeCondition(1.0));
        const std::string brake = event("b", speedAction(6.0, "linear", "time", 2.0), timeCondition(1.0));
        return roadplay::played(driving(10.0, isSpeedFirst ? brake + change : change + brake), 3.0)
            ->entities()[0]
            .position.x;
    };
    double before = 10.0 + 10.0, after = before; // at 1 s
    for (int k = 0; k < 200; ++k)
    {
        const double first = 10.0 - 0.02 * k, last = first - 0.02;
        before += 0.01 * std::sqrt(first * first - 1.0);
        after += 0.01 * last * std::sqrt(1.0 - 1.0 / (first * first));
    }
    EXPECT_NEAR(xAfter(false), before, 1e-3);
    EXPECT_NEAR(xAfter(true), after, 1e-3);
    EXPECT_GT(before - after, 0.03) << "the two can be told apart";
}

} // namespace
} // namespace simulation
