// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Heights.h>

#include <osgRoads/core/query/ObjectInstances.h>

#include "scenery/roads/things/ObjectModels.h"
#include "scenery/roads/things/RoadThings.h"

namespace scenery::roads
{

/// Adds the signals of a road.
void placeSignals(const osgRoads::core::PlacedNetwork& placed, int road, RoadThings& into);

/// Adds the objects of a road.
void placeObjects(const osgRoads::core::PlacedNetwork& placed, int road,
                  const foundation::HeightInPlan& ground, RoadThings& into);

/// Adds the bridges and tunnels of a road.
void placeStructures(const osgRoads::core::PlacedNetwork& placed, int road,
                     const foundation::HeightInPlan& ground, RoadThings& into);

/// Adds a rail, wall or fence that an object draws along a road without a break.
void placeStretch(const osgRoads::core::PlacedNetwork& placed, int road, StretchForm form,
                  const osgRoads::core::ObjectInstance& stretch, RoadThings& into);

/// Adds the beam of a guard rail, whose waves swell towards the traffic, and its posts unless the file has
/// posts there.
void placeGuardRail(const osgRoads::core::PlacedNetwork& placed, int road,
                    const osgRoads::core::ObjectInstance& stretch, RoadThings& into);

/// Adds a standing model, sharing equal ones.
void addStanding(RoadThings& into, const models::RoadModel& model, const StandingThing& thing);

} // namespace scenery::roads
