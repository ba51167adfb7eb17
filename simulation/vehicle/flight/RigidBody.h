// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "simulation/vehicle/flight/Aerodynamics.h"
#include "simulation/vehicle/flight/MassProperties.h"

namespace simulation
{

/// The motion of a rigid body in a scene that turns with the Earth. Body axes: forward, right, down.
struct BodyMotion
{
    glm::dvec3 position{0.0};                ///< of the centre of mass, scene
    glm::dvec3 velocity{0.0};                ///< scene
    glm::dquat attitude{1.0, 0.0, 0.0, 0.0}; ///< body to scene
    glm::dvec3 rates{0.0};                   ///< relative to the stars, body axes
};

/// What acts on a body besides its forces.
struct BodySurroundings
{
    glm::dvec3 gravity{0.0}; ///< scene, with the centrifugal part
    glm::dvec3 earthRate{0.0};
    double spin = 0.0; ///< angular momentum of what turns about the body's x axis, kg m²/s
};

/// The acceleration of the centre of mass relative to the scene, in its axes.
glm::dvec3 accelerationOf(const BodyMotion& motion, const MassProperties& mass, const glm::dvec3& bodyForce,
                          const BodySurroundings& surroundings);

/// The change of the rates, body axes.
glm::dvec3 angularAccelerationOf(const glm::dvec3& rates, const MassProperties& mass,
                                 const glm::dvec3& bodyMoment, double spin);

/// Moves a body by one step: rates by the midpoint rule, the attitude by the exponential of their mean,
/// velocity with the force turned to the middle of the step, position by the trapezoid.
/// Source: Stevens, Lewis, *Aircraft Control and Simulation*, 2nd edition, 2003, sections 1.3 and 1.4
/// (equations over a turning Earth).
void advance(BodyMotion& motion, const MassProperties& mass, const ForceMoment& load,
             const BodySurroundings& surroundings, double stepS);

} // namespace simulation
