// SPDX-License-Identifier: Apache-2.0
#include "commands/RideOptions.h"

#include <cstdio>
#include <map>

#include "ride/RideRequest.h"
#include "simulation/scenario/SessionTraffic.h"
#include "terminal/CommandLine.h"

namespace trainer
{

namespace
{

const std::map<std::string, simulation::RideWeather> kWeathers{{"clear", simulation::RideWeather::clear},
                                                               {"fog", simulation::RideWeather::fog},
                                                               {"rain", simulation::RideWeather::rain},
                                                               {"snow", simulation::RideWeather::snow}};

} // namespace

void RideOptions::addTo(CLI::App& command)
{
    command.add_option("--time", _time, "HH:MM, mean solar time of a day in summer; without it one by day");
    command.add_option("--weather", _weather, "clear, fog, rain on wet roads, or snow that covers them")
        ->transform(terminal::named(kWeathers));
    command.add_option(
        "--traffic", _traffic,
        "vehicles a kilometre of street: none, light (4), medium (10), dense (25), or a number "
        "from 0 to 60");
}

foundation::Outcome RideOptions::complete(RideRequest& request) const
{
    request.conditions.weather = _weather;
    const auto perKm = simulation::trafficDensity(_traffic);
    if (!perKm)
        return foundation::Error{"--traffic", "'" + _traffic + "' is no density of traffic",
                                 "write none, light, medium, dense, or vehicles a kilometre from 0 to 60"};
    request.play.trafficPerKm = *perKm;
    if (_time.empty()) return foundation::success();
    int hour = 0, minute = 0;
    char rest = 0;
    if (std::sscanf(_time.c_str(), "%2d:%2d%c", &hour, &minute, &rest) != 2 || hour < 0 || hour > 23 ||
        minute < 0 || minute > 59)
        return foundation::Error{"--time", "'" + _time + "' is no time of day",
                                 "write HH:MM, from 00:00 to 23:59"};
    request.conditions.solarHour = hour + minute / 60.0;
    return foundation::success();
}

} // namespace trainer
