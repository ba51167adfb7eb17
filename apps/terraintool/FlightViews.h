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

/// Returns the views at `frames` instants, evenly spaced, of the tour that `trainer tour` flies; 960×540
/// pixels.
/// Frame: the tile's local frame.
foundation::Result<std::vector<viewlod::ViewState>> tourViews(const osgTerrainROAM::core::PlacedTile& tile,
                                                              int frames);

/// Returns the views of the first entity of a scenario: 24 a second from its start to its end, at most
/// `frames`. The camera is 1.5 m above the position of an entity on the ground. `name`: the scenario file,
/// for errors.
foundation::Result<std::vector<viewlod::ViewState>>
scenarioViews(simulation::Scenario scenario, const std::string& name,
              const osgTerrainROAM::core::PlacedTile& tile, int frames);

} // namespace terraintool
