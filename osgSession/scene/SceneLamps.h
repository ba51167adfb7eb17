// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <foundation/ContentMark.h>
#include <foundation/Heights.h>
#include <foundation/KeptFrom.h>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "SceneMap.h"
#include "scenery/lights/StreetLamps.h"
#include "scenery/nodes/SettlementLights.h"

namespace trainer
{

/// Makes the lamps of a map's settlements: those that it has, and along its roads that it says are lit or
/// where houses stand; behind windows, on towers.
/// `roads`: null: there are none. `roadsMark`: of what they follow from besides the tile
/// (scenery::markOfRoads()). `kept`: what follows from the tile; where street lamps stand is found there the
/// second time. Null: nothing of it stands there.
std::shared_ptr<scenery::SettlementLights>
settlementLights(MapScenery map, const scenery::MappedLamps& mapped,
                 const osgRoads::core::PlacedNetwork* roads, foundation::HeightInPlan ground,
                 const std::optional<foundation::ContentMark>& roadsMark, const foundation::KeptFrom& kept);

} // namespace trainer
