// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

/// From which side faces are visible from outside.
struct Openness
{
    double value = 0.0;      ///< 1 only from their fronts, -1 only from their backs, 0 from both alike
    bool isCutShort = false; ///< some rays were left out, since they would have looked at too many faces
};

/// Measures from which side some faces are visible from outside.
/// Rays start at points spread over the faces, `rays` in all, in directions spread over the half-space before
/// each; both are the same every time. Work is limited: rays that would look at more than `boxesARay` boxes
/// of the tree each, on average, are left out.
/// Source: Takayama, Jacobson, Kavan and Sorkine-Hornung, *A simple method for correcting facet orientations
/// in polygon meshes based on ray casting* (2014), section 3: the front is the more visible side. Differs:
/// decided by patch, not by face.
Openness openness(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                  std::span<const std::uint32_t> patch, const TriangleTree& tree, int rays,
                  std::uint64_t boxesARay);

} // namespace osgPMObjects::core
