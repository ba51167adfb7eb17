// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace scenery::models
{

/// What the instruments of a cockpit or a car show. Units as named; angles in degrees.
enum class Reading
{
    airspeedKt,
    pitchDeg, ///< nose up
    rollDeg,  ///< right side down
    altitudeFt,
    altimeterHpa, ///< to which the altimeter is set
    turnDegps,    ///< to the right
    slip,         ///< of the ball, to the right: share of 0.1 g
    headingDeg,   ///< from north, clockwise
    climbFpm,
    engineRpm,
    fuelLeft,  ///< share of the tank
    fuelRight, ///< share of the tank
    flapDeg,
    trim, ///< -1 nose down, 1 nose up
    propellerRadps,
    propellerTurnDeg,
    speedKmh,
    gear,             ///< -1 reverse, 0 neutral
    fuel,             ///< share of the tank
    steeringWheelDeg, ///< to the left
    indicatorLeft,    ///< 1: its lamp shines now; so the following ones
    indicatorRight,
    headLamps,
    handbrake,
    count
};

/// A value of each reading.
class Readings
{
public:
    double& operator[](Reading reading) { return _values[static_cast<std::size_t>(reading)]; }
    double operator[](Reading reading) const { return _values[static_cast<std::size_t>(reading)]; }

private:
    std::array<double, static_cast<std::size_t>(Reading::count)> _values{};
};

} // namespace scenery::models
