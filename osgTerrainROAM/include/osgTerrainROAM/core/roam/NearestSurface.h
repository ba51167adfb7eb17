// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

/// Computes the distance in metres from a point to the drawn mesh (its leaves): no near plane may lie beyond.
/// Branch and bound down the bintree: a triangle's leaves lie in the convex hull of its corners and of the
/// split vertices below, all of them within max(corner distance, r_v) of its split vertex.
/// Frame: the tile's. Cost: a few nodes per level.
double nearestSurfaceM(const DiamondTree& tree, const glm::dvec3& point);

/// Computes the distance in metres from a point to a triangle.
double distanceToTriangleM(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners);

} // namespace osgTerrainROAM::core
