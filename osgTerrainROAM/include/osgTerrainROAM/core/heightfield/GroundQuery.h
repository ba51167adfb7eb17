// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// The true ground at a place.
struct GroundPoint
{
    glm::dvec3 position; ///< on the full-resolution surface, local frame
    glm::dvec3 normal;   ///< of the full-resolution triangle there, unit length, pointing up
};

/// The *true* surface (all samples, triangulated as the bintree's finest level is) vertically above or below
/// a local position; nothing beyond the edge of the data.
/// Frame: the tile's.
/// Cost: O(1), about 1 µs.
/// Threads: const, any.
/// Source: terrain anchors, point 9 ("drawn" heights and the bound between come with the queries of the
/// engine).
std::optional<GroundPoint> groundAt(const PlacedTile& tile, double east, double north);

} // namespace osgTerrainROAM::core
