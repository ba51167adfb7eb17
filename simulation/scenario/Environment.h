// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "simulation/environment/DateTime.h"
#include "simulation/environment/SurfaceWeather.h"
#include "simulation/scenario/SourceLine.h"

namespace simulation
{

struct TimeOfDay
{
    DateTime dateTime;
    bool animation = false; ///< the time of day goes on with the simulation

    bool operator==(const TimeOfDay&) const = default;
};

/// Units: radians; azimuth from north over east, elevation above the horizon.
struct Sun
{
    double azimuthRad = 0.0;
    double elevationRad = 0.0;
    std::optional<double> intensity;   ///< W/m², 1.0 and 1.1
    std::optional<double> illuminance; ///< lx, from 1.2 on

    bool operator==(const Sun&) const = default;
};

struct Precipitation
{
    std::string type;                ///< dry, rain, snow
    std::optional<double> intensity; ///< mm/h

    bool operator==(const Precipitation&) const = default;
};

struct Wind
{
    double directionRad = 0.0; ///< where it blows to, from the x axis towards y
    double speedMps = 0.0;

    bool operator==(const Wind&) const = default;
};

/// An absent value leaves the environment unchanged.
struct Weather
{
    std::string cloudState; ///< `cloudState` (1.0, 1.1) or `fractionalCloudCover` (1.2); empty: unchanged
    std::optional<double> temperatureK;
    std::optional<double> pressurePa;    ///< at the origin of the scene
    std::optional<double> seaPressurePa; ///< in its place: of a weather report, reduced to the sea (QNH)
    std::optional<Sun> sun;
    std::optional<double> fogVisualRangeM;
    std::optional<Precipitation> precipitation;
    std::optional<Wind> wind;

    bool operator==(const Weather&) const = default;
};

struct Environment
{
    SourceLine source;
    std::string name;
    std::optional<TimeOfDay> timeOfDay;
    std::optional<Weather> weather;
    std::optional<double> roadFriction;
    std::string roadWetness; ///< dry, moist, wetWithPuddles, lowFlooded, highFlooded; empty: unchanged
    std::optional<SurfaceWeather> ground; ///< what lies on it; the property "ground" of RoadCondition

    bool operator==(const Environment&) const = default;
};

} // namespace simulation
