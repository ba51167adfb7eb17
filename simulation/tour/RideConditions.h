// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace simulation
{

/// What falls from the sky over a ride, and what hangs in it.
enum class RideWeather
{
    clear,
    fog,
    rain, ///< on wet roads
    snow  ///< that covers the roads
};

/// Under which sky somebody rides.
struct RideConditions
{
    /// 0…24, mean solar time of the place on the longest day; absent: one that shows relief well
    std::optional<double> solarHour;
    RideWeather weather = RideWeather::clear;
    /// those of the world, unless hour or weather say otherwise
    bool keepsSun = false, keepsVisibility = false, keepsClouds = false;
};

} // namespace simulation
