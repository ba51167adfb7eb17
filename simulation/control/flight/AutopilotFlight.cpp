// SPDX-License-Identifier: Apache-2.0
// What an autopilot flies for an order: take-off, circuit, landing, targets that it holds, and away from the
// ground.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simulation/control/flight/Autopilot.h"

namespace simulation
{

namespace
{

constexpr double kHoldBank = 0.42; ///< 24°
constexpr double kClimbSpeedMps = 38.0;

} // namespace

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

} // namespace simulation
