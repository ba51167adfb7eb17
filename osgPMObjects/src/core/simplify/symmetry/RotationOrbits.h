// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Extent.h>

namespace osgPMObjects::core
{

/// The images of positions when a mesh is turned about an axis: a cylinder of n sides is its own image after
/// an n-th turn. Collapses are then done once for each image, so that levels stay round while they can: of n
/// sides, n / 2, n / 4 … are left.
struct RotationOrbits
{
    static constexpr std::uint32_t kNone = ~0u;

    int axis = 0;
    glm::dvec3 middle{0.0};          ///< a point of the axis
    std::uint32_t fold = 0;          ///< images by the least turn make a whole one; 0: the mesh is not round
    std::vector<std::uint32_t> next; ///< by position: its image after the least turn
    std::uint32_t step =
        1; ///< the least turns after which the levels are their own images still; it divides the fold

    bool isRound() const { return fold > 0; }
    /// The image of a position after so many least turns.
    std::uint32_t imageOf(std::uint32_t position, std::uint32_t turns) const;
    /// The same of a place.
    glm::dvec3 imageOf(const glm::dvec3& place, std::uint32_t turns) const;
    /// Returns the nearest place that is within a radius of the axis.
    glm::dvec3 within(const glm::dvec3& place, double radius) const;
    /// The largest radius at which all images are in a box.
    double radiusIn(const Extent& box) const;
    bool isOnAxis(std::uint32_t position) const { return next[position] == position; }
    /// Returns the number of turns between the images of a collapse that may be done together: none of them
    /// goes where another goes away from. 0: there is none, the levels are round no more.
    std::uint32_t stepFor(std::uint32_t from, std::uint32_t to) const;
};

/// Finds the rotation by the least turn about an axis of the frame through the mean of the positions that
/// maps all positions and faces of a mesh on others; at least by a fifth. Cost: n log n for each axis; little
/// where the mesh is not round.
RotationOrbits rotationOrbits(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

} // namespace osgPMObjects::core
