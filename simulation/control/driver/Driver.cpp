// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/driver/Driver.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/road/StopSignals.h"
#include "simulation/vehicle/road/SteadyTurn.h"

namespace simulation
{

namespace
{

constexpr double kAimS = 0.8, kLeastAimM = 4.0, kMostAimM = 25.0; ///< ahead of the rear axle
constexpr double kSeenM = 250.0;                                  ///< ahead of the vehicle
constexpr double kReachM = 12.0;  ///< along the way, in which it is looked for
constexpr double kBesideM = 1.7;  ///< from the middle of the own lane, within which others are in the way
constexpr double kAsideMps = 1.2; ///< of a change of lane
constexpr double kStandsMps = 0.15;
constexpr double kSlowsPerS = 2.0;    ///< deceleration for each m/s too fast
constexpr double kAheadAgainM = 12.0; ///< between both when an overtaker comes back

double lengthAhead(const RoadVehicleData& data)
{
    const HullBox& box = data.hull.boxes.front();
    return box.place.x + 0.5 * box.sizeM.x;
}

} // namespace

Driver::Driver(const RoadVehicle& vehicle, DriverPath path, const DriverSettings& settings)
    : _vehicle(vehicle),
      _path(std::move(path)),
      _settings(settings),
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

/// Slows down to a new wish no harder than for a bend.
void Driver::followWish(double speedMps)
{
    if (_settings.speedMps != _wishMps)
        _gentleMps = std::max(_settings.speedMps, std::min(_gentleMps, speedMps));
    _wishMps = _settings.speedMps;
    _gentleMps = std::max(_wishMps, _gentleMps - _settings.brakeMps2 * RoadVehicle::kStepS);
}

/// As fast as limit and bends allow, so that the brakes reach each bend in time.
double Driver::wantedSpeed(double speedMps) const
{
    double wanted = std::min(_gentleMps, _path.limitAt(_beside.alongM));
    const double seen = 20.0 + speedMps * speedMps / _settings.brakeMps2;
    for (double ahead = 0.0; ahead < std::min(seen, kSeenM); ahead += 2.0)
    {
        const double at = _beside.alongM + ahead;
        const double bend =
            std::sqrt(_settings.lateralMps2 / std::max(1e-6, std::abs(_path.curvatureAt(at))));
        const double there = std::min(bend, _path.limitAt(at));
        wanted = std::min(wanted, std::sqrt(there * there + 2.0 * 0.6 * _settings.brakeMps2 * ahead));
    }
    return std::max(wanted, 0.5);
}

void Driver::lookAtStops(const ControlView& view, double speedMps, Ahead& ahead)
{
    const double front = _beside.alongM + lengthAhead(_vehicle.data());
    const std::vector<DriverStop>& stops = _path.stops();
    while (_nextStop < stops.size() && stops[_nextStop].atM < front - 2.0)
    {
        ++_nextStop;
        _waitedS = 0.0;
    }
    if (_nextStop < stops.size())
    {
        const DriverStop& stop = stops[_nextStop];
        const double gap = stop.atM - front;
        bool isFree = _waitedS >= _settings.waitS;
        if (!stop.signal.empty())
        {
            isFree = true;
            if (view.traffic.signalStates)
                if (const auto found = view.traffic.signalStates->find(stop.signal);
                    found != view.traffic.signalStates->end())
                    isFree = letsPass(found->second);
            // Too late to stop for it.
            if (!isFree && gap < speedMps * speedMps / (2.0 * 2.0 * _settings.brakeMps2))
                isFree = speedMps > 3.0;
        }
        else if (speedMps < kStandsMps && gap < 2.0)
            _waitedS += RoadVehicle::kStepS;
        if (!isFree && gap + _settings.gapM - 1.0 < ahead.gapM)
        {
            ahead = {gap + _settings.gapM - 1.0, 0.0};
            _phase = "stop";
        }
    }
    if (_settings.stopsAtEnd)
    {
        const double gap = _path.lengthM() - front + _settings.gapM - 1.0;
        if (gap < ahead.gapM) ahead = {gap, 0.0};
        if (_path.lengthM() - front < 3.0 && speedMps < kStandsMps) _isDone = true;
    }
    else if (front > _path.lengthM() - 1.0)
        _isDone = true;
}

/// Who drives ahead, on the way moved aside by an offset.
Driver::Ahead Driver::lookAtOthers(const ControlView& view, double offsetM) const
{
    Ahead ahead;
    const double front = _beside.alongM + lengthAhead(_vehicle.data());
    for (std::size_t i = 0; i < view.traffic.entities.size(); ++i)
    {
        const EntityState& other = view.traffic.entities[i];
        if (static_cast<int>(i) == view.traffic.own || !other.isPresent) continue;
        if (glm::length(glm::dvec2(other.position - view.state.position)) > kSeenM) continue;
        const DriverPath::Beside beside =
            _path.nearest(other.position, _beside.alongM + 0.5 * kSeenM, 0.5 * kSeenM + kReachM);
        if (beside.alongM < _beside.alongM || std::abs(beside.offsetM - offsetM) > kBesideM) continue;
        const double halfLength = i < view.traffic.boxes.size() ? 0.5 * view.traffic.boxes[i].lengthM : 2.0;
        const double middle = i < view.traffic.boxes.size() ? view.traffic.boxes[i].centre.x : 1.4;
        const double heading = _path.headingRadAt(beside.alongM);
        const double gap = beside.alongM + middle - halfLength - front;
        if (gap > ahead.gapM) continue;
        ahead = {gap, other.velocity.x * std::cos(heading) + other.velocity.y * std::sin(heading)};
    }
    return ahead;
}

/// Goes to the left of a slower vehicle when nobody is there, and comes back ahead of it.
void Driver::considerOvertaking(const ControlView& view, double speedMps)
{
    const Ahead own = lookAtOthers(view, 0.0);
    const bool isOut = _wantedOffsetM != 0.0 && !_isLed;
    const double wish = wantedSpeed(speedMps);
    if (!isOut && !_isLed && _settings.overtakes && own.gapM < 40.0 && own.speedMps < 0.8 * wish)
    {
        const Ahead left = lookAtOthers(view, _settings.overtakeOffsetM);
        const double needed = 60.0 + 12.0 * std::max(0.0, speedMps - left.speedMps);
        if (left.gapM > needed) _wantedOffsetM = _settings.overtakeOffsetM;
    }
    // Back when nobody of the own lane is beside or just ahead.
    if (isOut && own.gapM > 40.0)
    {
        bool isClear = true;
        for (std::size_t i = 0; i < view.traffic.entities.size(); ++i)
        {
            const EntityState& other = view.traffic.entities[i];
            if (static_cast<int>(i) == view.traffic.own || !other.isPresent) continue;
            isClear = isClear && glm::length(glm::dvec2(other.position - view.state.position)) > kAheadAgainM;
        }
        if (isClear) _wantedOffsetM = 0.0;
    }
    if (_isLed) return;
    const double most = kAsideMps * RoadVehicle::kStepS;
    _offsetM += std::clamp(_wantedOffsetM - _offsetM, -most, most);
}

Driver::Ahead Driver::nearestAhead(const ControlView& view, double speedMps)
{
    _phase = _wantedOffsetM != 0.0 ? "overtake" : "drive";
    Ahead ahead = lookAtOthers(view, _wantedOffsetM);
    if (ahead.gapM < 50.0) _phase = "follow";
    lookAtStops(view, speedMps, ahead);
    return ahead;
}

/// Feet: a speed that the wanted acceleration leads to is held by throttle and brake.
void Driver::pedals(double wantedMps2, double speedMps, RoadInputs& inputs)
{
    _referenceMps =
        std::clamp(_referenceMps + wantedMps2 * RoadVehicle::kStepS, speedMps - 1.0, speedMps + 1.0);
    _referenceMps = std::max(0.0, _referenceMps);
    const double missing = _referenceMps - speedMps;
    _held = std::clamp(_held + 0.3 * missing * RoadVehicle::kStepS, -0.3, 1.0);
    double push = 0.08 * wantedMps2 + 0.5 * missing + _held;
    const bool stands = speedMps < kStandsMps && wantedMps2 <= 0.0;
    if (stands)
    {
        push = -1.0;
        _held = 0.0;
        _referenceMps = 0.0;
    }
    _hand.control(_vehicle, std::clamp(push, 0.0, 1.0), inputs);
    inputs[static_cast<std::size_t>(RoadInput::brake)] = std::clamp(-0.6 * push, 0.0, 1.0);
    inputs[static_cast<std::size_t>(RoadInput::handbrake)] = 0.0;
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
    _waitedS = 0.0;
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
    const double wish = wantedSpeed(speed);
    const double closing =
        speed * (speed - ahead.speedMps) / (2.0 * std::sqrt(_settings.accelerateMps2 * _settings.brakeMps2));
    const double desired =
        _settings.gapM +
        std::max(0.0, speed * _settings.headwayS * (ahead.speedMps > 0.5 ? 1.0 : 0.2) + closing);
    const double crowd = desired / std::max(0.1, ahead.gapM);
    double wanted =
        _settings.accelerateMps2 * (1.0 - std::pow(std::max(0.0, speed) / wish, 4.0) - crowd * crowd);
    if (speed > wish) wanted = std::min(wanted, kSlowsPerS * (wish - speed));
    wanted = std::clamp(wanted, -8.0, _settings.accelerateMps2);
    pedals(wanted, speed, next);
    next[static_cast<std::size_t>(RoadInput::indicator)] = indicator();
    std::copy(next.begin(), next.end(), inputs.begin());
}

} // namespace simulation
