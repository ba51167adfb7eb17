// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/EarClipping.h>

namespace osgPMObjects::core
{

/// A mesh whose edges are no longer than a given length.
struct UniformMesh
{
    std::vector<glm::dvec3> positions; ///< the given ones, then the midpoints
    std::vector<std::array<std::uint32_t, 2>>
        midpointOf; ///< by midpoint: the two positions that it is halfway between
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> origin; ///< by triangle: the given triangle that it is a part of
};

/// Halves every edge that is longer than `longestEdge`, until none is. The result depends on the positions of
/// an edge's ends alone, so triangles that share an edge divide it alike, also in other calls and in the
/// opposite direction. The attributes of a midpoint are the mean of those of its two positions.
/// Units: `longestEdge` in those of the positions. Cost: linear in the result.
/// Errors: a length that is not above zero; more than `mostTriangles` triangles.
/// Source: Jin, *Polygon Techniques*, "uniform meshing" (for lighting at vertices) and "edge stitching"
/// (shared edges).
foundation::Result<UniformMesh> meshUniformly(std::span<const glm::dvec3> positions,
                                              std::span<const Triangle> triangles, double longestEdge,
                                              std::uint32_t mostTriangles = 10'000'000);

} // namespace osgPMObjects::core
