// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/selection/SelectionSettings.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::array<const char*, kSelectionMethods> kNames = {
    "ranges",      "overlapping-ranges", "box-area",     "sphere-area", "ellipsoid-area",
    "facing-area", "continuous",         "screen-error", "budget"};

/// Returns the levels of the rows that the method reads, or null for a method without rows.
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

bool isAlphaRange(const AlphaRange& range)
{
    return range.fadeM >= 0.0 && range.fadeM <= range.goneM && range.goneM > 0.0;
}

} // namespace

const char* nameOf(SelectionMethod method)
{
    return kNames[static_cast<std::size_t>(method)];
}

foundation::Outcome checkSettings(const SelectionSettings& settings, std::uint32_t levels)
{
    foundation::SettingsCheck check(std::string("selection by ") + nameOf(settings.method));
    check.require(
        hasGoodRows(settings), "steps", "its boundaries are not in order, or not one fewer than the levels",
        "give finite positive boundaries from near to far (areas from large to small), near before far in "
        "each, and levels from fine to coarse");
    const auto* steps = stepsOf(settings);
    if (steps && !steps->empty())
        check.require(steps->back() < levels, "steps",
                      "level " + std::to_string(steps->back()) + " is none of the model's",
                      "give levels below " + std::to_string(levels));
    check.within("referenceM", settings.referenceM, 0.0)
        .above("trianglePx", settings.trianglePx, 0.0)
        .above("tolerancePx", settings.tolerancePx, 0.0)
        .within("weights.normal", settings.weights.normal, 0.0)
        .within("weights.texCoord", settings.weights.texCoord, 0.0)
        .within("weights.colour", settings.weights.colour, 0.0)
        .within("band", settings.band, 1.0)
        .within("continuousBand", settings.continuousBand, 1.0)
        .require(isAlphaRange(settings.alpha), "alpha", "its distances are not in order",
                 "give 0 <= fadeM <= goneM and goneM > 0");
    return check.outcome();
}

} // namespace osgPMObjects::core
