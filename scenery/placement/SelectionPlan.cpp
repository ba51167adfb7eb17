// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/SelectionPlan.h"

#include <algorithm>
#include <cmath>

namespace scenery
{

using osgPMObjects::core::LevelTable;
using osgPMObjects::core::SelectionMethod;
using osgPMObjects::core::SelectionSettings;

namespace
{

std::uint32_t stepsTo(const LevelTable& table, double percent)
{
    const double most = std::max(1.0, std::floor(percent * 0.01 * table.faces.front()));
    const auto level = std::partition_point(table.faces.begin(), table.faces.end(),
                                            [&](std::uint32_t faces) { return faces > most; });
    return std::min(static_cast<std::uint32_t>(level - table.faces.begin()), table.mostSteps());
}

/// Rows of a plan for one model: a small one has fewer levels than the plan, whose rows then share one.
void fillRows(const SelectionPlan& plan, const LevelTable& table, const std::vector<double>& boundaries,
              std::vector<double>& kept, std::vector<std::uint32_t>& steps)
{
    for (std::size_t row = 0; row < plan.facesPercent.size(); ++row)
    {
        const std::uint32_t level = stepsTo(table, plan.facesPercent[row]);
        if (row > 0 && level == steps.back()) continue;
        if (row > 0) kept.push_back(boundaries[row - 1]);
        steps.push_back(level);
    }
}

} // namespace

foundation::Result<SelectionSettings> selectionFor(const SelectionPlan& plan, const LevelTable& table,
                                                   const std::string& place)
{
    using osgPMObjects::core::AreaRows;
    SelectionSettings settings = plan.settings;
    const SelectionMethod method = settings.method;
    const bool isRanges = method == SelectionMethod::ranges || method == SelectionMethod::overlappingRanges;
    const bool isAreas = method >= SelectionMethod::boxArea && method <= SelectionMethod::facingArea;
    const std::vector<double>& boundaries = isRanges ? plan.boundariesM : plan.leastPx;
    const bool isHalving = isAreas && boundaries.empty();
    if ((isRanges || isAreas) && !isHalving && plan.facesPercent.size() != boundaries.size() + 1)
        return foundation::Error{place, "there has to be one level more than boundaries between them",
                                 "give facesPercent one number more than boundariesM or leastPx"};
    if (isRanges) fillRows(plan, table, boundaries, settings.ranges.boundariesM, settings.ranges.steps);
    if (method == SelectionMethod::overlappingRanges)
        settings.overlappingRanges =
            osgPMObjects::core::OverlappingRanges::around(settings.ranges, plan.overlap);
    if (isHalving) settings.areaRows = AreaRows::halving(table, settings.trianglePx);
    if (isAreas && !isHalving)
        fillRows(plan, table, boundaries, settings.areaRows.leastPx, settings.areaRows.steps);
    const auto levels = static_cast<std::uint32_t>(table.faces.size());
    if (const auto sound = osgPMObjects::core::checkSettings(settings, levels); !sound)
        return foundation::Error{place, sound.error().place + ": " + sound.error().what,
                                 sound.error().remedy};
    return settings;
}

} // namespace scenery
