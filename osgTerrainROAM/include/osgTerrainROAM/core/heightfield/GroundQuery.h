// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// A point of the full-resolution ground.
struct GroundPoint
{
    glm::dvec3 position; ///< local frame
    glm::dvec3 normal;   ///< of the triangle there, unit length, pointing up
};

/// Finds the full-resolution surface (all samples, triangulated as in the bintree's finest level) vertically
/// above or below a position; nothing beyond the edge of the data. DrawnGround answers for the surface that a
/// mesh draws.
/// Frame: the tile's. Cost: O(1), about 1 µs. Threads: const, any.
/// Source: ours; fixed-point iteration over the triangles' own linear maps (GroundQuery.cpp).
std::optional<GroundPoint> groundAt(const PlacedTile& tile, double east, double north);

} // namespace osgTerrainROAM::core
