// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/scenario/Environment.h"
#include "simulation/tour/TourTerrain.h"

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
    std::optional<double>
        solarHour; ///< 0…24, mean solar time of the place on the longest day; absent: one that shows relief well
    RideWeather weather = RideWeather::clear;
};

/// Returns the environment of a ride that begins in a direction (counter-clockwise from east), for the terrain's place; without
/// georeference for 45° N. Units: radians.
Environment rideEnvironment(const TourTerrain& terrain, double headingRad, const RideConditions& conditions);

} // namespace simulation
