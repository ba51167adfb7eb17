// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// The mirror symmetry of a mesh, complete or nearly so, in a plane through the middle of its box across an
/// axis: the mirror image of each position. Collapses on one side only would make a fuselage, a wheel or a
/// person asymmetric.
struct MirrorTwins
{
    static constexpr std::uint32_t kNone = ~0u;

    int axis = -1;                     ///< normal of the plane; -1: not symmetric
    std::vector<std::uint32_t> twinOf; ///< by position: its image; itself: in the plane; empty: not symmetric

    bool isMirrored() const { return axis >= 0; }
    std::uint32_t of(std::uint32_t position) const { return isMirrored() ? twinOf[position] : kNone; }
    bool isInPlane(std::uint32_t position) const { return of(position) == position; }

    /// The mirror image of a point, in a frame with its origin in the middle of the box.
    glm::dvec3 image(glm::dvec3 p) const
    {
        p[axis] = -p[axis];
        return p;
    }
};

/// Finds the plane of symmetry; of several, the one across which most faces, then most positions, have an
/// image other than themselves.
/// `positions`: in a frame with its origin in the middle of their box, whose diagonal is 1. Cost: n log n.
MirrorTwins mirrorTwins(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

} // namespace osgPMObjects::core
