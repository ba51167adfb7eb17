// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <foundation/SettingsCheck.h>

#include <osgTerrainROAM/core/roam/SplitBounds.h>

#include <osgTerrainROAM/RoamDrawableSettings>

namespace osgTerrainROAM
{

core::MethodRequest methodRequest(const RoamDrawableSettings& settings)
{
    return {settings.method, settings.patchExponent, settings.morphing,
            std::isfinite(settings.maxAdaptTimeUs), settings.viewMarginDeg.has_value()};
}

foundation::Outcome checkSettings(const RoamDrawableSettings& settings, const std::string& owner)
{
    const int k = settings.patchExponent;
    const bool isExponent = k >= 0 && k <= core::SplitBounds::kMostExponent && k % 2 == 0;
    foundation::SettingsCheck check(owner);
    check.above("errorTolerancePx", settings.errorTolerancePx, 0.0)
        .require(settings.maxTriangles >= 2, "maxTriangles", "is " + std::to_string(settings.maxTriangles),
                 "give 2 or more: a tile has at least two triangles")
        .require(settings.maxAdaptTimeUs > 0.0, "maxAdaptTimeUs",
                 "is " + std::to_string(settings.maxAdaptTimeUs),
                 "give microseconds above 0, or infinity for no limit")
        .within("skirtM", settings.skirtM.value_or(0.0), 0.0)
        .require(isExponent, "patchExponent", "is " + std::to_string(k), "give an even number from 0 to 10")
        .above("nearestM", settings.nearestM, 0.0)
        .within("defaultErrorM", settings.defaultErrorM.value_or(0.0), 0.0)
        .within("viewMarginDeg", settings.viewMarginDeg.value_or(0.0), 0.0, 90.0);
    if (const foundation::Outcome checked = check.outcome(); !checked) return checked;
    return core::checkMethod(methodRequest(settings), owner);
}

} // namespace osgTerrainROAM
