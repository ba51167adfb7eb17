// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/ScenarioWeather.h"

#include <cmath>
#include <optional>

namespace simulation
{

WeatherSettings weatherOf(const EnvironmentState& environment, double originHeightM)
{
    WeatherSettings weather;
    const AirState standard = standardAtmosphere(originHeightM, {});
    if (environment.temperatureK)
        weather.offsets.temperatureK = *environment.temperatureK - standard.temperatureK;
    const std::optional<double> herePa = environment.seaPressurePa
                                             ? pressureByReport(originHeightM, *environment.seaPressurePa)
                                             : environment.pressurePa;
    if (herePa)
    {
        // The ratio of pressures between two heights does not depend on the one at the sea.
        const double standardPa = standardAtmosphere(originHeightM, weather.offsets).pressurePa;
        weather.offsets.seaPressurePa *= *herePa / standardPa;
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
