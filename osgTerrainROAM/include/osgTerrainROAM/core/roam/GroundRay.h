// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// Where a ray meets the true surface.
struct GroundHit
{
    double distanceM; ///< along the ray
    glm::dvec3 position;
    glm::dvec3 normal; ///< of the full-resolution triangle, unit length, pointing up
};

/// The first place where the ray from `origin` along `direction` (unit length) meets the *true* surface, from either
/// side, within `maxDistanceM`; nothing beyond the edge of the data.
/// Frame: the tile's. Cost: what the ray passes close to, not what the tile holds. Threads: const, any.
/// Source: spec 1 D, Error: no sample below a triangle is farther from it than e_v, so a triangle thickened by e_v holds
/// the surface.
std::optional<GroundHit> hitGround(const RoamTile& tile, const glm::dvec3& origin,
                                   const glm::dvec3& direction, double maxDistanceM);

} // namespace osgTerrainROAM::core
