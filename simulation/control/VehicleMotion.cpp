// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/VehicleMotion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

#include "simulation/state/EnvironmentState.h"
#include "simulation/vehicle/ScenarioWeather.h"

namespace simulation
{
namespace
{

constexpr double kSlenderM = 1.0, kCarM = 2.5; ///< what is smaller is a person, not a vehicle

std::string_view wordOf(VehicleCondition condition)
{
    if (condition == VehicleCondition::sound) return "sound";
    return condition == VehicleCondition::crashed ? "crashed" : "failed";
}

std::string noteOf(const VehicleStatus& status, double timeS)
{
    char time[40];
    std::snprintf(time, sizeof time, " after %.2f s: ", timeS);
    return std::string(wordOf(status.condition)) + time + std::string(status.reason);
}

/// The controls that tables have, of the inputs of a vehicle.
void writeControls(DynamicVehicle& vehicle, VehicleReadings& readings)
{
    const std::span<const std::string_view> names = vehicle.inputNames();
    const std::span<const double> inputs = vehicle.inputs();
    for (std::size_t i = 0; i < kControlNames.size(); ++i)
    {
        const auto found = std::find(names.begin(), names.end(), kControlNames[i]);
        if (found != names.end())
            readings.controls[i] = inputs[static_cast<std::size_t>(found - names.begin())];
    }
}

/// The body of another entity, so many seconds later; nothing: it has no size.
std::optional<MovingObstacle> movingBody(const EntityState& state, const BoundingBox& box, double laterS)
{
    constexpr double kLeastM = 0.05;
    if (box.lengthM < kLeastM || box.widthM < kLeastM || box.heightM < kLeastM) return std::nullopt;
    const glm::dmat3 body = state.bodyToLocal();
    const glm::dvec3 middle = state.position + body * box.centre + laterS * state.velocity;
    MovingObstacle mover;
    const double level = glm::length(glm::dvec2(body[0]));
    if (level > 1e-6) mover.box.along = glm::dvec2(body[0]) / level;
    mover.box.middle = glm::dvec2(middle);
    mover.box.halfM = 0.5 * glm::dvec2(box.lengthM, box.widthM);
    mover.box.lowM = middle.z - 0.5 * box.heightM;
    mover.box.highM = middle.z + 0.5 * box.heightM;
    mover.box.kind =
        std::min(box.lengthM, box.widthM) < kSlenderM && std::max(box.lengthM, box.widthM) < kCarM
            ? ObstacleKind::person
            : ObstacleKind::vehicle;
    mover.velocity = glm::dvec2(state.velocity);
    mover.name = state.name;
    return mover;
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
    : _vehicle(std::move(vehicle)), _land(std::move(ground)), _ground(_land), _air(std::move(air))
{
    publish(0.0);
}

void VehicleMotion::followWeather(double originHeightM, double turbulenceMps)
{
    _weather = Weather{originHeightM, turbulenceMps};
    WeatherSettings settings;
    settings.gustDeviationMps = turbulenceMps;
    _air = std::make_shared<const WeatherAir>(settings);
}

void VehicleMotion::takeWeather(const EnvironmentState& environment)
{
    if (!_weather) return;
    const GroundWeather ground = groundWeatherOf(environment);
    if (ground != _weather->ground) _ground = std::make_shared<const WeatheredGround>(_land, ground);
    _weather->ground = ground;
    if (environment.wind == _weather->wind && environment.temperatureK == _weather->temperatureK &&
        environment.pressurePa == _weather->pressurePa &&
        environment.seaPressurePa == _weather->seaPressurePa)
        return;
    _weather->wind = environment.wind;
    _weather->temperatureK = environment.temperatureK;
    _weather->pressurePa = environment.pressurePa;
    _weather->seaPressurePa = environment.seaPressurePa;
    WeatherSettings settings = weatherOf(environment, _weather->originHeightM);
    settings.gustDeviationMps = _weather->turbulenceMps;
    _air = std::make_shared<const WeatherAir>(settings);
}

void VehicleMotion::askForSpeed(double speedMps)
{
    if (_vehicle->controller()) _vehicle->controller()->askForSpeed(speedMps);
}

void VehicleMotion::askForPlace(const std::optional<glm::dvec3>& place)
{
    if (_vehicle->controller()) _vehicle->controller()->askForPlace(place);
}

foundation::Outcome VehicleMotion::begin(const EntityState& start, bool isAirborne, double timeS,
                                         const EnvironmentState& environment)
{
    _startS = timeS;
    _odometerM = start.odometerM;
    takeWeather(environment);
    _isDark = isDark(environment);
    const auto begun = _vehicle->vehicle().begin({start.position, foundation::radiansOf(start.headingDeg),
                                                  start.speedMps, isAirborne && start.speedMps > 0.0},
                                                 *_ground, *_air);
    if (!begun) return begun;
    _vehicle->look();
    publish(_startS);
    return foundation::success();
}

void VehicleMotion::advanceTo(double timeS, const Traffic& traffic)
{
    constexpr double kSameTimeS = 1e-9;
    if (traffic.environment)
    {
        takeWeather(*traffic.environment);
        _isDark = isDark(*traffic.environment);
    }
    _touched.clear();
    for (int done = 0; _vehicle->now().timeS < timeS - _startS - kSameTimeS; ++done)
    {
        if (_meetsOthers) lookAtOthers(traffic, done * _vehicle->vehicle().stepSeconds());
        _vehicle->step(*_ground, *_air, traffic);
        _odometerM += glm::distance(_vehicle->before().position, _vehicle->now().position);
        for (const int other : _vehicle->vehicle().touchedMovers())
            if (std::find(_touched.begin(), _touched.end(), other) == _touched.end())
                _touched.push_back(other);
        const VehicleStatus status = _vehicle->vehicle().status();
        if (status.condition != VehicleCondition::sound && _note.empty())
            _note = noteOf(status, _startS + _vehicle->now().timeS);
    }
    publish(timeS);
}

/// Who is near, so many seconds after they were seen.
void VehicleMotion::lookAtOthers(const Traffic& traffic, double sinceS)
{
    constexpr double kNearM = 30.0;
    _others.clear();
    const glm::dvec3& place = _vehicle->now().position;
    for (std::size_t i = 0; i < traffic.entities.size() && i < traffic.boxes.size(); ++i)
    {
        const EntityState& other = traffic.entities[i];
        if (static_cast<int>(i) == traffic.own || !other.isPresent || other.name == _towed) continue;
        const BoundingBox& box = traffic.boxes[i];
        if (glm::distance(other.position, place) > kNearM + box.lengthM) continue;
        if (auto body = movingBody(other, box, sinceS))
        {
            body->number = static_cast<int>(i);
            _others.push_back(std::move(*body));
        }
    }
    _vehicle->vehicle().meetMovers(_others);
}

std::string VehicleMotion::note() const
{
    if (!_note.empty() || !_vehicle->controller()) return _note;
    return _vehicle->controller()->note();
}

void VehicleMotion::publish(double timeS)
{
    _state = entityStateOf(stateBetween(_vehicle->before(), _vehicle->now(), timeS - _startS),
                           _vehicle->vehicle().referencePoint());
    _state.readings.emplace();
    _vehicle->vehicle().writeParts(_state);
    writeControls(_vehicle->vehicle(), *_state.readings);
    _state.readings->condition = wordOf(_vehicle->vehicle().status().condition);
    if (_state.lamps.contains("brakeLights") && !_state.lamps.contains("lowBeam"))
        _state.lamps["lowBeam"] = {_isDark ? LightMode::on : LightMode::off, 0.0, 0.0, 0.0, _isDark};
    _state.odometerM = _odometerM;
}

} // namespace simulation
