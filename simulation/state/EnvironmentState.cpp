// SPDX-License-Identifier: Apache-2.0
#include "simulation/state/EnvironmentState.h"

#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

constexpr DateTime kDefaultDateTime{1'718'964'000'000}; // 2024-06-21T10:00:00Z

} // namespace

bool isDark(const EnvironmentState& environment)
{
    constexpr double kDuskDeg = 3.0;
    return environment.sun.elevationDeg < kDuskDeg;
}

EnvironmentClock::EnvironmentClock(const std::optional<Geodetic>& origin, const WorldAir& world)
    : _place(origin.value_or(Geodetic{45.0, 0.0, 0.0})), _givenSun(world.sun)
{
    constexpr double kDegPerHour = 15.0, kSecondsPerHour = 3600.0;
    const double hours = std::trunc(_place.longitudeDeg / kDegPerHour);
    _state.dateTime = kDefaultDateTime.plusSeconds(-hours * kSecondsPerHour);
    _state.fogVisualRangeM = world.visibilityM;
}

void EnvironmentClock::apply(const Environment& environment, double timeS)
{
    if (environment.timeOfDay)
    {
        _state.dateTime = environment.timeOfDay->dateTime;
        _isAnimated = environment.timeOfDay->animation;
        _setAtS = timeS;
        _givenSun.reset();
    }
    if (environment.roadFriction) _state.roadFriction = *environment.roadFriction;
    if (!environment.roadWetness.empty()) _state.roadWetness = environment.roadWetness;
    if (!environment.weather) return;
    const Weather& weather = *environment.weather;
    if (weather.sun)
    {
        const double azimuth = std::fmod(foundation::degreesOf(weather.sun->azimuthRad), 360.0);
        _givenSun = SunDirection{azimuth < 0.0 ? azimuth + 360.0 : azimuth,
                                 foundation::degreesOf(weather.sun->elevationRad)};
    }
    if (weather.fogVisualRangeM) _state.fogVisualRangeM = weather.fogVisualRangeM;
    if (!weather.cloudState.empty()) _state.cloudState = weather.cloudState;
    if (weather.precipitation) _state.precipitation = weather.precipitation;
    if (weather.wind) _state.wind = weather.wind;
    if (weather.temperatureK) _state.temperatureK = weather.temperatureK;
    if (weather.pressurePa) _state.pressurePa = weather.pressurePa;
}

EnvironmentState EnvironmentClock::at(double timeS) const
{
    EnvironmentState state = _state;
    if (_isAnimated) state.dateTime = _state.dateTime.plusSeconds(timeS - _setAtS);
    state.sun =
        _givenSun ? *_givenSun : sunDirection(state.dateTime, _place.latitudeDeg, _place.longitudeDeg);
    return state;
}

} // namespace simulation
