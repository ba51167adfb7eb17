// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/ControlledVehicle.h"

#include <algorithm>

namespace simulation
{

ControlledVehicle::ControlledVehicle(std::unique_ptr<DynamicVehicle> vehicle,
                                     std::unique_ptr<VehicleController> controller)
    : _vehicle(std::move(vehicle)), _controller(std::move(controller))
{
    look();
}

void ControlledVehicle::step(const Ground& ground, const Air& air, const Traffic& traffic)
{
    if (_controller)
        _controller->control({_now, _vehicle->status(), ground, air, traffic, _steps, _now.timeS},
                             _vehicle->inputs());
    if (_recorder) _recorder->add(_steps, _vehicle->inputs());
    _vehicle->step(ground, air);
    ++_steps;
    _before = _now;
    _now = _vehicle->state();
}

VehicleState stateBetween(const VehicleState& from, const VehicleState& to, double timeS)
{
    const double length = to.timeS - from.timeS;
    if (!(length > 0.0) || timeS >= to.timeS) return to;
    if (timeS <= from.timeS) return from;
    const double share = (timeS - from.timeS) / length;
    VehicleState state = to;
    state.timeS = timeS;
    state.position = glm::mix(from.position, to.position, share);
    state.velocity = glm::mix(from.velocity, to.velocity, share);
    state.bodyRates = glm::mix(from.bodyRates, to.bodyRates, share);
    state.bodyToScene = glm::normalize(glm::slerp(from.bodyToScene, to.bodyToScene, share));
    return state;
}

} // namespace simulation
