// SPDX-License-Identifier: Apache-2.0
// The tyre of a wheel by itself: force sideways by slip angle, up to friction, and none of it while it
// stands.
#include <cmath>

#include "FlightSupport.h"
#include "simulation/vehicle/flight/GroundContacts.h"

namespace
{

using namespace simulation;

constexpr double kTyreSpring = 50'000.0, kTyreDepthM = 0.04; ///< 2000 N

AircraftData oneWheel(double corneringPerRad)
{
    AircraftData data;
    ContactData wheel;
    wheel.isWheel = true;
    wheel.springNPerM = kTyreSpring;
    wheel.dampingNsPerM = 2000.0;
    wheel.friction = 0.8;
    wheel.corneringPerRad = corneringPerRad;
    data.contacts = {wheel};
    return data;
}

/// Force to the left over load of a wheel that has rolled 5 m along x with a slip angle.
double sideways(double speedMps, double slipAngle, double corneringPerRad = 8.0)
{
    const AircraftData data = oneWheel(corneringPerRad);
    GroundContacts contacts(data);
    BodyMotion motion;
    motion.position.z = -kTyreDepthM;
    motion.attitude = glm::dquat(0.0, 1.0, 0.0, 0.0); // upright: the body's axes are forward, right, down
    motion.velocity = speedMps * glm::dvec3(std::cos(slipAngle), std::sin(slipAngle), 0.0);
    motion.rates = glm::dvec3(0.0);
    const LevelGround ground;
    const double stepS = 1e-3;
    ForceMoment force;
    for (double wayM = 0.0; wayM < 5.0; wayM += speedMps * stepS)
    {
        contacts.look(motion, glm::dvec3(0.0), ground);
        force = contacts.press(motion, glm::dvec3(0.0), {}, stepS);
        motion.position += motion.velocity * stepS;
        motion.position.z = -kTyreDepthM;
    }
    return -force.force.y / contacts.contacts()[0].loadN;
}

TEST(AircraftTyre, PullsSidewaysByItsSlipAngle)
{
    for (const double speedMps : {2.0, 10.0, 30.0})
    {
        EXPECT_NEAR(sideways(speedMps, 0.03), -8.0 * std::tan(0.03), 0.004) << speedMps;
        EXPECT_NEAR(sideways(speedMps, -0.05), 8.0 * std::tan(0.05), 0.006) << speedMps;
    }
    EXPECT_NEAR(sideways(10.0, 0.03, 4.0), -4.0 * std::tan(0.03), 0.004);
}

TEST(AircraftTyre, PullsNoHarderThanFriction)
{
    EXPECT_NEAR(sideways(10.0, 0.5), -0.8, 0.001);
}

} // namespace
