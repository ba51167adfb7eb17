// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/LightSteps.h"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace scenery
{

namespace
{

constexpr double kNightDeg = -6.0, kDayDeg = 2.0; ///< of the sun
constexpr double kPoorM = 5000.0;                 ///< of visibility

constexpr std::array<std::string_view, kLightGroups> kGroupNames{
    "",        "runway", "centreLine", "touchdownZone", "approach", "papi",
    "taxiway", "beacon", "obstacle",   "street",        "window",   ""};

bool isOfHighIntensity(LightGroup group)
{
    return group == LightGroup::runway || group == LightGroup::centreLine ||
           group == LightGroup::touchdownZone || group == LightGroup::approach;
}

} // namespace

double shareOfStep(LightGroup group, int step)
{
    static constexpr std::array<double, 6> kHigh{0.0, 0.002, 0.01, 0.05, 0.25, 1.0};
    static constexpr std::array<double, 6> kOther{0.0, 0.01, 0.03, 0.1, 0.3, 1.0};
    if (group == LightGroup::steady) return 1.0;
    const auto at = static_cast<std::size_t>(std::clamp(step, 0, 5));
    return isOfHighIntensity(group) ? kHigh[at] : kOther[at];
}

int defaultStep(LightGroup group, double sunElevationDeg, double visibilityM)
{
    const bool isDay = sunElevationDeg > kDayDeg, isNight = sunElevationDeg < kNightDeg;
    const bool isPoor = visibilityM < kPoorM;
    if (group >= LightGroup::street) return isDay ? 0 : 5;
    if (group == LightGroup::obstacle || group == LightGroup::beacon) return isDay && !isPoor ? 0 : 5;
    if (group == LightGroup::papi) return isDay ? 5 : isNight ? 3 : 4;
    if (group == LightGroup::taxiway) return isDay && !isPoor ? 0 : 5;
    if (isDay) return isPoor ? 5 : 0;
    return isNight ? (isPoor ? 4 : 3) : (isPoor ? 5 : 4);
}

LightLevels levelsOf(const LightSteps& steps, double sunElevationDeg, double visibilityM)
{
    LightLevels levels{};
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
        const auto group = static_cast<LightGroup>(i); // vehicles have switches of their own
        levels[i] = static_cast<float>(
            shareOfStep(group, steps[i].value_or(defaultStep(group, sunElevationDeg, visibilityM))));
    }
    return levels;
}

foundation::Result<LightSteps> lightStepsOf(const std::string& text)
{
    const auto error = [&](const std::string& what)
    {
        return foundation::Error{
            text, what,
            "give names and steps like approach=5,papi=3 or all=0; names are runway, "
            "centreLine, touchdownZone, approach, papi, taxiway, beacon, obstacle, street, "
            "window, all; steps are 0 to 5"};
    };
    LightSteps steps{};
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');)
    {
        const std::size_t equals = part.find('=');
        const std::string name = part.substr(0, equals);
        if (equals == std::string::npos || part.size() != equals + 2 || part.back() < '0' ||
            part.back() > '5')
            return error("'" + part + "' is no group with a step");
        const int step = part.back() - '0';
        const auto found = std::find(kGroupNames.begin() + 1, kGroupNames.end() - 1, name);
        if (name == "all")
            std::fill(steps.begin() + 1, steps.end() - 1, step);
        else if (found == kGroupNames.end() - 1)
            return error("has no group '" + name + "'");
        else
            steps[static_cast<std::size_t>(found - kGroupNames.begin())] = step;
    }
    return steps;
}

} // namespace scenery
