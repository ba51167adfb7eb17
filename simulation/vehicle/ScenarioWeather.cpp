// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/ScenarioWeather.h"

#include <cmath>

namespace simulation
{

WeatherSettings weatherOf(const EnvironmentState& environment, double originHeightM)
{
    WeatherSettings weather;
    const AirState standard = standardAtmosphere(originHeightM, {});
    if (environment.temperatureK)
        weather.offsets.temperatureK = *environment.temperatureK - standard.temperatureK;
    if (environment.pressurePa)
    {
        // The ratio of pressures between two heights does not depend on the one at the sea.
        const double here = standardAtmosphere(originHeightM, weather.offsets).pressurePa;
        weather.offsets.seaPressurePa *= *environment.pressurePa / here;
    }
    if (environment.wind)
    {
        const Wind& wind = *environment.wind;
        weather.windMps = {wind.speedMps * std::cos(wind.directionRad),
                           wind.speedMps * std::sin(wind.directionRad), 0.0};
        weather.windAtSixMetresMps = wind.speedMps;
    }
    return weather;
}

} // namespace simulation
