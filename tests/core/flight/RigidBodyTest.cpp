// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/RigidBody.h"

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

constexpr double kBodyStepS = 1.0 / 120.0;

MassProperties someMass()
{
    MassProperties mass;
    mass.massKg = 850.0;
    mass.inertia = glm::dmat3(2067.0, 0.0, 23.0, 0.0, 1877.0, 0.0, 23.0, 0.0, 3424.0);
    mass.inverse = glm::inverse(mass.inertia);
    return mass;
}

// Ten seconds of free tumbling keep energy and angular momentum.
TEST(RigidBodyTest, TumblesWithoutGainOrLoss)
{
    const MassProperties mass = someMass();
    BodyMotion motion;
    motion.rates = {1.0, 0.5, -2.0};
    const auto momentum = [&] { return motion.attitude * (mass.inertia * motion.rates); };
    const auto energy = [&] { return 0.5 * glm::dot(motion.rates, mass.inertia * motion.rates); };
    const glm::dvec3 momentumBefore = momentum();
    const double energyBefore = energy();
    for (int i = 0; i < 1200; ++i)
        advance(motion, mass, {}, {}, kBodyStepS);
    EXPECT_NEAR(energy() / energyBefore, 1.0, 1e-4);
    EXPECT_LT(glm::length(momentum() - momentumBefore) / glm::length(momentumBefore), 1e-3);
}

// A propeller that turns right pushes the nose right while the nose rises.
TEST(RigidBodyTest, APropellerTurnsTheNoseByItsSpin)
{
    const glm::dvec3 turning = angularAccelerationOf({0.0, 0.2, 0.0}, someMass(), glm::dvec3(0.0), 500.0);
    EXPECT_GT(turning.z, 0.0);
    EXPECT_NEAR(turning.z, 0.2 * 500.0 / 3424.0, 1e-3);
}

// Thrown eastwards at the equator of a turning Earth, a body is lifted: 2 Ω v.
TEST(RigidBodyTest, FeelsTheTurningEarth)
{
    const BodySurroundings around{glm::dvec3(0.0), {0.0, 7.292115e-5, 0.0}, 0.0};
    BodyMotion motion;
    motion.velocity = {100.0, 0.0, 0.0};
    const glm::dvec3 acceleration = accelerationOf(motion, someMass(), glm::dvec3(0.0), around);
    EXPECT_NEAR(acceleration.z, 2.0 * 7.292115e-5 * 100.0, 1e-12);
}

TEST(MassPropertiesTest, AddsPointsAboutTheirCentre)
{
    AircraftData aircraft;
    aircraft.empty = {"empty", 3.0, {0.0, 0.0, 0.0}};
    aircraft.emptyInertia = glm::dmat3(1.0);
    aircraft.loads = {{"load", 1.0, {4.0, 0.0, 0.0}}};
    const MassProperties mass = massProperties(aircraft, {});
    EXPECT_DOUBLE_EQ(mass.massKg, 4.0);
    EXPECT_DOUBLE_EQ(mass.centre.x, 1.0);
    EXPECT_DOUBLE_EQ(mass.inertia[0][0], 1.0);
    EXPECT_DOUBLE_EQ(mass.inertia[1][1], 1.0 + 3.0 * 1.0 + 1.0 * 9.0);
    EXPECT_EQ(bodyPlace({4.0, 2.0, 1.0}, mass.centre), glm::dvec3(-3.0, 2.0, -1.0));
}

} // namespace
