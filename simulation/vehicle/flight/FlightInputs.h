// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace simulation
{

/// The inputs of an aircraft, as places in DynamicVehicle::inputs(). Deflections -1…1, the rest 0…1.
/// Signs are those of aerodynamics: elevator and aileron push the nose down and the right wing down, the
/// rudder turns the nose left, for positive numbers.
enum class FlightInput
{
    elevator,
    aileron,
    rudder, ///< steers the nose wheel, too
    elevatorTrim,
    aileronTrim,
    rudderTrim,
    flaps,
    throttle,
    mixture,
    leftBrake,
    rightBrake,
    starter,
    ignition,
    count
};

inline constexpr std::size_t kFlightInputCount = static_cast<std::size_t>(FlightInput::count);

inline constexpr std::array<std::string_view, kFlightInputCount> kFlightInputNames{
    "elevator", "aileron", "rudder",     "elevator_trim", "aileron_trim", "rudder_trim", "flaps",
    "throttle", "mixture", "left_brake", "right_brake",   "starter",      "ignition"};

using FlightInputs = std::array<double, kFlightInputCount>;

/// Inputs of a running engine, with everything else at 0.
constexpr FlightInputs runningInputs()
{
    FlightInputs inputs{};
    inputs[static_cast<std::size_t>(FlightInput::mixture)] = 1.0;
    inputs[static_cast<std::size_t>(FlightInput::ignition)] = 1.0;
    return inputs;
}

/// One input within its range; NaN as 0.
double inputOf(const FlightInputs& inputs, FlightInput input);

/// An input and its trim, added, within -1…1.
double trimmedInputOf(const FlightInputs& inputs, FlightInput input, FlightInput trim);

} // namespace simulation
