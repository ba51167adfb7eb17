// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/vehicle/Air.h"

namespace simulation
{

/// How the air meets an aircraft. Frame: body, forward, right, down. Units: SI, radians.
struct AirData
{
    glm::dvec3 velocity{0.0}; ///< of the aircraft through the air
    glm::dvec3 rates{0.0};    ///< of the aircraft relative to the air, gusts included
    double speedMps = 0.0;
    double alpha = 0.0;     ///< -π…π
    double beta = 0.0;      ///< -π/2…π/2
    double alphaRate = 0.0; ///< 1/s
    double dynamicPressurePa = 0.0;
    double densityKgPerM3 = 0.0;
};

/// `velocity` and `rates`: relative to the air, body axes.
AirData airDataOf(const glm::dvec3& velocity, const glm::dvec3& rates, double densityKgPerM3);

/// The rate of the angle of attack for a velocity that changes by `acceleration` in body axes. 0 below 5 m/s.
double alphaRateOf(const glm::dvec3& velocity, const glm::dvec3& acceleration);

} // namespace simulation
