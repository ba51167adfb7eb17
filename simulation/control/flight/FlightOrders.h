// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace simulation
{

/// What an autopilot can be told, one thing after the other.
enum class FlightOrderKind
{
    heading,       ///< degrees from north, clockwise; holds from now on
    altitude,      ///< metres above the ellipsoid; holds from now on
    speed,         ///< calibrated, m/s; holds from now on
    verticalSpeed, ///< the fastest change of altitude, m/s
    climb,         ///< to an altitude at full power, or down to it at idle; lasts until it is reached
    wait,          ///< seconds
    takeOff,       ///< from the runway, until 150 m above it
    circuit,       ///< around the runway, until it is on the base leg's end
    land           ///< on the runway, until it stands
};

struct FlightOrder
{
    FlightOrderKind kind = FlightOrderKind::wait;
    double value = 0.0; ///< of those that have one

    bool operator==(const FlightOrder&) const = default;
};

/// Whether orders ask for a runway.
bool needsRunway(const std::vector<FlightOrder>& orders);

/// Reads orders: words parted by semicolons, `takeoff; heading 240; altitude 500; speed 45; wait 30; circuit;
/// land`.
/// Errors: an unknown word, a number that is missing or out of range, no order, more than 1000. `name` stands
/// before the error.
foundation::Result<std::vector<FlightOrder>> parseFlightOrders(std::string_view text,
                                                               const std::string& name);

} // namespace simulation
