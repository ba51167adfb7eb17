// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/buildings/Building.h"
#include "simulation/contact/ObstacleMap.h"

namespace scenery
{

/// Adds the walls of buildings to what vehicles may hit: a piece for each edge, kWallM thick, inside the
/// outline. Those of parts over a passage begin above it; roofs on posts have none.
void addObstacles(const std::vector<StandingBuilding>& buildings, simulation::ObstacleList& obstacles);

/// Adds the roofs of buildings to what aircraft may hit: strips along the ridge, each from below the eaves to
/// the roof's height over its middle; courtyards stay open.
void addRoofs(const std::vector<StandingBuilding>& buildings, simulation::ObstacleList& obstacles);

inline constexpr double kObstacleWallM = 0.4;

} // namespace scenery
