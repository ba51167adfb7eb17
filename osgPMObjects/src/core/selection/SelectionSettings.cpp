// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include <osgPMObjects/core/selection/SelectionSettings.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::array<const char*, kSelectionMethods> kNames = {
    "ranges",      "overlapping-ranges", "box-area",     "sphere-area", "ellipsoid-area",
    "facing-area", "continuous",         "screen-error", "budget"};

/// The rows that the method looks at; none: it looks at no rows.
const std::vector<std::uint32_t>* stepsOf(const SelectionSettings& settings)
{
    switch (settings.method)
    {
    case SelectionMethod::ranges:
        return &settings.ranges.steps;
    case SelectionMethod::overlappingRanges:
        return &settings.overlappingRanges.steps;
    case SelectionMethod::boxArea:
    case SelectionMethod::sphereArea:
    case SelectionMethod::ellipsoidArea:
    case SelectionMethod::facingArea:
        return &settings.areaRows.steps;
    case SelectionMethod::continuous:
    case SelectionMethod::screenError:
    case SelectionMethod::budget:
        break;
    }
    return nullptr;
}

bool hasGoodRows(const SelectionSettings& settings)
{
    switch (settings.method)
    {
    case SelectionMethod::ranges:
        return isRanges(settings.ranges);
    case SelectionMethod::overlappingRanges:
        return isOverlappingRanges(settings.overlappingRanges);
    default:
        return !stepsOf(settings) || isAreaRows(settings.areaRows);
    }
}

} // namespace

const char* nameOf(SelectionMethod method)
{
    return kNames[static_cast<std::size_t>(method)];
}

foundation::Outcome checkSettings(const SelectionSettings& settings, std::uint32_t levels)
{
    const std::string place = std::string("selection by ") + nameOf(settings.method);
    if (!hasGoodRows(settings))
        return foundation::Error{
            place, "the boundaries are not in order, or not one fewer than the levels",
            "give positive boundaries from near to far (areas from large to small), near before "
            "far in each, and levels from fine to coarse"};
    const auto* steps = stepsOf(settings);
    if (steps && steps->back() >= levels)
        return foundation::Error{place, "level " + std::to_string(steps->back()) + " is none of the model's",
                                 "give levels below " + std::to_string(levels)};
    if (!(settings.band >= 1.0) || !(settings.continuousBand >= 1.0))
        return foundation::Error{place, "a band below 1",
                                 "give 1 for none, 1.12 to be calm for 5 % either way"};
    if (!(settings.tolerancePx > 0.0) || !(settings.trianglePx > 0.0) || !(settings.referenceM >= 0.0))
        return foundation::Error{
            place, "a tolerance, triangle or distance that is not positive",
            "give pixels above 0, and a reference distance above 0 or 0 for the default"};
    if (!(settings.alpha.fadeM <= settings.alpha.goneM) || !(settings.alpha.goneM > 0.0))
        return foundation::Error{place, "the object is gone before it begins to fade",
                                 "give the distance where it begins to fade first"};
    return foundation::success();
}

} // namespace osgPMObjects::core
