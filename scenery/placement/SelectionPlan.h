// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/selection/SelectionSettings.h>

namespace scenery
{

/// Selection as people write it, for models that are not known yet: levels are shares of the full model's faces.
struct SelectionPlan
{
    /// Everything but rows and boundaries of ranges and areas.
    osgPMObjects::core::SelectionSettings settings;
    std::vector<double> boundariesM; ///< of ranges, ascending, one fewer than levels
    double overlap = 1.25;           ///< of overlapping ranges: far by near
    std::vector<double>
        leastPx; ///< of areas, descending, one fewer than levels; empty: halves, by trianglePx
    std::vector<double> facesPercent; ///< by level, descending, each above 0 and at most 100
};

/// The plan for one model: the finest level whose faces are no more than the share asked for; equal levels fall together.
/// Errors: as core::checkSettings(). `place`: of the plan, for messages.
foundation::Result<osgPMObjects::core::SelectionSettings>
selectionFor(const SelectionPlan& plan, const osgPMObjects::core::LevelTable& table,
             const std::string& place);

} // namespace scenery
