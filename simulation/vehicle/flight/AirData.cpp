// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/AirData.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

AirData airDataOf(const glm::dvec3& velocity, const glm::dvec3& rates, double densityKgPerM3)
{
    AirData air;
    air.velocity = velocity;
    air.rates = rates;
    air.speedMps = glm::length(velocity);
    air.densityKgPerM3 = densityKgPerM3;
    air.dynamicPressurePa = 0.5 * densityKgPerM3 * air.speedMps * air.speedMps;
    if (air.speedMps > 1e-3)
    {
        air.alpha = std::atan2(velocity.z, velocity.x);
        air.beta = std::asin(std::clamp(velocity.y / air.speedMps, -1.0, 1.0));
    }
    return air;
}

double alphaRateOf(const glm::dvec3& velocity, const glm::dvec3& acceleration)
{
    const double square = velocity.x * velocity.x + velocity.z * velocity.z;
    if (square < 25.0) return 0.0;
    return (velocity.x * acceleration.z - velocity.z * acceleration.x) / square;
}

} // namespace simulation
