// SPDX-License-Identifier: Apache-2.0
// Where an aircraft of JSBSim begins, and what it has: JSBSim is asked once before it flies.
#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/StartCheck.h"
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"

namespace simulation
{
namespace
{

constexpr double kInchM = 0.0254;
constexpr int kMostFeet = 24;
constexpr int kMostEngines = 8;
constexpr double kSettleS = 15.0; ///< in which an aircraft stands still on its wheels
constexpr double kStillMps = 1e-3;
constexpr double kAboveM = 0.05; ///< over the ground, from where it is let down

/// Inputs and the properties that they set; those of engines stand for each of them.
struct KnownLink
{
    FlightInput input;
    double factor;
    const char* property;
    bool isOfEngine = false;
};

constexpr std::array<KnownLink, 14> kLinks{{{FlightInput::elevator, 1.0, "fcs/elevator-cmd-norm"},
                                            {FlightInput::aileron, 1.0, "fcs/aileron-cmd-norm"},
                                            {FlightInput::rudder, 1.0, "fcs/rudder-cmd-norm"},
                                            {FlightInput::rudder, -1.0, "fcs/steer-cmd-norm"},
                                            {FlightInput::elevatorTrim, 1.0, "fcs/pitch-trim-cmd-norm"},
                                            {FlightInput::aileronTrim, 1.0, "fcs/roll-trim-cmd-norm"},
                                            {FlightInput::rudderTrim, 1.0, "fcs/yaw-trim-cmd-norm"},
                                            {FlightInput::flaps, 1.0, "fcs/flap-cmd-norm"},
                                            {FlightInput::throttle, 1.0, "fcs/throttle-cmd-norm", true},
                                            {FlightInput::mixture, 1.0, "fcs/mixture-cmd-norm", true},
                                            {FlightInput::leftBrake, 1.0, "fcs/left-brake-cmd-norm"},
                                            {FlightInput::rightBrake, 1.0, "fcs/right-brake-cmd-norm"},
                                            {FlightInput::starter, 1.0, "propulsion/starter_cmd"},
                                            {FlightInput::ignition, 3.0, "propulsion/magneto_cmd"}}};

std::string numbered(const std::string& property, int index)
{
    return index == 0 ? property : property + "[" + std::to_string(index) + "]";
}

std::string footUnit(int index, bool isWheel)
{
    return (isWheel ? "gear/" : "contact/") + numbered("unit", index) + "/";
}

/// All that is asked of an aircraft before it flies.
std::vector<std::string> questionsOf(const JsbsimData& data)
{
    std::vector<std::string> all{
        "propulsion/cutoff_cmd", "propulsion/set-running", "atmosphere/wind-north-fps",
        "metrics/bw-ft",         "inertia/cg-x-in",        "inertia/cg-y-in",
        "inertia/cg-z-in"};
    for (const KnownLink& known : kLinks)
        for (int engine = 0; engine < (known.isOfEngine ? kMostEngines : 1); ++engine)
            all.push_back(numbered(known.property, engine));
    for (const JsbsimInput& input : data.inputs)
        all.push_back(input.property);
    for (int i = 0; i < kMostFeet; ++i)
        for (const bool isWheel : {true, false})
            for (const char* axis : {"x-position", "y-position", "z-position"})
                all.push_back(footUnit(i, isWheel) + axis);
    return all;
}

} // namespace

/// Keeps the links whose properties the aircraft has, and what starts its engines.
void JsbsimVehicle::linkInputs()
{
    _links.clear();
    _settings.clear();
    for (const KnownLink& known : kLinks)
        for (int engine = 0; engine < (known.isOfEngine ? kMostEngines : 1); ++engine)
        {
            const std::string property = numbered(known.property, engine);
            if (!_process->value(property)) break;
            _links.push_back({static_cast<std::size_t>(known.input), known.factor, property});
            if (known.input == FlightInput::mixture || known.input == FlightInput::ignition)
                _settings.emplace_back(property, known.factor);
        }
    for (std::size_t i = 0; i < _data->inputs.size(); ++i)
        if (_process->value(_data->inputs[i].property))
            _links.push_back({kFlightInputCount + i, 1.0, _data->inputs[i].property});
    if (_process->value("propulsion/cutoff_cmd")) _settings.emplace_back("propulsion/cutoff_cmd", 0.0);
    if (_process->value("propulsion/set-running")) _settings.emplace_back("propulsion/set-running", -1.0);
    _hasWind = _process->value("atmosphere/wind-north-fps").has_value();
}

/// Where wheels and structure may touch the ground.
void JsbsimVehicle::examineFeet()
{
    _feet.clear();
    const auto place = [&](const std::string& x, const std::string& y, const std::string& z) {
        return std::array{_process->value(x), _process->value(y), _process->value(z)};
    };
    const auto centre = place("inertia/cg-x-in", "inertia/cg-y-in", "inertia/cg-z-in");
    for (int i = 0; i < kMostFeet; ++i)
        for (const bool isWheel : {true, false})
        {
            const std::string unit = footUnit(i, isWheel);
            if (!_process->value(unit + "x-position")) continue;
            const auto at = place(unit + "x-position", unit + "y-position", unit + "z-position");
            if (!at[1] || !at[2] || !centre[0] || !centre[1] || !centre[2]) continue;
            // Structural axes: x aft, y right, z up.
            _feet.push_back(
                {kInchM * glm::dvec3(*centre[0] - *at[0], *centre[1] - *at[1], *at[2] - *centre[2]),
                 isWheel});
        }
    _wingSpanM = kJsbsimFootM * _process->value("metrics/bw-ft").value_or(10.0 / kJsbsimFootM);
    if (!(_wingSpanM > 0.1)) _wingSpanM = 10.0;
}

/// The axle of the main wheels: those beside the middle, else the rearmost; without wheels the lowest point
/// of the structure.
void JsbsimVehicle::findReference()
{
    constexpr double kMiddleM = 0.1;
    glm::dvec3 sum(0.0);
    double count = 0.0, lowest = 0.0;
    for (const Foot& foot : _feet)
    {
        lowest = std::min(lowest, foot.place.z);
        if (!foot.isWheel || std::abs(foot.place.y) < kMiddleM) continue;
        sum += foot.place;
        count += 1.0;
    }
    _reference = count > 0.0 ? glm::dvec3(sum.x / count, 0.0, sum.z / count) : glm::dvec3(0.0, 0.0, lowest);
}

/// The inputs as JSBSim has them after its start; they are not sent again until they change.
void JsbsimVehicle::takeInputs()
{
    std::vector<bool> isTaken(_inputs.size(), false);
    std::fill(_inputs.begin(), _inputs.end(), 0.0);
    for (Link& link : _links)
    {
        const double value = _process->value(link.property).value_or(0.0);
        if (!isTaken[link.input]) _inputs[link.input] = value / link.factor;
        isTaken[link.input] = true;
        link.sent = _inputs[link.input] * link.factor;
    }
}

/// A JSBSim at a place, before anything is known of the aircraft.
foundation::Outcome JsbsimVehicle::examine(JsbsimStart start)
{
    start.velocityMps = glm::dvec3(0.0);
    start.isTrimmed = false;
    start.asked = questionsOf(*_data);
    auto process = JsbsimProcess::start(*_data, start);
    if (!process) return process.error();
    _process = std::move(*process);
    linkInputs();
    examineFeet();
    findReference();
    return foundation::success();
}

JsbsimStart JsbsimVehicle::startAt(const VehicleStart& start, const glm::dvec3& position,
                                   double groundM) const
{
    const EarthFrame::Place place = _earth->placeAt(position);
    const glm::dvec3 along(std::cos(start.headingRad), std::sin(start.headingRad), 0.0);
    JsbsimStart begin;
    begin.latitudeDeg = place.geodetic.latitudeDeg;
    begin.longitudeDeg = place.geodetic.longitudeDeg;
    begin.heightM = place.geodetic.heightM;
    begin.terrainM = begin.heightM - (position.z - groundM);
    const glm::dvec3 east = glm::cross(place.north, place.up);
    begin.headingDeg = foundation::degreesOf(std::atan2(glm::dot(along, east), glm::dot(along, place.north)));
    begin.velocityMps = start.speedMps * glm::dvec3(glm::dot(along, place.north), glm::dot(along, east), 0.0);
    return begin;
}

/// Takes the first row as the state at the time 0.
void JsbsimVehicle::enter(const glm::dvec3& position)
{
    takeInputs();
    _row = _process->row();
    _frame.emplace(_row, isJsbsimGeodetic(_row), *_earth, position);
    _state = _frame->stateOf(_row);
    _state.timeS = 0.0;
    _step = 0;
    _status = {};
    _turbulence = DrydenTurbulence(_seed);
    _propellerDeg = _wheelDeg = _sentTerrainM = 0.0;
}

foundation::Outcome JsbsimVehicle::beginInAir(const VehicleStart& start, const GroundPoint& below,
                                              const Air& air)
{
    if (const auto free = checkFlyingStart(start, below); !free) return free;
    const EarthFrame::Place place = _earth->placeAt(start.position);
    JsbsimStart begin = startAt(start, start.position,
                                below.isKnown ? below.heightM : start.position.z - place.geodetic.heightM);
    if (const auto examined = examine(begin); !examined) return examined;
    _aroundIt = air.at(start.position, place.geodetic.heightM, 0.0);
    const glm::dvec3 wind = _aroundIt.windMps;
    const glm::dvec3 east = glm::cross(place.north, place.up);
    begin.windMps = {glm::dot(wind, place.north), glm::dot(wind, east), 0.0};
    const glm::dvec3 through = begin.velocityMps - begin.windMps;
    begin.headingDeg = foundation::degreesOf(std::atan2(through.y, through.x));
    begin.settings = _settings;
    for (const Link& link : _links)
        begin.asked.push_back(link.property);
    begin.isTrimmed = true;
    auto process = JsbsimProcess::start(*_data, begin);
    if (!process)
    {
        begin.isTrimmed = false;
        const std::string reason = process.error().what;
        process = JsbsimProcess::start(*_data, begin);
        if (!process) return process.error();
        _note = "JSBSim finds no steady flight at the start (" + reason + "); the aircraft begins level";
    }
    _process = std::move(*process);
    enter(start.position);
    _sentWind = _frame->northEastDown(_row, wind);
    return foundation::success();
}

foundation::Outcome JsbsimVehicle::beginOnGround(const VehicleStart& start, const GroundPoint& below)
{
    if (const auto free = checkStandingStart(start, below); !free) return free;
    glm::dvec3 position = glm::dvec3(glm::dvec2(start.position), below.heightM);
    JsbsimStart begin = startAt(start, position, below.heightM);
    begin.heightM += 10.0;
    if (const auto examined = examine(begin); !examined) return examined;
    // Let down from just above the ground until it stands.
    begin.heightM += kAboveM - _reference.z - 10.0;
    const glm::dvec3 rolling = begin.velocityMps;
    begin.velocityMps = glm::dvec3(0.0);
    begin.settings = _settings;
    for (const Link& link : _links)
        begin.asked.push_back(link.property);
    for (const double speedMps : {0.0, start.speedMps})
    {
        if (speedMps != 0.0) begin.velocityMps = rolling;
        auto process = JsbsimProcess::start(*_data, begin);
        if (!process) return process.error();
        _process = std::move(*process);
        if (speedMps != 0.0) break;
        std::string brakes;
        for (const Link& link : _links)
            if (link.input == static_cast<std::size_t>(FlightInput::leftBrake) ||
                link.input == static_cast<std::size_t>(FlightInput::rightBrake))
                brakes += "set " + link.property + " 1\n";
        for (int i = 0; i < static_cast<int>(kSettleS / kStepS); ++i)
        {
            if (_process->advance(i == 0 ? brakes : std::string()) != JsbsimFault::none)
                return noStart(start, "JSBSim cannot let the aircraft down there", "begin in the air");
            const JsbsimRow& row = _process->row();
            const double speedFps = std::abs(row[JsbsimColumn::velocityNorth]) +
                                    std::abs(row[JsbsimColumn::velocityEast]) +
                                    std::abs(row[JsbsimColumn::velocityDown]);
            if (i > 120 && kJsbsimFootM * speedFps < kStillMps) break;
        }
        begin.heightM = kJsbsimFootM * _process->row()[JsbsimColumn::height];
        begin.pitchDeg = foundation::degreesOf(_process->row()[JsbsimColumn::pitch]);
        if (start.speedMps == 0.0) break;
    }
    // The reference point stands where the start says.
    const double pitch = foundation::radiansOf(begin.pitchDeg);
    const double aheadM = -(_reference.x * std::cos(pitch) - _reference.z * std::sin(pitch));
    position += aheadM * glm::dvec3(std::cos(start.headingRad), std::sin(start.headingRad), 0.0);
    position.z = below.heightM + begin.heightM - begin.terrainM;
    enter(position);
    _state.isOnGround = true;
    return foundation::success();
}

foundation::Outcome JsbsimVehicle::begin(const VehicleStart& start, const Ground& ground, const Air& air)
{
    _note.clear();
    ground.below({&start.position, 1}, {&_below, 1});
    const auto begun = start.isInAir ? beginInAir(start, _below, air) : beginOnGround(start, _below);
    if (!begun)
    {
        _process.reset();
        if (_status.condition == VehicleCondition::sound)
            _status = {VehicleCondition::failed, "JSBSim could not begin"};
    }
    return begun;
}

} // namespace simulation
