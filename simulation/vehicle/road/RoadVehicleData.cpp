// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/RoadVehicleData.h"

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{

RoadMassProperties massProperties(const RoadVehicleData& vehicle)
{
    RoadMassProperties sum;
    sum.inertiaKgM2 = glm::dvec3(0.0);
    std::vector<RoadMass> parts = vehicle.loads;
    parts.push_back(vehicle.body);
    for (const RoadMass& part : parts)
    {
        sum.massKg += part.massKg;
        sum.centre += part.massKg * part.place;
    }
    sum.centre /= sum.massKg;
    for (const RoadMass& part : parts)
    {
        const glm::dvec3 arm = part.place - sum.centre;
        const glm::dvec3 square = arm * arm;
        sum.inertiaKgM2 +=
            part.inertiaKgM2 +
            part.massKg * glm::dvec3(square.y + square.z, square.x + square.z, square.x + square.y);
    }
    return sum;
}

std::array<double, 2> restLoads(const RoadVehicleData& vehicle)
{
    const RoadMassProperties mass = massProperties(vehicle);
    const double weightN = mass.massKg * foundation::kStandardGravityMps2;
    const double front = (mass.centre.x - vehicle.axles[1].xM) / vehicle.wheelbaseM();
    return {0.5 * weightN * front, 0.5 * weightN * (1.0 - front)};
}

} // namespace simulation
