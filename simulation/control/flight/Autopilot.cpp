// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/Autopilot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

#include "simulation/control/flight/RunwayClearance.h"

namespace simulation
{
namespace
{

constexpr double kHoldBank = 0.42; ///< 24°
constexpr double kReachedM = 10.0; ///< of an altitude that counts as reached
constexpr double kFlapsPerS = 0.25;
constexpr double kClimbSpeedMps = 38.0;

int placeOf(const DynamicVehicle& vehicle, std::string_view name)
{
    const std::span<const std::string_view> names = vehicle.inputNames();
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

void writeInput(std::span<double> inputs, int place, double value)
{
    if (place >= 0) inputs[static_cast<std::size_t>(place)] = value;
}

} // namespace

foundation::Result<Autopilot> Autopilot::create(AutopilotSettings settings, const DynamicVehicle& vehicle)
{
    Places places;
    const std::array<std::pair<std::string_view, int*>, 9> wanted{{{"elevator", &places.elevator},
                                                                   {"aileron", &places.aileron},
                                                                   {"rudder", &places.rudder},
                                                                   {"throttle", &places.throttle},
                                                                   {"flaps", &places.flaps},
                                                                   {"mixture", &places.mixture},
                                                                   {"left_brake", &places.leftBrake},
                                                                   {"right_brake", &places.rightBrake},
                                                                   {"ignition", &places.ignition}}};
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        *wanted[i].second = placeOf(vehicle, wanted[i].first);
        if (i < 4 && *wanted[i].second < 0)
            return foundation::Error{"autopilot", "the vehicle has no input " + std::string(wanted[i].first),
                                     "give the autopilot to an aircraft"};
    }
    if (needsRunway(settings.orders) && !settings.runway)
        return foundation::Error{"autopilot", "there is no runway to take off from or land on",
                                 "give one, or leave takeoff, circuit and land out of the orders"};
    return Autopilot(std::move(settings), places, -vehicle.referencePoint().z, vehicle.stepSeconds());
}

Autopilot::Autopilot(AutopilotSettings settings, const Places& places, double wheelsBelowM, double stepS)
    : _settings(std::move(settings)), _places(places), _wheelsBelowM(wheelsBelowM), _stepS(stepS)
{
}

void Autopilot::control(const ControlView& view, std::span<double> inputs)
{
    const FlightSense sense = senseOf(view, *_settings.earth, _wheelsBelowM);
    if (view.step == 0)
    {
        holdWhatIs(sense);
        _last.throttle = inputs[static_cast<std::size_t>(_places.throttle)];
        _last.flaps = _places.flaps >= 0 ? inputs[static_cast<std::size_t>(_places.flaps)] : 0.0;
        _climb.reset(sense, _last.throttle);
    }
    takeOrders(sense, view);
    constexpr double kLeastMps = 10.0;
    if (_askedMps && sense.trueAirspeedMps > kLeastMps)
        _speedMps = *_askedMps * sense.calibratedAirspeedMps / sense.trueAirspeedMps;
    lookAhead(sense, view);
    FlightCommand command = fly(sense);
    command.flaps =
        _last.flaps + std::clamp(command.flaps - _last.flaps, -kFlapsPerS * _stepS, kFlapsPerS * _stepS);
    write(command, inputs);
    _last = command;
}

void Autopilot::holdWhatIs(const FlightSense& sense)
{
    _heading = sense.heading;
    _altitudeM = sense.altitudeM;
    _speedMps = sense.calibratedAirspeedMps;
}

void Autopilot::resume(const ControlView& view, std::span<const double> inputs)
{
    const FlightSense sense = senseOf(view, *_settings.earth, _wheelsBelowM);
    const auto input = [&](int place) { return place < 0 ? 0.0 : inputs[static_cast<std::size_t>(place)]; };
    _last.throttle = input(_places.throttle);
    _last.flaps = input(_places.flaps);
    _last.surfaces = {input(_places.elevator), input(_places.aileron), input(_places.rudder)};
    _climb.reset(sense, _last.throttle);
    _attitude.reset(_last.surfaces.elevator);
    if (_landing) _landing->begin(sense, _last.throttle, _last.surfaces.elevator);
    const auto& orders = _settings.orders;
    const bool hasTargets =
        std::any_of(orders.begin(), orders.end(),
                    [](const FlightOrder& order)
                    { return order.kind < FlightOrderKind::takeOff && order.kind != FlightOrderKind::wait; });
    if (!hasTargets) holdWhatIs(sense);
}

void Autopilot::takeOrders(const FlightSense& sense, const ControlView& view)
{
    while (_order < _settings.orders.size())
    {
        const FlightOrder& order = _settings.orders[_order];
        if (!_hasBegun) beginOrder(order, sense, view);
        if (!isOrderDone(order, sense, view.timeS)) return;
        _hasBegun = false;
        _isClimbing = false;
        ++_order;
    }
}

/// Refuses the order where the ground is so far above the way that clears it.
bool Autopilot::isFree(double aboveM, const std::string& what)
{
    _isRefused = _settings.avoidsGround && aboveM > 0.0;
    if (_isRefused) _note = what + std::to_string(std::max(1L, std::lround(aboveM))) + " m too high";
    return !_isRefused;
}

void Autopilot::beginTakeOff(const Ground& ground)
{
    _takeOff.emplace(*_settings.runway);
    isFree(aboveClimbOutM(*_settings.runway, ground),
           "refused to take off: the ground beyond the runway is ");
}

void Autopilot::beginLanding(const FlightSense& sense, const Ground& ground)
{
    const RunwayStrip& runway = *_settings.runway;
    if (!isFree(aboveFinalM(runway, ground, -runway.centreLine().alongM(sense.position)),
                "refused to land: the ground before the runway is "))
        return;
    _landing.emplace(runway);
    _landing->begin(sense, _last.throttle, _last.surfaces.elevator);
}

void Autopilot::beginCircuit(const Ground& ground)
{
    if (_settings.avoidsGround)
        _circuit.emplace(*_settings.runway, ground);
    else
        _circuit.emplace(*_settings.runway);
    if (_circuit->isRightHanded() && _note.empty())
        _note = "flew a right-handed circuit, since the ground on the left is too high";
}

void Autopilot::beginOrder(const FlightOrder& order, const FlightSense& sense, const ControlView& view)
{
    _hasBegun = true;
    _orderStartS = view.timeS;
    _phase = "hold";
    if (order.kind >= FlightOrderKind::takeOff || order.kind == FlightOrderKind::climb)
    {
        // Surfaces and power go on from what the last command had.
        _climb.reset(sense, _last.throttle);
        _attitude.reset(_last.surfaces.elevator);
    }
    switch (order.kind)
    {
    case FlightOrderKind::heading:
        _heading = foundation::radiansOf(order.value);
        break;
    case FlightOrderKind::altitude:
        _altitudeM = order.value;
        break;
    case FlightOrderKind::speed:
        _speedMps = order.value;
        _askedMps.reset();
        break;
    case FlightOrderKind::verticalSpeed:
        _climbMps = order.value;
        break;
    case FlightOrderKind::climb:
        _altitudeM = order.value;
        _isClimbing = true;
        break;
    case FlightOrderKind::wait:
        break;
    case FlightOrderKind::takeOff:
        beginTakeOff(view.ground);
        break;
    case FlightOrderKind::circuit:
        beginCircuit(view.ground);
        break;
    case FlightOrderKind::land:
        beginLanding(sense, view.ground);
        break;
    }
}

bool Autopilot::isOrderDone(const FlightOrder& order, const FlightSense& sense, double timeS) const
{
    switch (order.kind)
    {
    case FlightOrderKind::climb:
        return std::abs(sense.altitudeM - order.value) < kReachedM;
    case FlightOrderKind::wait:
        return timeS >= _orderStartS + order.value - 1e-9;
    case FlightOrderKind::takeOff:
        return _takeOff->isDone();
    case FlightOrderKind::circuit:
        return _circuit->isDone();
    case FlightOrderKind::land:
        return _landing && _landing->isDone();
    default:
        return true;
    }
}

FlightCommand Autopilot::fly(const FlightSense& sense)
{
    const FlightOrderKind kind =
        _order < _settings.orders.size() ? _settings.orders[_order].kind : FlightOrderKind::wait;
    if (kind == FlightOrderKind::takeOff && _isRefused)
    {
        _phase = "refused";
        FlightCommand stands;
        stands.brakes = 1.0;
        return stands;
    }
    if (kind == FlightOrderKind::takeOff)
    {
        const FlightCommand command = _takeOff->step(sense, _stepS);
        _phase = _takeOff->phase();
        // What holds after the take-off.
        _heading = sense.heading;
        _altitudeM = sense.altitudeM;
        _speedMps = kClimbSpeedMps;
        return command;
    }
    if (kind == FlightOrderKind::circuit) return flyCircuit(sense);
    if (_landing && (kind == FlightOrderKind::land || _landing->isDone()))
    {
        const FlightCommand command = _landing->step(sense, _stepS);
        _phase = _landing->phase();
        return command;
    }
    return holdTargets(sense);
}

/// Whether it takes off, lands or stands.
bool Autopilot::isNearGround() const
{
    if (_landing) return true;
    return _order < _settings.orders.size() && _settings.orders[_order].kind == FlightOrderKind::takeOff;
}

void Autopilot::lookAhead(const FlightSense& sense, const ControlView& view)
{
    const bool wasAvoiding = _isAvoiding;
    _isAvoiding =
        _settings.avoidsGround && !isNearGround() && _guard.look(sense, view.ground, view.timeS).isUrgent();
    if (_isAvoiding == wasAvoiding) return;
    _climb.reset(sense, _last.throttle);
    if (!_note.empty()) return;
    char text[80];
    std::snprintf(text, sizeof text, "left its orders after %.1f s: the ground ahead is too high",
                  view.timeS);
    _note = text;
}

/// Climbs at full power, and turns away where that is not enough. `bank`: without such ground.
FlightCommand Autopilot::avoid(const FlightSense& sense, double bank)
{
    const TerrainAdvice& advice = _guard.advice();
    _phase = "avoid";
    const PowerAndPitch hold = _climb.holdSpeed(sense, 1.0, kClimbSpeedMps, _stepS);
    FlightCommand command;
    command.throttle = 1.0;
    if (advice.track)
        bank = bankToHeading(sense, sense.heading + halfTurn(*advice.track - sense.track), kHoldBank);
    command.surfaces = _attitude.step(sense, hold.pitch, bank, _stepS);
    return command;
}

FlightCommand Autopilot::holdTargets(const FlightSense& sense)
{
    if (_isAvoiding) return avoid(sense, bankToHeading(sense, _heading, kHoldBank));
    FlightCommand command;
    PowerAndPitch hold;
    if (_isClimbing)
    {
        _phase = "climb";
        hold = _climb.holdSpeed(sense, sense.altitudeM < _altitudeM ? 1.0 : 0.0, _speedMps, _stepS);
    }
    else
        hold = _climb.holdClimb(sense, _speedMps, climbToAltitude(sense.altitudeM, _altitudeM, _climbMps),
                                _stepS);
    command.throttle = hold.throttle;
    command.surfaces = _attitude.step(sense, hold.pitch, bankToHeading(sense, _heading, kHoldBank), _stepS);
    return command;
}

FlightCommand Autopilot::flyCircuit(const FlightSense& sense)
{
    _circuit->advance(sense);
    const CircuitPlan::Leg leg = _circuit->leg();
    if (_isAvoiding) return avoid(sense, bankToLine(sense, leg.line, kHoldBank));
    _phase = leg.name;
    FlightCommand command;
    command.flaps = leg.flaps;
    const PowerAndPitch hold = _climb.holdClimb(
        sense, leg.speedMps, climbToAltitude(sense.position.z, leg.altitudeM, _climbMps), _stepS);
    command.throttle = hold.throttle;
    command.surfaces = _attitude.step(sense, hold.pitch, bankToLine(sense, leg.line, kHoldBank), _stepS);
    _heading = sense.heading;
    _altitudeM = sense.altitudeM;
    _speedMps = leg.speedMps;
    return command;
}

void Autopilot::write(const FlightCommand& command, std::span<double> inputs) const
{
    writeInput(inputs, _places.elevator, command.surfaces.elevator);
    writeInput(inputs, _places.aileron, command.surfaces.aileron);
    writeInput(inputs, _places.rudder, command.surfaces.rudder);
    writeInput(inputs, _places.throttle, command.throttle);
    writeInput(inputs, _places.flaps, command.flaps);
    writeInput(inputs, _places.mixture, 1.0);
    writeInput(inputs, _places.ignition, 1.0);
    writeInput(inputs, _places.leftBrake, command.brakes);
    writeInput(inputs, _places.rightBrake, command.brakes);
}

} // namespace simulation
