// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/controllers/PedalDrive.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kDefaultMassKg = 1500.0;

double massOf(const ScenarioObject& object)
{
    const auto* vehicle = std::get_if<Vehicle>(&object.object);
    return vehicle && vehicle->massKg.value_or(0.0) > 0.0 ? *vehicle->massKg : kDefaultMassKg;
}

double decelerationOf(const ControlOverride& brake, double mostMps2, double massKg)
{
    if (!brake.isActive) return 0.0;
    return brake.isForce ? brake.value / massKg : brake.value * mostMps2;
}

} // namespace

void Controls::take(const OverrideAction& action)
{
    if (action.throttle)
    {
        hasThrottle = action.throttle->isActive;
        throttle = hasThrottle ? action.throttle->value : 0.0;
    }
    if (action.clutch) clutch = action.clutch->isActive ? action.clutch->value : 0.0;
    if (action.brake) brake = *action.brake;
    if (action.parkingBrake) parkingBrake = *action.parkingBrake;
    if (action.gear)
    {
        hasGear = action.gear->isActive && action.gear->lever != GearLever::forward;
        lever = hasGear ? action.gear->lever : GearLever::forward;
    }
}

double PedalDrive::speedAfter(ActionScene& scene, int actor)
{
    const ScenarioObject& object = scene.scenario().entities[static_cast<std::size_t>(actor)];
    const Performance limits = performanceOf(object);
    const bool isInGear = _controls.lever == GearLever::forward || _controls.lever == GearLever::reverse;
    const double way = _controls.lever == GearLever::reverse ? -1.0 : 1.0;
    if (isInGear)
        _speedMps +=
            scene.stepS() * way * _controls.throttle * (1.0 - _controls.clutch) * limits.maxAccelerationMps2;
    const double most = limits.maxDecelerationMps2, mass = massOf(object);
    const double braking = _controls.lever == GearLever::park
                               ? most
                               : decelerationOf(_controls.brake, most, mass) +
                                     decelerationOf(_controls.parkingBrake, most, mass);
    const double bound = most * scene.grip();
    const double less = std::min(scene.stepS() * std::min(braking, bound), std::fabs(_speedMps));
    _speedMps -= std::copysign(less, _speedMps);
    if (limits.maxSpeedMps > 0.0) _speedMps = std::clamp(_speedMps, -limits.maxSpeedMps, limits.maxSpeedMps);
    return _speedMps;
}

} // namespace simulation
