// SPDX-License-Identifier: Apache-2.0
#include "view/ChaseCamera.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

using scenery::Pose;
using simulation::GroundProvider;
using simulation::GroundSample;
using trainer::ChaseCamera;
using trainer::ChaseSettings;

namespace
{

/// Waves 40 m high and 150 m long, with a wall 60 m high at x = 300, and no data beyond y = 500.
std::optional<GroundSample> roughGround(double x, double y)
{
    if (y > 500.0) return {};
    const double wall = x > 300.0 && x < 304.0 ? 60.0 : 0.0;
    return GroundSample{40.0 * std::sin(x / 24.0) * std::cos(y / 31.0) + wall};
}

/// A body on that ground, driving along x and turning left and right.
Pose bodyAt(double timeS)
{
    const double x = 18.0 * timeS;
    const double y = 25.0 * std::sin(timeS / 2.0);
    const auto place = [](double px, double py)
    {
        const auto ground = roughGround(px, py);
        return glm::dvec3(px, py, ground ? ground->heightM : 0.0);
    };
    Pose pose;
    pose.positionWorld = place(x, y);
    const glm::dvec3 ahead = place(x + 0.2, y + 0.2 * 12.5 / 18.0 * std::cos(timeS / 2.0));
    const glm::dvec3 forward = glm::normalize(ahead - pose.positionWorld);
    const glm::dvec3 left = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), forward));
    pose.worldFromBody = glm::dmat3(forward, left, glm::cross(forward, left));
    return pose;
}

/// The smallest height above ground that the camera has over a drive.
double leastClearance(const ChaseSettings& settings, const GroundProvider& seenByCamera)
{
    ChaseCamera camera(settings);
    double least = 1e9;
    for (int step = 0; step < 3000; ++step)
    {
        const Pose eye = camera.update(bodyAt(step * 0.01), 0.01, seenByCamera);
        if (const auto ground = roughGround(eye.positionWorld.x, eye.positionWorld.y))
            least = std::min(least, eye.positionWorld.z - ground->heightM);
    }
    return least;
}

} // namespace

/// The angle between the axis of the camera and the way to the body, degrees.
double angleToBody(double heightM)
{
    ChaseCamera camera(ChaseSettings::above(heightM));
    const Pose body;
    const Pose eye = camera.update(body, 0.01, {});
    return glm::degrees(
        std::acos(glm::dot(eye.worldFromBody[0], glm::normalize(body.positionWorld - eye.positionWorld))));
}

TEST(ChaseCamera, FromHighAboveTheCarIsInThePicture)
{
    // Half of the usual picture is 20° high; 15° leave room for the car itself.
    for (const double heightM : {3.0, 10.0, 30.0, 50.0, 80.0, 300.0, 1000.0})
        EXPECT_LT(angleToBody(heightM), 15.0) << heightM;
}

TEST(ChaseCamera, BehindATrainItIsBehindTheLastTrailer)
{
    const auto eyeX = [](const ChaseSettings& settings)
    { return ChaseCamera(settings).update({}, 0.0, {}).positionWorld.x; };
    EXPECT_DOUBLE_EQ(eyeX(ChaseSettings::forTrain(0.9, 1.4)), -9.0);
    EXPECT_DOUBLE_EQ(eyeX(ChaseSettings::forTrain(17.0, 4.0)), -25.0);
    EXPECT_GT(eyeX(ChaseSettings::forCar()), -17.0) << "the mutation: it would be inside the trailer";
    EXPECT_GT(ChaseSettings::forTrain(17.0, 4.0).heightM, 5.0);
}

TEST(ChaseCamera, IsNeverBelowTheGround)
{
    for (const ChaseSettings& settings : {ChaseSettings::forCar(), ChaseSettings::forAircraft()})
        EXPECT_GE(leastClearance(settings, roughGround), settings.clearanceM - 1e-9);
}

TEST(ChaseCamera, WithoutItsGroundItWouldBeBelow)
{
    // The mutation that the test above must catch: a camera that does not look at the ground.
    EXPECT_LT(leastClearance(ChaseSettings::forCar(), {}), 0.0);
}

TEST(ChaseCamera, StartsStraightBehindAndAbove)
{
    ChaseCamera camera(ChaseSettings::forCar());
    const Pose eye = camera.update({}, 0.0, {});
    EXPECT_NEAR(eye.positionWorld.x, -9.0, 1e-12);
    EXPECT_NEAR(eye.positionWorld.y, 0.0, 1e-12);
    EXPECT_NEAR(eye.positionWorld.z, 2.8, 1e-12);
    EXPECT_GT(eye.forward().x, 0.9);
    EXPECT_NEAR(eye.left().z, 0.0, 1e-12) << "the horizon is level";
}

TEST(ChaseCamera, FollowsATurnSmoothlyAndArrives)
{
    ChaseCamera camera(ChaseSettings::forCar());
    camera.update({}, 0.0, {});
    Pose turned;
    turned.worldFromBody = glm::dmat3(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    const Pose soon = camera.update(turned, 0.05, {});
    EXPECT_LT(soon.positionWorld.x, -7.0) << "it may not jump";
    Pose late = soon;
    for (int i = 0; i < 100; ++i)
        late = camera.update(turned, 0.05, {});
    EXPECT_NEAR(late.positionWorld.x, 0.0, 0.01);
    EXPECT_NEAR(late.positionWorld.y, -9.0, 0.01);
}

TEST(ChaseCamera, TwoRunsAgreeToTheLastBit)
{
    ChaseCamera a(ChaseSettings::forCar());
    ChaseCamera b(ChaseSettings::forCar());
    for (int step = 0; step < 500; ++step)
    {
        const Pose eyeA = a.update(bodyAt(step * 0.02), 0.02, roughGround);
        const Pose eyeB = b.update(bodyAt(step * 0.02), 0.02, roughGround);
        ASSERT_EQ(eyeA.positionWorld, eyeB.positionWorld);
        ASSERT_EQ(eyeA.worldFromBody, eyeB.worldFromBody);
    }
}
