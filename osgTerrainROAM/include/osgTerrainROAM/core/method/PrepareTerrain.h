// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/method/Method.h>
#include <osgTerrainROAM/core/roam/PreparedTerrain.h>

namespace osgTerrainROAM::core
{

/// Prepares a tile for a method. Errors: as checkMethod(). Cost and memory: those of the method.
/// Threads: with a shared lock of the tile, if it is edited.
foundation::Result<PreparedPtr> prepareTerrain(std::shared_ptr<const RoamTile> tile,
                                               const MethodRequest& request,
                                               const std::string& owner = "RoamDrawable");

} // namespace osgTerrainROAM::core
