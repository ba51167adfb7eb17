// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/SteadyTurn.h"

#include "simulation/vehicle/road/Tyre.h"

namespace simulation
{

std::array<double, 2> axleStiffness(const RoadVehicleData& vehicle)
{
    const std::array<double, 2> loads = restLoads(vehicle);
    std::array<double, 2> stiffness{};
    for (std::size_t i = 0; i < 2; ++i)
    {
        const AxleData& axle = vehicle.axles[i];
        stiffness[i] = 2.0 * axle.tyresPerSide * tyreStiffness(axle.tyre, loads[i] / axle.tyresPerSide).y;
    }
    return stiffness;
}

double understeerOf(const RoadVehicleData& vehicle)
{
    const auto [front, rear] = axleStiffness(vehicle);
    const RoadMassProperties mass = massProperties(vehicle);
    const double toFront = vehicle.axles[0].xM - mass.centre.x, toRear = mass.centre.x - vehicle.axles[1].xM;
    return mass.massKg * (toRear * rear - toFront * front) / (front * rear * vehicle.wheelbaseM());
}

} // namespace simulation
