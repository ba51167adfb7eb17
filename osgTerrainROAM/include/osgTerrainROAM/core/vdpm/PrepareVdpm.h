// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/PreparedTerrain.h>

namespace osgTerrainROAM::core
{

/// Prepares a tile for the method vdpm: the meshes of all view groups share one forest. Errors and cost:
/// heightFieldForest().
foundation::Result<PreparedPtr> prepareVdpm(std::shared_ptr<const RoamTile> tile);

} // namespace osgTerrainROAM::core
