// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <foundation/Result.h>

#include <osg/Group>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace trainer
{

/// Returns the height of the ground in the scene's z; nothing beyond the data.
using HeightOfGround = std::function<std::optional<double>(double eastM, double northM)>;

/// Adds what a .roam file's `buildings` and `objects` put on the ground, houses with their doors to the roads (null: none), and says what could not be used.
/// Errors: those of importShapes(); a source without anything that can stand here.
foundation::Outcome addMapScenery(const osgTerrainROAM::core::RoamFile& description,
                                  const osgTerrainROAM::core::PlacedTile& tile, const HeightOfGround& ground,
                                  const osgRoads::core::PlacedNetwork* roads, osg::Group& scene);

} // namespace trainer
