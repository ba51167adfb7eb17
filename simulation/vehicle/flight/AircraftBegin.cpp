// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include <foundation/Angle.h>
#include <glm/gtc/quaternion.hpp>

#include "simulation/vehicle/StartCheck.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/Trim.h"

namespace simulation
{
namespace
{

constexpr double kSettleS = 8.0; ///< in which an aircraft stands still on its struts
constexpr double kStillMps = 1e-4;
constexpr double kIdleRadps = 75.0;
constexpr double kPressedM = 0.02; ///< by which the deepest strut begins pressed in

/// The attitude of body axes forward, right, down whose up is `up` and whose nose looks along a heading.
glm::dquat standingAttitude(const glm::dvec3& up, double headingRad)
{
    const glm::dvec3 along(std::cos(headingRad), std::sin(headingRad), 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(along, up));
    const glm::dvec3 forward = glm::cross(up, right);
    return glm::normalize(glm::quat_cast(glm::dmat3(forward, right, -up)));
}

void brake(Aircraft& aircraft, double value)
{
    aircraft.inputs()[static_cast<std::size_t>(FlightInput::leftBrake)] = value;
    aircraft.inputs()[static_cast<std::size_t>(FlightInput::rightBrake)] = value;
}

} // namespace

glm::dvec3 Aircraft::referencePoint() const
{
    // The axle of the main wheels: those with brakes, else the rearmost wheels.
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const ContactData& contact : _data->contacts)
        if (contact.isWheel && contact.brake != Brake::none)
        {
            sum += contact.place;
            count += 1.0;
        }
    if (count == 0.0)
        for (const ContactData& contact : _data->contacts)
            if (contact.isWheel && (count == 0.0 || contact.place.x > sum.x))
            {
                sum = contact.place;
                count = 1.0;
            }
    if (count == 0.0) sum = _data->empty.place, count = 1.0;
    const glm::dvec3 arm = bodyPlace(sum / count, massProperties(*_data, _state.fuelKg).centre);
    return {arm.x, 0.0, -arm.z};
}

foundation::Outcome Aircraft::begin(const VehicleStart& start, const Ground& ground, const Air& air)
{
    GroundPoint below;
    ground.below({&start.position, 1}, {&below, 1});
    const auto state = start.isInAir ? flyingState(start, below, air) : standingState(start, below, ground);
    if (!state) return state.error();
    place(state->state);
    std::copy(state->inputs.begin(), state->inputs.end(), _inputs.begin());
    if (_status.condition == VehicleCondition::sound) return foundation::success();
    return noStart(start, std::string(_status.reason), "move it");
}

foundation::Result<Aircraft::Beginning> Aircraft::flyingState(const VehicleStart& start,
                                                              const GroundPoint& below, const Air& air) const
{
    const double heightM = _earth->placeAt(start.position).geodetic.heightM;
    if (const auto free = checkFlyingStart(start, below); !free) return free.error();
    const AirSample sample = air.at(start.position, heightM, 0.0);
    const glm::dvec3 over(start.speedMps * std::cos(start.headingRad),
                          start.speedMps * std::sin(start.headingRad), 0.0);
    const glm::dvec3 through = over - sample.windMps;
    TrimTarget target;
    target.position = start.position;
    target.headingDeg = foundation::degreesOf(std::atan2(through.x, through.y));
    target.trueAirspeedMps = glm::length(through);
    auto flight = trim(*_data, *_earth, sample, target);
    if (!flight) return noStart(start, flight.error().what, flight.error().remedy);
    return Beginning{flight->state, flight->inputs};
}

/// Lets an aircraft down on its struts, brakes set and engine idling, until it stands still.
foundation::Result<Aircraft::Beginning>
Aircraft::standingState(const VehicleStart& start, const GroundPoint& below, const Ground& ground) const
{
    if (const auto free = checkStandingStart(start, below); !free) return free.error();
    Aircraft settled(_data, _earth);
    FlightState state = settled.flightState();
    BodyMotion& motion = state.motion;
    motion.attitude = standingAttitude(below.normal, start.headingRad);
    const glm::dvec3 reference = referencePoint();
    const glm::dvec3 body(reference.x, -reference.y, -reference.z);
    motion.position = glm::dvec3(start.position.x, start.position.y, below.heightM) - motion.attitude * body;
    motion.rates = glm::conjugate(motion.attitude) * _earth->earthRate();
    GroundContacts contacts(*_data);
    contacts.look(motion, massProperties(*_data, state.fuelKg).centre, ground);
    glm::dvec3 normal(0.0, 0.0, 1.0);
    motion.position.z += std::max(contacts.deepestM(motion, normal) - kPressedM, 0.0) / below.normal.z;
    settled.place(state);
    brake(settled, 1.0);
    settled._inputs[static_cast<std::size_t>(FlightInput::ignition)] = 0.0;
    const WeatherAir still;
    for (int i = 0; i < static_cast<int>(kSettleS / kStepS); ++i)
    {
        settled.step(ground, still);
        if (i > 60 && glm::length(settled._state.motion.velocity) < kStillMps) break;
    }
    if (settled._status.condition != VehicleCondition::sound || !settled._isOnGround)
        return noStart(start, "it cannot stand on ground so steep or rough", "move it onto level ground");
    Beginning beginning{settled._state, runningInputs()};
    glm::dvec3 along = beginning.state.motion.attitude * glm::dvec3(1.0, 0.0, 0.0);
    along -= glm::dot(along, below.normal) * below.normal;
    beginning.state.motion.velocity = start.speedMps * glm::normalize(along);
    beginning.state.motion.rates = glm::conjugate(beginning.state.motion.attitude) * _earth->earthRate();
    beginning.state.engineRadps = kIdleRadps;
    beginning.state.manifoldPa =
        steadyManifoldPa(_data->engine, 0.0, kIdleRadps, settled._surroundings.air.pressurePa);
    return beginning;
}

} // namespace simulation
