// SPDX-License-Identifier: Apache-2.0
#include "sound/SceneSound.h"

#include <algorithm>
#include <cmath>

#include "simulation/control/VehicleMotion.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace trainer
{

namespace
{

using simulation::SoundState;
using simulation::TyreSound;

constexpr int kCylinders = 4, kBlades = 2;
constexpr double kHeardM = 400.0, kDefaultLoad = 0.4, kMovesMps = 0.3;

TyreSound soundOf(simulation::GroundKind kind)
{
    switch (kind)
    {
    case simulation::GroundKind::asphalt:
        return TyreSound::hard;
    case simulation::GroundKind::wetAsphalt:
    case simulation::GroundKind::water:
        return TyreSound::wet;
    case simulation::GroundKind::gravel:
        return TyreSound::loose;
    default:
        return TyreSound::soft;
    }
}

void addFlight(const simulation::Aircraft& aircraft, SoundState& sound)
{
    const simulation::FlightReadings now = aircraft.readings();
    sound.engineHz = simulation::firingHz(now.engineRpm, kCylinders);
    sound.propellerHz = now.engineRpm / 60.0 * kBlades;
    sound.engineLoad = now.manifoldPa / now.pressurePa;
    sound.airspeedMps = now.trueAirspeedMps;
    // The horn sounds some degrees before the flow separates.
    sound.stallHorn =
        now.alphaDeg > aircraft.data().stall.beginsDeg - 3.0 && now.trueAirspeedMps > 10.0 ? 1.0 : 0.0;
    for (const simulation::Contact& contact : aircraft.contacts())
        if (contact.loadN > 0.0) sound.tyres = soundOf(contact.ground.kind);
}

void addDrive(const simulation::RoadVehicle& car, SoundState& sound)
{
    const simulation::RoadReadings now = car.readings();
    sound.engineHz = simulation::firingHz(now.engineRpm, kCylinders);
    sound.engineLoad = simulation::inputOf(car.roadInputs(), simulation::RoadInput::throttle);
    sound.rollingMps = now.speedMps;
    for (const simulation::RoadWheel& wheel : car.wheels())
        if (wheel.isTouching())
        {
            sound.tyres = soundOf(wheel.ground.kind());
            sound.tyreSlip = std::max(sound.tyreSlip, std::abs(wheel.tyreSlip));
        }
}

bool isLit(const simulation::EntityState& entity, const char* lamp)
{
    const auto found = entity.lamps.find(lamp);
    return found != entity.lamps.end() && found->second.isLit;
}

} // namespace

SceneSound::Source SceneSound::sourceOf(const simulation::ScenarioObject& object)
{
    if (object.isAirborne()) return {6.0, 60.0, 0.6};
    const auto* const vehicle = std::get_if<simulation::Vehicle>(&object.object);
    if (!vehicle || vehicle->category == "bicycle" || vehicle->category == "trailer" ||
        vehicle->category == "semitrailer")
        return {};
    const bool isHeavy = vehicle->category == "truck" || vehicle->category == "bus";
    return isHeavy ? Source{2.5, 30.0, 2.0} : Source{1.0, 45.0, 3.0};
}

SceneSound::SceneSound(const simulation::Scenario& scenario, std::size_t listener) : _listener(listener)
{
    for (const simulation::ScenarioObject& object : scenario.entities)
        _sources.push_back(sourceOf(object));
    _flies = scenario.entities[listener].isAirborne();
}

SoundState SceneSound::hear(const std::vector<simulation::EntityState>& entities,
                            const simulation::DynamicVehicle* vehicle)
{
    const simulation::EntityState& own = entities[_listener];
    SoundState sound;
    sound.airspeedMps = std::abs(own.speedMps);
    sound.rollingMps = own.isOnGround || !_flies ? own.speedMps : 0.0;
    sound.isIndicatorLit = isLit(own, "indicatorLeft") || isLit(own, "indicatorRight");
    if (const auto* const aircraft = dynamic_cast<const simulation::Aircraft*>(vehicle))
        addFlight(*aircraft, sound);
    else if (const auto* const car = dynamic_cast<const simulation::RoadVehicle*>(vehicle))
        addDrive(*car, sound);
    else if (_sources[_listener].loudness > 0.0)
    {
        const Source& source = _sources[_listener];
        sound.engineHz = source.idleHz + source.hzPerMps * std::abs(own.speedMps);
        sound.engineLoad = kDefaultLoad;
        if (_flies) sound.propellerHz = sound.engineHz;
        if (!_flies) sound.tyres = TyreSound::hard;
    }
    if (std::abs(sound.rollingMps) < kMovesMps) sound.tyres = TyreSound::none;
    if (own.isOnGround && !_wasOnGround) sound.bumpMps = _sinkMps;
    _wasOnGround = own.isOnGround;
    _sinkMps = std::max(0.0, -own.velocity.z);
    addPassing(entities, sound);
    return sound;
}

void SceneSound::addPassing(const std::vector<simulation::EntityState>& entities, SoundState& sound) const
{
    const simulation::EntityState& own = entities[_listener];
    const glm::dvec3 left = own.bodyToLocal()[1];
    for (std::size_t i = 0; i < std::min(entities.size(), _sources.size()); ++i)
    {
        const simulation::EntityState& other = entities[i];
        if (i == _listener || _sources[i].loudness <= 0.0 || !other.isPresent) continue;
        const glm::dvec3 away = other.position - own.position;
        const double distanceM = std::max(glm::length(away), 0.5);
        if (distanceM > kHeardM) continue;
        const glm::dvec3 direction = away / distanceM;
        sound.passing.push_back(
            {i, distanceM, glm::dot(other.velocity - own.velocity, direction), glm::dot(direction, left),
             _sources[i].idleHz + _sources[i].hzPerMps * std::abs(other.speedMps), _sources[i].loudness});
    }
}

const simulation::DynamicVehicle* vehicleOf(const simulation::ExternalMotion* motion)
{
    const auto* const moved = dynamic_cast<const simulation::VehicleMotion*>(motion);
    return moved ? &moved->vehicle().vehicle() : nullptr;
}

} // namespace trainer
