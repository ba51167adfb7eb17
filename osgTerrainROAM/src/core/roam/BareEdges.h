// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// Finds the edges inside the data where a part of an overlapping mesh ends and lies not, along all of its
/// length, below another part. Where there is none, the uppermost surface is continuous: it is so within each
/// part, and where a part ends another one is above it. So every ray from above it to below it meets a
/// triangle.
/// Frame: the grid for places, the tile's for heights. Cost: that of comparing each edge with the triangles
/// within some 16 cells.
std::size_t bareEdges(const PlacedTile& tile, const DrawnMesh& mesh);

} // namespace osgTerrainROAM::core
