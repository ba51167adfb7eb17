// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/RigidBody.h"

#include <cmath>

namespace simulation
{

namespace
{

/// The rotation by a vector: its direction is the axis, its length the angle.
glm::dquat rotationBy(const glm::dvec3& turn)
{
    const double angle = glm::length(turn);
    const double scale = angle > 1e-9 ? std::sin(0.5 * angle) / angle : 0.5;
    return {std::cos(0.5 * angle), scale * turn.x, scale * turn.y, scale * turn.z};
}

} // namespace

glm::dvec3 accelerationOf(const BodyMotion& motion, const MassProperties& mass, const glm::dvec3& bodyForce,
                          const BodySurroundings& surroundings)
{
    return motion.attitude * (bodyForce / mass.massKg) + surroundings.gravity -
           2.0 * glm::cross(surroundings.earthRate, motion.velocity);
}

glm::dvec3 angularAccelerationOf(const glm::dvec3& rates, const MassProperties& mass,
                                 const glm::dvec3& bodyMoment, double spin)
{
    const glm::dvec3 momentum = mass.inertia * rates + glm::dvec3(spin, 0.0, 0.0);
    return mass.inverse * (bodyMoment - glm::cross(rates, momentum));
}

void advance(BodyMotion& motion, const MassProperties& mass, const ForceMoment& load,
             const BodySurroundings& surroundings, double stepS)
{
    const glm::dvec3 halfway =
        motion.rates +
        0.5 * stepS * angularAccelerationOf(motion.rates, mass, load.moment, surroundings.spin);
    const glm::dvec3 rates =
        motion.rates + stepS * angularAccelerationOf(halfway, mass, load.moment, surroundings.spin);
    const glm::dvec3 earthInBody = glm::conjugate(motion.attitude) * surroundings.earthRate;
    const glm::dvec3 turn = (0.5 * (motion.rates + rates) - earthInBody) * stepS;
    BodyMotion middle = motion;
    middle.attitude = motion.attitude * rotationBy(0.5 * turn);
    const glm::dvec3 velocity =
        motion.velocity + stepS * accelerationOf(middle, mass, load.force, surroundings);
    motion.position += 0.5 * stepS * (motion.velocity + velocity);
    motion.velocity = velocity;
    motion.attitude = glm::normalize(motion.attitude * rotationBy(turn));
    motion.rates = rates;
}

} // namespace simulation
