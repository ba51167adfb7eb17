// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/Autopilot.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

constexpr double kFlapsPerS = 0.25;

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
