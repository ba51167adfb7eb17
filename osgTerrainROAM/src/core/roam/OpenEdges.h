// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// Finds the edges of a drawn mesh that should have a twin and have none: T-junctions. Edges along holes of
/// the data have no twin; there an edge counts only if another edge without a twin runs along it in the
/// opposite sense.
std::size_t tJunctions(const PlacedTile& tile, const DrawnMesh& mesh);

} // namespace osgTerrainROAM::core
