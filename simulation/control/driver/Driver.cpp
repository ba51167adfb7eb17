// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/driver/Driver.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/road/SteadyTurn.h"

namespace simulation
{

namespace
{

constexpr double kAimS = 0.8, kLeastAimM = 4.0, kMostAimM = 25.0; ///< ahead of the rear axle

} // namespace

Driver::Driver(const RoadVehicle& vehicle, DriverPath path, const DriverSettings& settings)
    : _vehicle(vehicle),
      _path(std::move(path)),
      _settings(settings),
      _signs(settings.waitS),
      _understeer(understeerOf(vehicle.data())),
      _wishMps(settings.speedMps),
      _gentleMps(settings.speedMps)
{
}

/// Aims at a point of the way; a vehicle that understeers is turned more. Returns the input.
double Driver::steering(const VehicleState& state)
{
    const glm::dvec3 reference = state.position + state.bodyToScene * _vehicle.referencePoint();
    _beside = _path.nearest(reference, _beside.alongM, _hasBegun ? kReachM : 1e9);
    _worstM = std::max(_worstM, std::abs(_beside.offsetM));
    const glm::dvec3 forward = state.bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
    const double speed = glm::dot(state.velocity, forward);
    const double aimM = std::clamp(kAimS * speed, kLeastAimM, kMostAimM);
    const glm::dvec3 aim = _path.placeAt(_beside.alongM + aimM, _offsetM) - reference;
    const double aside = forward.x * aim.y - forward.y * aim.x;
    const double curvature = 2.0 * aside / std::max(1.0, glm::dot(glm::dvec2(aim), glm::dvec2(aim)));
    const RoadVehicleData& data = _vehicle.data();
    const double angle = std::atan(curvature * data.wheelbaseM()) + curvature * _understeer * speed * speed;
    return std::clamp(angle / foundation::radiansOf(data.steering.lockDeg), -1.0, 1.0);
}

void Driver::askForPlace(const std::optional<glm::dvec3>& place)
{
    _isLed = place.has_value();
    _wantedOffsetM = place ? _path.nearest(*place, _beside.alongM, kReachM).offsetM : 0.0;
    if (place) _offsetM = _wantedOffsetM;
}

/// Shows that it goes aside until it is there.
double Driver::indicator() const
{
    constexpr double kThereM = 0.3;
    const double asideM = _wantedOffsetM - _beside.offsetM;
    return std::abs(asideM) < kThereM ? 0.0 : std::copysign(1.0, asideM);
}

void Driver::resume(const ControlView& /*view*/, std::span<const double> /*inputs*/)
{
    _hasBegun = false;
    _held = _offsetM = _wantedOffsetM = 0.0;
    _nextStop = 0;
    _signs = StopAtSign(_settings.waitS);
}

void Driver::control(const ControlView& view, std::span<double> inputs)
{
    if (inputs.size() != kRoadInputCount) return;
    const glm::dvec3 forward = view.state.bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
    const double speed = glm::dot(view.state.velocity, forward);
    RoadInputs next{};
    next[static_cast<std::size_t>(RoadInput::steering)] = steering(view.state);
    if (!_hasBegun)
    {
        _hand.begin(_vehicle);
        _referenceMps = speed;
        _hasBegun = true;
    }
    followWish(speed);
    considerOvertaking(view, speed);
    const Ahead ahead = nearestAhead(view, speed);
    pedals(acceleration(speed, ahead), speed, next);
    next[static_cast<std::size_t>(RoadInput::indicator)] = indicator();
    std::copy(next.begin(), next.end(), inputs.begin());
}

} // namespace simulation
