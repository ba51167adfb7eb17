// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/SceneSelector.h>
#include <osgPMObjects/core/selection/Switch.h>

#include "scenery/json/JsonFields.h"
#include "scenery/placement/SelectionPlan.h"

namespace scenery
{

/// Reads the members `selection`, `switching` and `budget` of a description; absent ones keep their values.
void readSelection(JsonFields& parent, SelectionPlan& plan);
void readSwitching(JsonFields& parent, osgPMObjects::core::SwitchSettings& switching);
void readBudget(JsonFields& parent, osgPMObjects::core::SceneBudgetSettings& budget);

} // namespace scenery
