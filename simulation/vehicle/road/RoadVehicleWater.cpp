// SPDX-License-Identifier: Apache-2.0
// How a road vehicle floats, fills and sinks. Source: Archimedes; drag of a plate, Hoerner, *Fluid-Dynamic
// Drag*, 1965, chapter 3 (about 1.1 of the dynamic pressure across it); how fast it fills is chosen, so that
// a car floats for about a minute, as rescue services tell.
#include <algorithm>
#include <cmath>

#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

namespace
{

constexpr double kWaterKgPerM3 = 1000.0, kPlateDrag = 1.1;
constexpr double kFillS = 40.0;    ///< in which it fills, while its lower body is under water
constexpr double kDryShare = 0.1;  ///< of the hull's volume that water does not fill
constexpr double kStillPerS = 1.2; ///< damping of slow motion, times the mass of the water that is moved
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
    const HullPlan lower = planOf(_data->hull.boxes.front());
    const double under = std::clamp((below.heightM - lower.lowM) / (lower.highM - lower.lowM), 0.0, 1.0);
    if (under > 0.1 && below.depthM > kDrownsM) crash("it drove into water");
    _airShare = std::max(kDryShare, _airShare - under * kStepS / kFillS);
}

/// Buoyancy and drag on a quarter of each box of the hull.
void RoadVehicle::swim(double stepS)
{
    if (!_waterM) return;
    const Axes body = axes();
    for (const HullBox& box : _data->hull.boxes)
        for (const double x : {-0.25, 0.25})
            for (const double y : {-0.25, 0.25})
            {
                const glm::dvec3 place = box.place + box.sizeM * glm::dvec3(x, y, 0.0) - _mass.centre;
                const glm::dvec3 arm = _motion.bodyToScene * place;
                const glm::dvec3 half = 0.25 * glm::dvec3(box.sizeM.x, box.sizeM.y, 2.0 * box.sizeM.z);
                const double high = half.x * std::abs(body.forward.z) + half.y * std::abs(body.left.z) +
                                    half.z * std::abs(body.up.z);
                const double under =
                    std::clamp((*_waterM - _motion.position.z - arm.z + high) / (2.0 * high), 0.0, 1.0);
                if (under <= 0.0) continue;
                const double displacedKg = kWaterKgPerM3 * under * 8.0 * half.x * half.y * half.z;
                _world->push(_body, -_airShare * displacedKg * _gravity, arm);
                const glm::dvec3 velocity = _motion.velocity + glm::cross(_motion.rates, arm);
                const glm::dvec3 inBody = glm::conjugate(_motion.bodyToScene) * velocity;
                const glm::dvec3 area =
                    4.0 * under * glm::dvec3(half.y * half.z, half.x * half.z, half.x * half.y);
                glm::dvec3 drag = -0.5 * kWaterKgPerM3 * kPlateDrag * area * glm::abs(inBody) * inBody -
                                  kStillPerS * displacedKg * inBody;
                const double share = 0.125 * _mass.massKg * kMostShare / stepS;
                drag = glm::clamp(drag, -share * glm::abs(inBody), share * glm::abs(inBody));
                _world->push(_body, _motion.bodyToScene * drag, arm);
            }
}

} // namespace simulation
