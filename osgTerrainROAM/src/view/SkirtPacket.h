// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "MeshPacket.h"

namespace osgTerrainROAM
{

/// Makes the skirt: a wall below the mesh's edges at the border of the data, so that no gap shows towards a
/// neighbour that has other edges. It is a packet of its own, always whole.
/// `depthM`: the depth at a point of the tile's frame. Down is along the ellipsoid's normal; planar: along z.
/// Where triangles cross the data's edge, the wall begins where the edge cuts them.
/// Cost: about 0.1 µs for each edge on the border and each level. Null: the mesh carries patches, which have
/// none.
PacketPtr skirtPacket(const core::TerrainMesh& mesh, std::uint64_t serial,
                      const std::function<double(const glm::dvec3&)>& depthM);

} // namespace osgTerrainROAM
