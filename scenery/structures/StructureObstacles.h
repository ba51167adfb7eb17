// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Heights.h>

#include "scenery/structures/Structure.h"
#include "simulation/contact/ObstacleMap.h"

namespace scenery
{

/// Adds walls, fences, poles, pylons' legs and turbines to what vehicles may hit, as structureFacets() draws
/// them. Railways with their tunnels, footbridges and wires are left out.
void addObstacles(const std::vector<Structure>& structures, const foundation::HeightInPlan& ground,
                  simulation::ObstacleList& obstacles);

} // namespace scenery
