// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "simulation/scenario/Scenario.h"

namespace terraintool
{

/// The views of `frames` moments, evenly spread, of the tour that `trainer tour` flies over a terrain; 960×540 pixels.
/// Frame: the tile's local frame.
foundation::Result<std::vector<viewlod::ViewState>> tourViews(const osgTerrainROAM::core::PlacedTile& tile,
                                                              int frames);

/// The same for the first entity of a scenario: 24 views a second from its start to its end, at most `frames`. The eye
/// is 1.5 m above the entity's place where that stands on the ground. `name`: the scenario's file, for errors.
foundation::Result<std::vector<viewlod::ViewState>>
scenarioViews(simulation::Scenario scenario, const std::string& name,
              const osgTerrainROAM::core::PlacedTile& tile, int frames);

} // namespace terraintool
