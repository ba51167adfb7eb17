// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// Edges of a drawn mesh that should have a twin and have none: T-junctions. Where data have holes, edges along them have none;
/// there those count that others, without a twin either, run along in the opposite sense.
std::size_t tJunctions(const PlacedTile& tile, const DrawnMesh& mesh);

} // namespace osgTerrainROAM::core
