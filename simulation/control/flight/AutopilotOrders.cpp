// SPDX-License-Identifier: Apache-2.0
// How an autopilot goes through its orders, and which it refuses.
#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/control/flight/Autopilot.h"
#include "simulation/control/flight/RunwayClearance.h"

namespace simulation
{

namespace
{

constexpr double kReachedM = 10.0; ///< of an altitude that counts as reached

} // namespace

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

} // namespace simulation
