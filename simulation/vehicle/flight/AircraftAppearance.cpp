// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <foundation/Angle.h>

#include "simulation/vehicle/Airspeeds.h"
#include "simulation/vehicle/flight/Aircraft.h"

namespace simulation
{
namespace
{

GearLeg legOf(const ContactData& wheel)
{
    constexpr double kMiddleM = 0.1;
    if (wheel.place.y < -kMiddleM) return kLeftLeg;
    return wheel.place.y > kMiddleM ? kRightLeg : kNoseLeg;
}

/// How far a leg that broke is pressed in: up to the belly.
double foldedM(const AircraftData& aircraft, const ContactData& wheel)
{
    const HullBox& lowest = aircraft.hull.boxes.front();
    return std::max(0.0, lowest.place.z - 0.5 * lowest.sizeM.z - wheel.place.z);
}

} // namespace

void Aircraft::writeParts(EntityState& entity) const
{
    AircraftParts parts;
    const SurfaceAngles surfaces = surfaceAngles(*_data, _inputs, _state.flapDeg);
    parts.elevatorDeg = foundation::degreesOf(surfaces.elevator);
    parts.leftAileronDeg = foundation::degreesOf(surfaces.aileron);
    // The right one goes the other way, by its own travel.
    parts.rightAileronDeg =
        _data->aileron.degreesAt(-trimmedInputOf(_inputs, FlightInput::aileron, FlightInput::aileronTrim));
    parts.rudderDeg = foundation::degreesOf(surfaces.rudder);
    parts.flapDeg = _state.flapDeg;
    parts.propellerTurnDeg = _turns.propellerDeg();
    parts.propellerRadps = _state.engineRadps;
    const glm::dvec3 centre = massProperties(*_data, _state.fuelKg).centre, reference = referencePoint();
    const std::span<const Contact> contacts = _contacts.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        const ContactData& data = _data->contacts[i];
        if (!data.isWheel) continue;
        const GearLeg leg = legOf(data);
        const glm::dvec3 arm = bodyPlace(data.place, centre);
        parts.wheelBottom[leg] = glm::dvec3(arm.x, -arm.y, -arm.z) - reference;
        parts.strutM[leg] = contacts[i].isGone ? foldedM(*_data, data) : std::max(0.0, contacts[i].depthM);
        parts.wheelTurnDeg[leg] = _turns.wheelDeg(i);
        if (leg == kNoseLeg) parts.noseSteeringDeg = data.steeringDeg * inputOf(_inputs, FlightInput::rudder);
    }
    const bool isRunning = _status.condition == VehicleCondition::sound && _state.engineRadps > 0.0;
    parts.hasNavigationLights = parts.hasStrobes = parts.hasBeacon = parts.hasLandingLight = isRunning;
    entity.aircraft = parts;
    entity.wheelRotationDeg = parts.wheelTurnDeg[kLeftLeg];
    entity.steeringDeg = parts.noseSteeringDeg;
    entity.isOnGround = _isOnGround;
    const AirSample& air = _surroundings.air;
    const glm::dvec3 through =
        glm::conjugate(_state.motion.attitude) * (_state.motion.velocity - air.windMps);
    writeAirspeed(glm::length(through - _surroundings.gust), air, entity);
}

} // namespace simulation
