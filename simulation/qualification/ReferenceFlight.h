// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace simulation
{

/// What a recorded flight has of each instant. SI units and radians.
enum class FlightChannel
{
    time,
    latitudeDeg,
    longitudeDeg,
    height,
    roll,
    pitch,
    heading, ///< without jumps at north
    airspeed,
    climb,
    alpha,
    beta,
    rollRate,
    pitchRate,
    yawRate,
    loadFactor,
    elevator, ///< command with trim, -1…1, as FlightInput has it
    aileron,
    rudder,
    flaps,
    throttle,
    rpm,
    thrust,
    mass,
    count
};

inline constexpr std::size_t kFlightChannelCount = static_cast<std::size_t>(FlightChannel::count);

inline constexpr std::array<std::string_view, kFlightChannelCount> kFlightChannelNames{
    "time",    "latitude", "longitude", "height",    "roll",       "pitch",    "heading",     "airspeed",
    "climb",   "alpha",    "beta",      "roll rate", "pitch rate", "yaw rate", "load factor", "elevator",
    "aileron", "rudder",   "flaps",     "throttle",  "rpm",        "thrust",   "mass"};

/// One instant of a flight.
struct FlightRow
{
    std::array<double, kFlightChannelCount> values{};

    double& operator[](FlightChannel channel) { return values[static_cast<std::size_t>(channel)]; }
    double operator[](FlightChannel channel) const { return values[static_cast<std::size_t>(channel)]; }
};

using Flight = std::vector<FlightRow>;

/// Reads a flight that JSBSim has logged as CSV, gzip or not, with the captions of the real-data folder's
/// track_directive.xml. The first row, before its trim, is left out.
/// Errors: those of the file; a caption that is wanting; a row with another number of fields, or one that is
/// no number.
foundation::Result<Flight> readReferenceFlight(const std::filesystem::path& file);

/// Takes the jumps of full turns out of headings.
void unwindHeadings(Flight& flight);

} // namespace simulation
