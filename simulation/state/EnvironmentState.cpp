// SPDX-License-Identifier: Apache-2.0
#include "simulation/state/EnvironmentState.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <foundation/Units.h>

namespace simulation
{
namespace
{

using foundation::kZeroCelsiusK;

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
    _toldGround = world.ground;
    _ground = world.ground.value_or(SurfaceWeather{});
}

Fall EnvironmentClock::fallNow() const
{
    constexpr double kDefaultMmPerHour = 4.0;
    Fall fall;
    if (const auto& precipitation = _state.precipitation)
    {
        const double mmPerHour = precipitation->intensity.value_or(kDefaultMmPerHour);
        if (precipitation->type == "rain") fall.rainMmPerHour = mmPerHour;
        if (precipitation->type == "snow") fall.snowMmPerHour = mmPerHour;
    }
    fall.isMelting = _state.temperatureK.has_value();
    fall.temperatureC = _state.temperatureK.value_or(kZeroCelsiusK) - kZeroCelsiusK;
    return fall;
}

SurfaceWeather EnvironmentClock::groundAt(double timeS) const
{
    return weathered(_ground, fallNow(), timeS - _groundAtS);
}

void EnvironmentClock::apply(const Environment& environment, double timeS)
{
    _ground = environment.ground.value_or(groundAt(timeS));
    _groundAtS = timeS;
    takeOver(environment, timeS);
    if (timeS > 0.0) return;
    constexpr double kFellBeforeS = 3600.0;
    if (environment.ground) _toldGround = environment.ground;
    _ground = _toldGround ? *_toldGround : weathered({}, fallNow(), kFellBeforeS);
}

/// Changes what an environment contains, but for the ground.
void EnvironmentClock::takeOver(const Environment& environment, double timeS)
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
    if (!weather.pressurePa && !weather.seaPressurePa) return;
    _state.pressurePa = weather.pressurePa;
    _state.seaPressurePa = weather.seaPressurePa;
}

EnvironmentState EnvironmentClock::at(double timeS) const
{
    EnvironmentState state = _state;
    if (_isAnimated) state.dateTime = _state.dateTime.plusSeconds(timeS - _setAtS);
    state.sun =
        _givenSun ? *_givenSun : sunDirection(state.dateTime, _place.latitudeDeg, _place.longitudeDeg);
    state.surface = groundAt(timeS);
    state.surface.waterMm = std::max(state.surface.waterMm, filmOfRoads(state.roadWetness));
    if (state.temperatureK.value_or(kZeroCelsiusK) < kZeroCelsiusK && state.surface.waterMm >= kLeastFilmMm)
        state.surface.isIcy = true;
    return state;
}

} // namespace simulation
