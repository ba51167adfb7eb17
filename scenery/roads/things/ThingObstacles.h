// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/roads/things/RoadThings.h"

namespace scenery::roads
{

/// Adds what stands beside roads to what vehicles may hit: posts and masts, cones, boxes, plants, and the
/// bodies along roads (RoadThings::bodies). What hangs from a gantry, and posts of rails, are left out.
void addObstacles(const RoadThings& things, simulation::ObstacleList& obstacles);

} // namespace scenery::roads
