// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Heights.h>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "SceneMap.h"
#include "scenery/lights/StreetLamps.h"
#include "scenery/nodes/SettlementLights.h"

namespace trainer
{

/// Makes the lamps of a map's settlements: those that it has, and along its roads that it says are lit or
/// where houses stand; behind windows, on towers.
/// `roads`: null: there are none. Null: nothing of it stands there.
std::shared_ptr<scenery::SettlementLights> settlementLights(const MapScenery& map,
                                                            const scenery::MappedLamps& mapped,
                                                            const osgRoads::core::PlacedNetwork* roads,
                                                            const foundation::HeightInPlan& ground);

} // namespace trainer
