// SPDX-License-Identifier: Apache-2.0
// How a road vehicle floats, fills and sinks. How fast it fills is chosen, so that a car floats for about a
// minute, as rescue services tell.
#include <algorithm>

#include "simulation/vehicle/road/HullWater.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

namespace
{

constexpr double kFillS = 40.0;    ///< in which it fills, while its lower body is under water
constexpr double kDryShare = 0.1;  ///< of the hull's volume that water does not fill
constexpr double kDrownsM = 0.5;   ///< depth in which the engine stops
constexpr double kMostShare = 0.5; ///< of a point's speed that drag takes in a short step

} // namespace

/// Asks for the level of the water around the vehicle.
void RoadVehicle::lookAtWater(const Ground& ground, bool hasWater)
{
    _waterM.reset();
    if (!hasWater) return;
    GroundPoint below;
    ground.heightsBelow({&_motion.position, 1}, {&below, 1});
    if (!below.isKnown || below.kind != GroundKind::water) return;
    _waterM = below.heightM;
    const HullPlan lower = hullPlanOf(_data->hull.boxes.front(), _mass.centre, _motion);
    const double under = std::clamp((below.heightM - lower.lowM) / (lower.highM - lower.lowM), 0.0, 1.0);
    if (under > 0.1 && below.depthM > kDrownsM) crash("it drove into water");
    _airShare = std::max(kDryShare, _airShare - under * kStepS / kFillS);
}

void RoadVehicle::swim(double stepS)
{
    if (!_waterM) return;
    const HullWater water{*_waterM, _airShare, 0.125 * _mass.massKg * kMostShare / stepS, _gravity};
    pressByWater(_data->hull, _mass.centre, _motion, water,
                 [this](const glm::dvec3& force, const glm::dvec3& arm) { _world->push(_body, force, arm); });
}

} // namespace simulation
