// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

/// The drawn ground below a position: where wheels have to stand to touch what is visible.
struct DrawnGround
{
    glm::dvec3 position; ///< on the drawn triangle (of the leaf's patch, if it carries one), local frame
    glm::dvec3 normal;   ///< of that triangle, unit length, pointing up
    double boundM;       ///< largest distance of the true surface from that triangle
    TriangleId leaf;
};

/// Finds the *drawn* surface vertically above or below a local position; nothing beyond the edge of the data.
/// groundAt() finds the *true* surface.
/// Frame: the tile's. Units: metres. Cost: O(depth of the mesh). Threads: any, while no operation changes the
/// tree.
std::optional<DrawnGround> drawnGroundAt(const DiamondTree& tree, double eastM, double northM);

/// Does the same for many positions (east, north), and writes as many `grounds`. It follows several paths
/// down the tree at once, so that one does not wait for another's memory.
void drawnGroundAt(const DiamondTree& tree, std::span<const glm::dvec2> places,
                   std::span<std::optional<DrawnGround>> grounds);

} // namespace osgTerrainROAM::core
