// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

/// Measures from which side some faces are visible from outside: 1 only from their fronts, -1 only from their backs, 0 from both
/// alike.
/// Rays start at points spread over the faces, `rays` in all, in directions spread over the half-space before each; both are
/// the same every time.
/// Source: Takayama, Jacobson, Kavan and Sorkine-Hornung, *A simple method for correcting facet orientations in polygon meshes
/// based on ray casting* (2014), section 3: the front is the more visible side. Differs: decided by patch, not by face.
double openness(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                std::span<const std::uint32_t> patch, const TriangleTree& tree, int rays);

} // namespace osgPMObjects::core
