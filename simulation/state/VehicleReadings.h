// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace simulation
{

/// The controls of vehicles with physics that tables of motion have, by the names of inputs files.
inline constexpr std::array<std::string_view, 14> kControlNames{
    "elevator",    "aileron",  "rudder", "elevator_trim", "flaps",  "throttle", "left_brake",
    "right_brake", "steering", "brake",  "handbrake",     "clutch", "gear",     "mixture"};

/// What a debrief asks of a vehicle with physics besides its motion; of one without, its airspeeds at most.
/// Units: those of inputs files, m/s.
struct VehicleReadings
{
    std::array<std::optional<double>, kControlNames.size()>
        controls{}; ///< of the last step; absent: it has no such input
    std::optional<double> trueAirspeedMps{}, calibratedAirspeedMps{}; ///< of aircraft
    std::optional<int> gear{};            ///< that is engaged, of a road vehicle: -1 reverse, 0 neutral
    std::string_view condition = "sound"; ///< or crashed, failed; of a text that lives as long as the program
};

} // namespace simulation
