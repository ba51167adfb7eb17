// SPDX-License-Identifier: Apache-2.0
// Distances kept within limits, and the greatest speed of a vehicle; every result worked by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

std::string keepDistance(const std::string& wanted, const std::string& limits, bool isContinuous = true)
{
    return "<PrivateAction><LongitudinalAction><LongitudinalDistanceAction entityRef=\"Lead\" " + wanted +
           " freespace=\"false\" continuous=\"" + (isContinuous ? "true" : "false") +
           "\" displacement=\"trailingReferencedEntity\"><DynamicConstraints " + limits +
           "/></LongitudinalDistanceAction></LongitudinalAction></PrivateAction>";
}

/// Ego at s with 10 m/s, Lead at 100 m with 10 m/s.
ScenarioText following(double s, const std::string& action)
{
    ScenarioText text;
    text.entities += "<ScenarioObject name=\"Lead\">" + kCar + "</ScenarioObject>";
    text.privates = roadplay::onLane(s) + speedAction(10.0) + "</Private><Private entityRef=\"Lead\">" +
                    roadplay::onLane(100.0) + speedAction(10.0);
    text.stories = story(event("a", action, timeCondition(0.0)));
    return text;
}

double gapAt(const ScenarioText& text, double timeS)
{
    const auto player = roadplay::played(text, timeS);
    return player->entities()[1].position.x - player->entities()[0].position.x;
}

/// A spring of 0.4 /m times 5 m/s², critically damped: from 0.5 m too far the rest after t is 0.5 (1 + w t)
/// exp(-w t) with w = sqrt(2).
TEST(Following, IsACriticallyDampedSpring)
{
    const auto text = following(
        79.5, keepDistance("distance=\"20\"", "maxAcceleration=\"5\" maxDeceleration=\"5\" maxSpeed=\"50\""));
    const double w = std::sqrt(2.0);
    for (const double timeS : {1.0, 2.0, 3.0})
        EXPECT_NEAR(gapAt(text, timeS), 20.0 + 0.5 * (1.0 + w * timeS) * std::exp(-w * timeS), 0.01) << timeS;
    const auto softer = following(
        79.5, keepDistance("distance=\"20\"", "maxAcceleration=\"5\" maxDeceleration=\"2\" maxSpeed=\"50\""));
    EXPECT_GT(gapAt(softer, 1.0), gapAt(text, 1.0) + 0.05) << "the limits are those of the spring";
}

/// 10 m too far: the spring would pull with 20 m/s², 1 m/s² are allowed.
TEST(Following, KeepsItsLimits)
{
    const auto text = following(
        70.0, keepDistance("distance=\"20\"", "maxAcceleration=\"1\" maxDeceleration=\"5\" maxSpeed=\"50\""));
    EXPECT_NEAR(gapAt(text, 1.0), 30.0 - 0.5, 0.02);
    // With 1 m/s³ its acceleration after t is t: the way of it t³/6.
    const auto gentle =
        following(70.0, keepDistance("distance=\"20\"", "maxAcceleration=\"9\" maxDeceleration=\"9\" "
                                                        "maxSpeed=\"50\" maxAccelerationRate=\"1\""));
    EXPECT_NEAR(gapAt(gentle, 1.0), 30.0 - 1.0 / 6.0, 0.02);
}

TEST(Following, ATimeGapCountsByTheSpeedOfTheOther)
{
    const auto text = following(
        60.0, keepDistance("timeGap=\"2\"", "maxAcceleration=\"5\" maxDeceleration=\"5\" maxSpeed=\"50\""));
    EXPECT_NEAR(gapAt(text, 20.0), 20.0, 0.01) << "two seconds at 10 m/s";
}

TEST(Following, NoVehicleIsFasterThanItCan)
{
    ScenarioText text;
    text.privates = roadplay::onLane(10.0) + speedAction(20.0);
    text.stories = story(event("a", speedAction(100.0), timeCondition(1.0)));
    EXPECT_NEAR(roadplay::played(text, 2.0)->entities()[0].speedMps, 70.0, 1e-9);
}

} // namespace
} // namespace simulation
