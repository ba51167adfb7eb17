// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/selection/Priority.h>
#include <osgPMObjects/core/selection/SelectionSettings.h>
#include <osgPMObjects/core/selection/Switch.h>

namespace osgPMObjects
{

/// All settings of a ProgressiveNode.
struct NodeSettings
{
    core::SelectionSettings selection;
    core::SwitchSettings switching{core::SwitchMethod::discrete};
    std::uint32_t number = 0;
    core::Priority priority;
    double referencePixelsPerTangent = 0.0;
};

/// Settings as lines of a scene file: a name and its values without spaces, e.g. "tolerancePx=1.5". Numbers are as short as they can be and are read
/// back as they were, infinity, too.
std::vector<std::string> linesOf(const NodeSettings& settings);

/// What has no line stays as it is by default.
/// Errors: a name that is not known, a value that is none.
foundation::Result<NodeSettings> settingsOf(const std::vector<std::string>& lines);

} // namespace osgPMObjects
