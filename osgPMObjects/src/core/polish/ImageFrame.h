// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>

namespace osgPMObjects::core
{

/// The frame in which images of a mesh are drawn: its box has diagonal 1 and its middle at the origin.
/// Positions may leave the box, and are divided where UnitFrame multiplies: the choice among equal collapses
/// depends on the last bit.
struct ImageFrame
{
    glm::dvec3 middle{0.0}; ///< in the mesh's frame
    double diagonal = 1.0;  ///< length of the frame's unit, in units of the mesh

    explicit ImageFrame(std::span<const glm::dvec3> positions)
    {
        const Extent box = extentOf(positions);
        if (box.isEmpty()) return;
        middle = 0.5 * (box.low + box.high);
        if (box.diagonal() > 0.0) diagonal = box.diagonal();
    }

    glm::dvec3 in(const glm::dvec3& position) const { return (position - middle) / diagonal; }
    glm::dvec3 out(const glm::dvec3& position) const { return position * diagonal + middle; }
};

} // namespace osgPMObjects::core
