// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

/// The ground as the mesh shows it at a place: what wheels must stand on to touch what is seen.
struct DrawnGround
{
    glm::dvec3 position; ///< on the drawn triangle (of the leaf's patch, if it carries one), local frame
    glm::dvec3 normal;   ///< of that triangle, unit length, pointing up
    double boundM;       ///< the true surface over that triangle is nowhere farther from it than this
    TriangleId leaf;
};

/// The *drawn* surface vertically above or below a local position; nothing beyond the edge of the data. groundAt() gives
/// the *true* one.
/// Frame: the tile's. Units: metres. Cost: O(depth of the mesh). Threads: while no operation changes the tree, any.
/// Source: terrain anchors, point 9.
std::optional<DrawnGround> drawnGroundAt(const DiamondTree& tree, double eastM, double northM);

/// The same for many places (east, north), into as many `grounds`: several ways down the tree at once, so that one need
/// not wait for another's memory.
void drawnGroundAt(const DiamondTree& tree, std::span<const glm::dvec2> places,
                   std::span<std::optional<DrawnGround>> grounds);

} // namespace osgTerrainROAM::core
