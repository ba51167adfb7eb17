// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <osgTerrainROAM/Atmosphere>

#include "SettingsCheck.h"

namespace osgTerrainROAM
{

foundation::Outcome checkSettings(const AtmosphereSettings& settings)
{
    const auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
    const double sunLength = settings.sunDirectionWorld.length();
    const osg::Vec3f fog = settings.fogColour.value_or(osg::Vec3f());
    const bool isFogColour = isFiniteFrom0(fog.x()) && isFiniteFrom0(fog.y()) && isFiniteFrom0(fog.z());
    const std::array<SettingRequirement, 7> requirements{{
        {isFiniteAbove0(sunLength), "sunDirectionWorld", sunLength, "a vector of finite length above 0"},
        {std::isfinite(settings.visibilityM) && settings.visibilityM >= 1.0, "visibilityM",
         settings.visibilityM, "a finite distance of 1 m or more"},
        {std::isfinite(settings.hazeBaseM), "hazeBaseM", settings.hazeBaseM, "a finite height in metres"},
        {isFiniteFrom0(settings.sunIntensity), "sunIntensity", settings.sunIntensity,
         "a finite factor, 0 or more"},
        {isShare(settings.cloudCover), "cloudCover", settings.cloudCover, "a number from 0 to 1"},
        {isShare(settings.moonlight), "moonlight", settings.moonlight, "a number from 0 to 1"},
        {isFogColour, "fogColour", fog.length(), "finite radiances, 0 or more, or nothing"},
    }};
    return checkRequirements("Atmosphere", requirements);
}

} // namespace osgTerrainROAM
