// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Heights.h>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "SceneMap.h"
#include "scenery/nodes/SettlementLights.h"

namespace trainer
{

/// Makes the lamps of a map's settlements: along its roads where houses stand, behind windows, on towers.
/// `roads`: null: there are none. Null: nothing of it stands there.
std::shared_ptr<scenery::SettlementLights> settlementLights(const MapScenery& map,
                                                            const osgRoads::core::PlacedNetwork* roads,
                                                            const foundation::HeightInPlan& ground);

} // namespace trainer
