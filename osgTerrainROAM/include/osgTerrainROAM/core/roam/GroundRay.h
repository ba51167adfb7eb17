// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// A point at which a ray meets the true surface.
struct GroundHit
{
    double distanceM; ///< along the ray
    glm::dvec3 position;
    glm::dvec3 normal; ///< of the full-resolution triangle, unit length, pointing up
};

/// Finds the first point where the ray from `origin` along `direction` (unit length) meets the *true*
/// surface, from either side, within `maxDistanceM`; nothing beyond the edge of the data. No sample below a
/// triangle of the bintree is farther from it than e_v, so the surface lies in the triangle thickened by e_v:
/// the search descends only into triangles whose thickened form the ray meets.
/// Frame: the tile's. Cost: depends on the triangles near the ray, not on the size of the tile. Threads:
/// const, any.
std::optional<GroundHit> hitGround(const RoamTile& tile, const glm::dvec3& origin,
                                   const glm::dvec3& direction, double maxDistanceM);

} // namespace osgTerrainROAM::core
