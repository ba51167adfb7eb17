// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <osgTerrainROAM/core/roam/SplitBounds.h>

#include <osgTerrainROAM/RoamDrawableSettings>

#include "../SettingsCheck.h"

namespace osgTerrainROAM
{

core::MethodRequest methodRequest(const RoamDrawableSettings& settings)
{
    return {settings.method, settings.patchExponent, settings.morphing,
            std::isfinite(settings.maxAdaptTimeUs)};
}

foundation::Outcome checkSettings(const RoamDrawableSettings& settings, const std::string& owner)
{
    const int k = settings.patchExponent;
    const bool isExponent = k >= 0 && k <= core::SplitBounds::kMostExponent && k % 2 == 0;
    const double skirtM = settings.skirtM.value_or(0.0), defaultErrorM = settings.defaultErrorM.value_or(0.0);
    const std::array<SettingRequirement, 7> requirements{{
        {isFiniteAbove0(settings.errorTolerancePx), "errorTolerancePx", settings.errorTolerancePx,
         "a finite number of pixels above 0"},
        {settings.maxTriangles >= 2, "maxTriangles", static_cast<double>(settings.maxTriangles),
         "2 or more: a tile has at least two triangles"},
        {settings.maxAdaptTimeUs > 0.0, "maxAdaptTimeUs", settings.maxAdaptTimeUs,
         "microseconds above 0, or infinity for no limit"},
        {isFiniteFrom0(skirtM), "skirtM", skirtM,
         "a finite depth in metres, 0 or more, or nothing for no skirts"},
        {isExponent, "patchExponent", static_cast<double>(k), "an even number from 0 to 10"},
        {isFiniteAbove0(settings.nearestM), "nearestM", settings.nearestM,
         "a finite distance in metres above 0"},
        {isFiniteFrom0(defaultErrorM), "defaultErrorM", defaultErrorM,
         "a finite length in metres, 0 or more"},
    }};
    if (const auto met = checkRequirements(owner, requirements); !met) return met;
    return core::checkMethod(methodRequest(settings), owner);
}

} // namespace osgTerrainROAM
