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

/// Returns the eighths of the cloud states of OpenSCENARIO 1.0 and of 1.2; absent: the word is none of them.
std::optional<int> oktasOf(const std::string& state)
{
    static const std::map<std::string, int> kOktas{
        {"free", 0},     {"cloudy", 5},     {"overcast", 8},   {"rainy", 8},     {"zeroOktas", 0},
        {"oneOktas", 1}, {"twoOktas", 2},   {"threeOktas", 3}, {"fourOktas", 4}, {"fiveOktas", 5},
        {"sixOktas", 6}, {"sevenOktas", 7}, {"eightOktas", 8}};
    const auto found = kOktas.find(state);
    if (found != kOktas.end()) return found->second;
    return std::nullopt;
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
    return air;
}

std::optional<std::vector<simulation::CloudLayer>> cloudsOf(const simulation::EnvironmentState& environment)
{
    constexpr int kAll = 8;
    const bool falls = fallingOf(environment).perM3 > 0.0;
    const auto told = oktasOf(environment.cloudState);
    if (!told && !falls) return std::nullopt;
    return simulation::defaultClouds(told.value_or(kAll), falls);
}

double greyUnder(double cover)
{
    return std::clamp(2.0 * cover - 1.0, 0.0, 1.0);
}

osg::Vec3d windOf(const simulation::EnvironmentState& environment)
{
    if (!environment.wind) return {};
    const auto& [directionRad, speedMps] = *environment.wind;
    return {speedMps * std::cos(directionRad), speedMps * std::sin(directionRad), 0.0};
}

} // namespace trainer
