// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// A mesh that is its own mirror image, or nearly all of it, in a plane through the middle of its box across an axis: which position is whose
/// image. A fuselage, a wheel, a person: a collapse on one side without that on the other would make them lopsided.
struct MirrorTwins
{
    static constexpr std::uint32_t kNone = ~0u;

    int axis = -1;                     ///< the plane's normal; -1: no mirror image
    std::vector<std::uint32_t> twinOf; ///< by position; itself: in the plane; empty: no mirror image

    bool isMirrored() const { return axis >= 0; }
    std::uint32_t of(std::uint32_t position) const { return isMirrored() ? twinOf[position] : kNone; }
    bool isInPlane(std::uint32_t position) const { return of(position) == position; }

    /// In a frame whose origin is the middle of the box.
    glm::dvec3 image(glm::dvec3 p) const
    {
        p[axis] = -p[axis];
        return p;
    }
};

/// Looks for it; of several planes takes the one across which most faces, then most positions, have an image other than themselves.
/// `positions`: about the middle of their box, whose diagonal is 1. Cost: n log n.
MirrorTwins mirrorTwins(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

} // namespace osgPMObjects::core
