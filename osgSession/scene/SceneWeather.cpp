// SPDX-License-Identifier: Apache-2.0
#include "SceneWeather.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace trainer
{
namespace
{

/// Returns the cloud cover 0…1 of the cloud states of OpenSCENARIO 1.0 and of 1.2 (oktas).
double cloudCover(const std::string& state, bool falls)
{
    static const std::map<std::string, double> kCover{
        {"free", 0.0},      {"cloudy", 0.6},      {"overcast", 1.0},  {"rainy", 1.0},
        {"zeroOktas", 0.0}, {"oneOktas", 0.125},  {"twoOktas", 0.25}, {"threeOktas", 0.375},
        {"fourOktas", 0.5}, {"fiveOktas", 0.625}, {"sixOktas", 0.75}, {"sevenOktas", 0.875},
        {"eightOktas", 1.0}};
    const auto found = kCover.find(state);
    if (found != kCover.end()) return found->second;
    return falls ? 1.0 : 0.0;
}

} // namespace

simulation::Hydrometeors fallingOf(const simulation::EnvironmentState& environment)
{
    constexpr double kDefaultMmPerHour = 4.0;
    if (!environment.precipitation) return {};
    const double mmPerHour = environment.precipitation->intensity.value_or(kDefaultMmPerHour);
    if (environment.precipitation->type == "rain") return simulation::rainOf(mmPerHour);
    if (environment.precipitation->type == "snow") return simulation::snowOf(mmPerHour);
    return {};
}

osgSky::AtmosphereSettings airOf(const simulation::EnvironmentState& environment)
{
    osgSky::AtmosphereSettings air;
    const simulation::Hydrometeors falling = fallingOf(environment);
    air.sunDirectionWorld =
        osgSky::sunDirectionFromAngles(environment.sun.azimuthDeg, environment.sun.elevationDeg);
    air.visibilityM = std::max(
        simulation::visibilityM(environment.fogVisualRangeM.value_or(air.visibilityM), falling), 1.0);
    air.cloudCover = cloudCover(environment.cloudState, falling.perM3 > 0.0);
    return air;
}

osg::Vec3d windOf(const simulation::EnvironmentState& environment)
{
    if (!environment.wind) return {};
    const auto& [directionRad, speedMps] = *environment.wind;
    return {speedMps * std::cos(directionRad), speedMps * std::sin(directionRad), 0.0};
}

float roadWetnessOf(const simulation::EnvironmentState& environment)
{
    static const std::map<std::string, float> kWetness{{"dry", 0.0F},
                                                       {"moist", 0.5F},
                                                       {"wetWithPuddles", 1.0F},
                                                       {"lowFlooded", 1.0F},
                                                       {"highFlooded", 1.0F}};
    const auto found = kWetness.find(environment.roadWetness);
    const float told = found == kWetness.end() ? 0.0F : found->second;
    const simulation::Hydrometeors falling = fallingOf(environment);
    return falling.perM3 > 0.0 && !falling.isSnow ? std::max(told, 0.8F) : told;
}

} // namespace trainer
