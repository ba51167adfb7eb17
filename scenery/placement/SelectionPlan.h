// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/selection/SelectionSettings.h>

namespace scenery
{

/// Selection rules as people write them, for models that are not known yet: levels are shares of the faces of
/// the full model.
struct SelectionPlan
{
    /// All settings except rows and the boundaries of ranges and areas.
    osgPMObjects::core::SelectionSettings settings;
    std::vector<double> boundariesM; ///< of ranges, ascending, one fewer than levels
    double overlap = 1.25;           ///< of overlapping ranges: far by near
    std::vector<double>
        leastPx; ///< of areas, descending, one fewer than levels; empty: halves, by trianglePx
    std::vector<double> facesPercent; ///< by level, descending, each above 0 and at most 100
};

/// Makes the settings for one model: each level is the finest whose faces are at most the wanted share; equal
/// levels are merged.
/// Errors: as core::checkSettings(). `place`: of the plan, for messages.
foundation::Result<osgPMObjects::core::SelectionSettings>
selectionFor(const SelectionPlan& plan, const osgPMObjects::core::LevelTable& table,
             const std::string& place);

} // namespace scenery
