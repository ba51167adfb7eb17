// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include <osgSky/Atmosphere>

#include <viewlod/Budget.h>

#include <osgTerrainROAM/RoamDrawableSettings>
#include <osgTerrainROAM/RoamTechnique>

namespace viewlod
{

/// The names of the clocks in scene files, by their numbers.
constexpr auto sceneFileNames(Budget::Clock)
{
    return std::array{"0", "1"};
}

} // namespace viewlod

namespace osgTerrainROAM::core
{

/// The names of the methods in scene files.
constexpr auto sceneFileNames(Method)
{
    std::array<std::string_view, kMethods.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = kMethods[i].name;
    return names;
}

} // namespace osgTerrainROAM::core

namespace osgSky
{

/// Calls visit(name, field) for every field of the settings: the same for writing and reading.
template<class Visit>
void visitFields(auto& settings, Visit& visit)
{
    visit("sunDirectionWorld", settings.sunDirectionWorld);
    visit("visibilityM", settings.visibilityM);
    visit("hazeBaseM", settings.hazeBaseM);
    visit("sunIntensity", settings.sunIntensity);
    visit("cloudCover", settings.cloudCover);
    visit("moonlight", settings.moonlight);
    visit("fogColour", settings.fogColour);
}

} // namespace osgSky

namespace osgTerrainROAM
{

/// Calls visit(name, field) for every field of the settings: the same for writing and reading.
template<class Visit>
void visitFields(auto& settings, Visit& visit)
{
    using Settings = std::remove_cvref_t<decltype(settings)>;
    visit("errorTolerancePx", settings.errorTolerancePx);
    visit("maxTriangles", settings.maxTriangles);
    visit("morphing", settings.morphing);
    if constexpr (std::is_same_v<Settings, RoamDrawableSettings>)
    {
        visit("method", settings.method);
        visit("maxAdaptTimeUs", settings.maxAdaptTimeUs);
        visit("adaptClock", settings.adaptClock);
        visit("skirtM", settings.skirtM);
        visit("patchExponent", settings.patchExponent);
        visit("nearestM", settings.nearestM);
        visit("defaultErrorM", settings.defaultErrorM);
        visit("viewMarginDeg", settings.viewMarginDeg);
    }
}

} // namespace osgTerrainROAM
