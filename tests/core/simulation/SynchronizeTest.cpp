// SPDX-License-Identifier: Apache-2.0
// Meetings with steady parts, and along trajectories; every result worked by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

std::string synchronize(const std::string& masterPosition, const std::string& position,
                        const std::string& finalSpeed = "")
{
    return "<PrivateAction><SynchronizeAction masterEntityRef=\"Lead\"><TargetPositionMaster>" +
           masterPosition + "</TargetPositionMaster><TargetPosition>" + position + "</TargetPosition>" +
           finalSpeed + "</SynchronizeAction></PrivateAction>";
}

std::string finalSpeed(double speed, const std::string& steady)
{
    return "<FinalSpeed><AbsoluteSpeed value=\"" + std::to_string(speed) + "\">" + steady +
           "</AbsoluteSpeed></FinalSpeed>";
}

std::string at(double s, int lane = -1)
{
    return "<LanePosition roadId=\"1\" laneId=\"" + std::to_string(lane) + "\" s=\"" + std::to_string(s) +
           "\"/>";
}

/// Lead drives 100 m on lane 1's side at 10 m/s, from 0 to 100 m; Ego does what it is told.
ScenarioText meeting(const std::string& privatesOfEgo, double leadMps = 10.0)
{
    ScenarioText text;
    text.entities += "<ScenarioObject name=\"Lead\">" + kCar + "</ScenarioObject>";
    text.privates = privatesOfEgo + "</Private><Private entityRef=\"Lead\">" + roadplay::onLane(0.0) +
                    speedAction(leadMps);
    return text;
}

/// Ego stands at 200 m and has 50 m to go in 10 s, the last 20 m at 5 m/s. Until then T = 6 s are left for 30
/// m; with the time t that is left the way is 5 t - 5/6 t² ln(t/6): it solves v' = (4d/t - 3v - 5)/t with d =
/// 30, v = 0 at 6 s, and leaves with 5 m/s.
TEST(Synchronize, HasTheFinalSpeedInTheSteadyPart)
{
    for (const char* steady :
         {R"(<TargetDistanceSteadyState distance="20"/>)", R"(<TargetTimeSteadyState time="4"/>)"})
    {
        const auto text =
            meeting(roadplay::onLane(200.0) + synchronize(at(100.0), at(250.0), finalSpeed(5.0, steady)));
        const auto state = [&](double timeS) { return roadplay::played(text, timeS)->entities()[0]; };
        const double left = 5.0 * 3.0 - 5.0 / 6.0 * 9.0 * std::log(0.5);
        EXPECT_NEAR(state(3.0).position.x, 230.0 - left, 0.05) << steady;
        EXPECT_NEAR(state(3.0).speedMps, 5.0 - 5.0 / 6.0 * 3.0 * (1.0 + 2.0 * std::log(0.5)), 0.03) << steady;
        for (const double timeS : {6.2, 8.0, 9.8})
        {
            EXPECT_NEAR(state(timeS).speedMps, 5.0, 0.01) << steady << timeS;
            EXPECT_NEAR(state(timeS).position.x, 250.0 - 5.0 * (10.0 - timeS), 0.06) << steady << timeS;
        }
    }
}

/// Without it the way is 5 t - 1/2 t² ln(t/10) with t the time that is left: Ego is elsewhere at 6 s.
TEST(Synchronize, HasItAtTheEndAloneWithoutOne)
{
    const auto text =
        meeting(roadplay::onLane(200.0) + synchronize(at(100.0), at(250.0), finalSpeed(5.0, "")));
    const double left = 5.0 * 4.0 - 0.5 * 16.0 * std::log(0.4);
    EXPECT_NEAR(roadplay::played(text, 6.0)->entities()[0].position.x, 250.0 - left, 0.05);
    EXPECT_NEAR(roadplay::played(text, 10.5)->entities()[0].speedMps, 5.0, 1e-9) << "it ends with that speed";
}

/// Ego crosses the road: its place along the road is that of the meeting from the start, its way along the
/// trajectory is not.
TEST(Synchronize, CountsTheWayAlongTheTrajectory)
{
    const auto crossing = followTrajectory(vertex(R"(<WorldPosition x="100" y="-4" h="1.5707963"/>)") +
                                           vertex(R"(<WorldPosition x="100" y="4" h="1.5707963"/>)"));
    const auto text = meeting(crossing + synchronize(at(100.0), R"(<WorldPosition x="100" y="0"/>)"));
    EXPECT_NEAR(roadplay::played(text, 5.0)->entities()[0].position.y, -2.0, 0.01);
    EXPECT_NEAR(roadplay::played(text, 9.9)->entities()[0].position.y, -0.04, 0.01);
    const auto twice = meeting(crossing + synchronize(at(100.0), R"(<WorldPosition x="100" y="0"/>)"), 20.0);
    EXPECT_NEAR(roadplay::played(twice, 2.5)->entities()[0].position.y, -2.0, 0.02) << "the master is faster";
}

/// A trajectory that turns back on itself is followed to the place, not across the gap between its legs.
TEST(Synchronize, TakesTheWholeWayRound)
{
    const auto round = followTrajectory(
        vertex(R"(<WorldPosition x="10" y="20"/>)") + vertex(R"(<WorldPosition x="60" y="20"/>)") +
        vertex(R"(<WorldPosition x="60" y="30"/>)") + vertex(R"(<WorldPosition x="10" y="30"/>)"));
    const auto text = meeting(round + synchronize(at(100.0), R"(<WorldPosition x="20" y="30"/>)"));
    // 50 + 10 + 40 m in 10 s
    EXPECT_NEAR(roadplay::played(text, 5.0)->entities()[0].position.x, 60.0, 0.2);
    EXPECT_NEAR(roadplay::played(text, 5.0)->entities()[0].position.y, 20.0, 0.3);
    EXPECT_NEAR(roadplay::played(text, 9.0)->entities()[0].position.x, 30.0, 0.2);
}

} // namespace
} // namespace simulation
