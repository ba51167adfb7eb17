// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <foundation/Result.h>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "SceneTerrain.h"

namespace trainer
{

/// Returns the height of the ground in the scene's z; nothing beyond the data.
using HeightOfGround = std::function<std::optional<double>(double eastM, double northM)>;

/// Makes what a .roam file's `buildings` and `objects` put on the ground, houses with their doors to the
/// roads (null: none), and says what could not be used.
/// Errors: those of importShapes(); a source without anything that can stand here.
foundation::Outcome addMapScenery(const osgTerrainROAM::core::RoamFile& description,
                                  const osgTerrainROAM::core::RoamTile& tile, const HeightOfGround& ground,
                                  const osgRoads::core::PlacedNetwork* roads,
                                  std::vector<StandingPart>& standing);

} // namespace trainer
