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

/// Triangles none of whose edges is longer than was asked.
struct UniformMesh
{
    std::vector<glm::dvec3> positions; ///< those that were given, then the midpoints
    std::vector<std::array<std::uint32_t, 2>>
        midpointOf; ///< of each further position: the two halfway between which it lies
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> origin; ///< by triangle: the one that was given, of which it is a part
};

/// Halves every edge that is longer than `longestEdge`, again and again. Whether an edge is divided, and where, hangs on
/// the places of its ends alone, so triangles that share one divide it alike, also in other calls and in either direction.
/// Attributes of a midpoint are the mean of those of its two positions.
/// Units: `longestEdge` in those of the positions. Cost: linear in the result.
/// Errors: an edge length that is not above zero; more than `mostTriangles`.
/// Source: paper 002, "uniform meshing" (for lighting at vertices) and "edge stitching" (shared edges).
foundation::Result<UniformMesh> meshUniformly(std::span<const glm::dvec3> positions,
                                              std::span<const Triangle> triangles, double longestEdge,
                                              std::uint32_t mostTriangles = 10'000'000);

} // namespace osgPMObjects::core
