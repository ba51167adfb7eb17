// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/RideEnvironment.h"

#include "simulation/tour/TourScenario.h"

namespace simulation
{

namespace
{

// Meteorological optical range. Source: WMO, *Guide to Instruments and Methods of Observation*, 2018, part I,
// chapter 9: fog is below 1000 m.
constexpr double kFogM = 250.0, kRainM = 4000.0, kSnowM = 1200.0;
constexpr double kRainMmPerH = 10.0, kSnowMmPerH = 3.0; ///< heavy rain, snow

void setHour(Environment& environment, const TourTerrain& terrain, double solarHour)
{
    constexpr double kDegPerHour = 15.0, kSecondsPerHour = 3600.0;
    const double longitudeDeg = terrain.origin ? terrain.origin->longitudeDeg : 0.0;
    const bool isSouth = terrain.origin && terrain.origin->latitudeDeg < 0.0;
    const DateTime midnight = *parseDateTime(isSouth ? "2024-12-21T00:00:00Z" : "2024-06-21T00:00:00Z");
    environment.timeOfDay =
        TimeOfDay{midnight.plusSeconds((solarHour - longitudeDeg / kDegPerHour) * kSecondsPerHour), true};
    environment.weather->sun.reset();
}

void setFall(Environment& environment, const char* type, double mmPerHour, double visibleM)
{
    environment.weather->cloudState = "eightOktas";
    environment.weather->precipitation = Precipitation{type, mmPerHour};
    environment.weather->fogVisualRangeM = visibleM;
}

} // namespace

void leaveToWorld(Environment& environment, const KeptAir& kept)
{
    if (kept.sun) environment.timeOfDay.reset();
    if (!environment.weather) return;
    if (kept.sun) environment.weather->sun.reset();
    if (kept.visibility) environment.weather->fogVisualRangeM.reset();
    if (kept.clouds) environment.weather->cloudState.clear();
}

Environment rideEnvironment(const TourTerrain& terrain, double headingRad, const RideConditions& conditions)
{
    Environment environment = tourEnvironment(terrain, headingRad);
    leaveToWorld(environment, {conditions.keepsSun, conditions.keepsVisibility, conditions.keepsClouds});
    if (conditions.solarHour) setHour(environment, terrain, *conditions.solarHour);
    switch (conditions.weather)
    {
    case RideWeather::clear:
        break;
    case RideWeather::fog:
        environment.weather->cloudState = "eightOktas";
        environment.weather->fogVisualRangeM = kFogM;
        break;
    case RideWeather::rain:
        setFall(environment, "rain", kRainMmPerH, kRainM);
        environment.roadWetness = "wetWithPuddles";
        break;
    case RideWeather::snow:
        setFall(environment, "snow", kSnowMmPerH, kSnowM);
        break;
    }
    return environment;
}

} // namespace simulation
