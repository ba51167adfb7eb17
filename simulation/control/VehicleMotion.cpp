// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/VehicleMotion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

std::string noteOf(const VehicleStatus& status, double timeS)
{
    char time[40];
    std::snprintf(time, sizeof time, " after %.2f s: ", timeS);
    return (status.condition == VehicleCondition::crashed ? "crashed" : "failed") + std::string(time) +
           std::string(status.reason);
}

} // namespace

EntityState entityStateOf(const VehicleState& vehicle, const glm::dvec3& reference)
{
    const glm::dmat3 body = glm::mat3_cast(vehicle.bodyToScene);
    const glm::dvec3 forward = body[0];
    EntityState state;
    state.position = vehicle.position + body * reference;
    state.velocity = vehicle.velocity + body * glm::cross(vehicle.bodyRates, reference);
    state.headingDeg = foundation::degreesOf(std::atan2(forward.y, forward.x));
    state.pitchDeg = foundation::degreesOf(std::asin(std::clamp(-forward.z, -1.0, 1.0)));
    state.rollDeg = foundation::degreesOf(std::atan2(body[1].z, body[2].z));
    state.speedMps = glm::dot(state.velocity, forward);
    state.isOnGround = vehicle.isOnGround;
    return state;
}

VehicleMotion::VehicleMotion(std::unique_ptr<ControlledVehicle> vehicle, std::shared_ptr<const Ground> ground,
                             std::shared_ptr<const Air> air)
    : _vehicle(std::move(vehicle)), _ground(std::move(ground)), _air(std::move(air))
{
    publish(0.0);
}

foundation::Outcome VehicleMotion::begin(const EntityState& start, bool isAirborne)
{
    const auto begun = _vehicle->vehicle().begin({start.position, foundation::radiansOf(start.headingDeg),
                                                  start.speedMps, isAirborne && start.speedMps > 0.0},
                                                 *_ground, *_air);
    if (!begun) return begun;
    _vehicle->look();
    publish(0.0);
    return foundation::success();
}

void VehicleMotion::advanceTo(double timeS, const Traffic& traffic)
{
    constexpr double kSameTimeS = 1e-9;
    while (_vehicle->now().timeS < timeS - kSameTimeS)
    {
        _vehicle->step(*_ground, *_air, traffic);
        _odometerM += glm::distance(_vehicle->before().position, _vehicle->now().position);
        const VehicleStatus status = _vehicle->vehicle().status();
        if (status.condition != VehicleCondition::sound && _note.empty())
            _note = noteOf(status, _vehicle->now().timeS);
    }
    publish(timeS);
}

void VehicleMotion::publish(double timeS)
{
    _state = entityStateOf(stateBetween(_vehicle->before(), _vehicle->now(), timeS),
                           _vehicle->vehicle().referencePoint());
    _vehicle->vehicle().writeParts(_state);
    _state.odometerM = _odometerM;
}

} // namespace simulation
