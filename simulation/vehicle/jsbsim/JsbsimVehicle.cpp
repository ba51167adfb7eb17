// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/Airspeeds.h"

namespace simulation
{
namespace
{

constexpr double kFastestFlownMps = 3000.0; ///< faster is a leap
constexpr double kFarthestFlownM = 2e7;     ///< from the scene's origin
constexpr double kCrashesAtMps = 5.0;       ///< with the structure on the ground
constexpr double kTouchM = 0.02;            ///< of the structure, above the ground

std::string order(const std::string& property, double value)
{
    return "set " + property + " " + jsbsimNumber(value) + "\n";
}

} // namespace

JsbsimVehicle::JsbsimVehicle(std::shared_ptr<const JsbsimData> data, std::shared_ptr<const EarthFrame> earth,
                             std::uint64_t seed)
    : _data(std::move(data)),
      _earth(std::move(earth)),
      _seed(seed),
      _names(kFlightInputNames.begin(), kFlightInputNames.end()),
      _turbulence(seed)
{
    for (const JsbsimInput& input : _data->inputs)
        _names.push_back(input.name);
    _inputs.assign(_names.size(), 0.0);
}

/// What JSBSim is told before a step.
std::string JsbsimVehicle::orders(const Ground& ground, const Air& air)
{
    // JSBSim has moved on when it gets this.
    const glm::dvec3 next = _state.position + kStepS * _state.velocity;
    ground.below({&next, 1}, {&_below, 1});
    const double heightM = _earth->placeAt(_state.position).geodetic.heightM;
    const double aboveM = _below.isKnown ? _state.position.z - _below.heightM : heightM;
    std::string text;
    const double terrainM = kJsbsimFootM * _row[JsbsimColumn::height] - aboveM;
    if (terrainM != _sentTerrainM)
        text += order("position/terrain-elevation-asl-ft", terrainM / kJsbsimFootM);
    _sentTerrainM = terrainM;

    const AirSample sample = air.at(_state.position, heightM, _state.timeS);
    glm::dvec3 wind = sample.windMps;
    if (sample.windAtSixMetresMps > 0.0 || sample.gustDeviationMps > 0.0)
    {
        _turbulence.step({glm::length(_state.velocity - wind), aboveM, sample.windAtSixMetresMps,
                          sample.gustDeviationMps, _wingSpanM},
                         kStepS);
        const glm::dvec3& gust = _turbulence.velocity(); // forward, right, down
        wind += _state.bodyToScene * glm::dvec3(gust.x, -gust.y, -gust.z);
    }
    _aroundIt = sample;
    _aroundIt.windMps = wind;
    const glm::dvec3 level = _frame->northEastDown(_row, wind);
    if (_hasWind && level != _sentWind)
        text += order("atmosphere/wind-north-fps", level.x / kJsbsimFootM) +
                order("atmosphere/wind-east-fps", level.y / kJsbsimFootM) +
                order("atmosphere/wind-down-fps", level.z / kJsbsimFootM);
    _sentWind = level;

    const bool isSound = _status.condition == VehicleCondition::sound;
    for (Link& link : _links)
    {
        double value = _inputs[link.input];
        if (link.input < kFlightInputCount)
        {
            FlightInputs flight;
            std::copy_n(_inputs.begin(), kFlightInputCount, flight.begin());
            const auto which = static_cast<FlightInput>(link.input);
            value = inputOf(flight, which);
            if (!isSound && (which == FlightInput::throttle || which == FlightInput::mixture)) value = 0.0;
        }
        value *= link.factor;
        if (!std::isfinite(value)) value = 0.0;
        if (value != link.sent) text += order(link.property, value);
        link.sent = value;
    }
    return text;
}

void JsbsimVehicle::step(const Ground& ground, const Air& air)
{
    ++_step;
    const double timeS = static_cast<double>(_step) * kStepS;
    if (!_process)
    {
        _state.timeS = timeS;
        return;
    }
    const JsbsimFault fault = _process->advance(orders(ground, air));
    if (fault == JsbsimFault::none)
        take(ground);
    else
        fail(fault);
    _state.timeS = timeS;
}

/// Takes the row of a step, unless it leaps.
void JsbsimVehicle::take(const Ground& /*ground*/)
{
    const JsbsimRow& row = _process->row();
    const VehicleState next = _frame->stateOf(row);
    constexpr double kFartherM = 1.0; // than both velocities would carry it
    const double mostM = kStepS * (glm::length(next.velocity) + glm::length(_state.velocity)) + kFartherM;
    if (glm::length(next.velocity) > kFastestFlownMps || glm::length(next.position) > kFarthestFlownM ||
        glm::distance(next.position, _state.position) > mostM)
        return fail("JSBSim's motion leaps");
    _row = row;
    _state = next;
    const double turned = kStepS * _row[JsbsimColumn::propellerRpm] * 6.0;
    _propellerDeg = std::fmod(_propellerDeg + turned, 360.0);
    constexpr double kWheelRadiusM = 0.2; // JSBSim has none
    const glm::dvec3 forward = _state.bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
    _state.isOnGround =
        row[JsbsimColumn::noseWheel] + row[JsbsimColumn::leftWheel] + row[JsbsimColumn::rightWheel] > 0.5;
    if (_state.isOnGround)
        _wheelDeg = std::fmod(
            _wheelDeg + foundation::degreesOf(kStepS * glm::dot(_state.velocity, forward) / kWheelRadiusM) +
                360.0,
            360.0);
    judgeContacts();
}

/// Notices whether more than wheels touches the ground fast, and water. A wreck lies on the ground by any
/// part.
void JsbsimVehicle::judgeContacts()
{
    if (_status.condition == VehicleCondition::crashed && _below.isKnown)
        for (const Foot& foot : _feet)
            if ((_state.position + _state.bodyToScene * foot.place).z < _below.heightM + kTouchM)
                _state.isOnGround = true;
    if (_status.condition != VehicleCondition::sound || !_below.isKnown) return;
    if (_state.isOnGround && _below.kind == GroundKind::water)
        _status = {VehicleCondition::crashed, "it came down on water"};
    if (glm::length(_state.velocity) < kCrashesAtMps) return;
    for (const Foot& foot : _feet)
        if (!foot.isWheel && (_state.position + _state.bodyToScene * foot.place).z < _below.heightM + kTouchM)
            _status = {VehicleCondition::crashed, "it hit the ground"};
}

void JsbsimVehicle::fail(JsbsimFault fault)
{
    switch (fault)
    {
    case JsbsimFault::late:
        return fail("JSBSim did not answer in time");
    case JsbsimFault::ended:
        return fail("JSBSim ended");
    case JsbsimFault::notFinite:
        return fail("JSBSim's motion cannot be computed any further");
    case JsbsimFault::outOfStep:
        return fail("JSBSim's clock is out of step");
    default:
        return fail("JSBSim answered what cannot be read");
    }
}

/// It stands still at the last good state; the process is ended.
void JsbsimVehicle::fail(std::string_view reason)
{
    _status = {VehicleCondition::failed, reason};
    _state.velocity = _state.bodyRates = glm::dvec3(0.0);
    _process.reset();
}

void JsbsimVehicle::writeParts(EntityState& entity) const
{
    AircraftParts parts;
    const auto degrees = [&](JsbsimColumn column) { return foundation::degreesOf(_row[column]); };
    parts.elevatorDeg = degrees(JsbsimColumn::elevator);
    parts.leftAileronDeg = degrees(JsbsimColumn::leftAileron);
    parts.rightAileronDeg = degrees(JsbsimColumn::rightAileron);
    parts.rudderDeg = degrees(JsbsimColumn::rudder);
    parts.flapDeg = _row[JsbsimColumn::flapDeg];
    parts.propellerTurnDeg = _propellerDeg;
    parts.propellerRadps = foundation::radiansOf(6.0 * _row[JsbsimColumn::propellerRpm]);
    const std::array<JsbsimColumn, kGearLegs> struts{JsbsimColumn::noseStrut, JsbsimColumn::leftStrut,
                                                     JsbsimColumn::rightStrut};
    std::size_t leg = 0;
    for (const Foot& foot : _feet)
    {
        if (!foot.isWheel || leg >= kGearLegs) continue;
        parts.wheelBottom[leg] = foot.place - _reference;
        parts.strutM[leg] = std::max(0.0, kJsbsimFootM * _row[struts[leg]]);
        parts.wheelTurnDeg[leg] = _wheelDeg;
        ++leg;
    }
    const bool isRunning = _status.condition == VehicleCondition::sound && _process;
    parts.hasNavigationLights = parts.hasStrobes = parts.hasBeacon = parts.hasLandingLight = isRunning;
    entity.aircraft = parts;
    entity.wheelRotationDeg = _wheelDeg;
    entity.isOnGround = _state.isOnGround;
    writeAirspeed(glm::length(_state.velocity - _aroundIt.windMps), _aroundIt, entity);
}

} // namespace simulation
