// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/BoxArea.h>
#include <osgPMObjects/core/selection/BoxOutlines.h>

namespace osgPMObjects::core
{

namespace
{

/// Projects a point to homogeneous pixel coordinates.
glm::dvec3 homogeneousPx(const SelectionView& view, const glm::dvec3& fromEye)
{
    return {glm::dot(view.acrossPx, fromEye), glm::dot(view.upPx, fromEye), glm::dot(view.forward, fromEye)};
}

} // namespace

std::uint32_t regionOf(const OrientedBox& box, const glm::dvec3& eyeWorld)
{
    const glm::dvec3 fromCentre = eyeWorld - box.centre;
    std::uint32_t region = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double along = glm::dot(box.axes[axis], fromCentre);
        if (along < -box.halfSizes[axis]) region |= 1u << 2 * axis;
        if (along > box.halfSizes[axis]) region |= 2u << 2 * axis;
    }
    return region;
}

double boxAreaPx(const SelectionView& view, const OrientedBox& box)
{
    const glm::dvec3 centre = homogeneousPx(view, box.centre - view.eyeWorld);
    std::array<glm::dvec3, 3> half;
    double reach = 0.0; // depth of the centre minus depth of the nearest corner
    for (int axis = 0; axis < 3; ++axis)
    {
        half[axis] = homogeneousPx(view, box.axes[axis] * box.halfSizes[axis]);
        reach += std::abs(half[axis].z);
    }
    if (centre.z - reach < view.nearM) return kFullArea;
    const BoxOutline& outline = kBoxOutlines[regionOf(box, view.eyeWorld)];
    if (outline.count == 0) return kFullArea;

    std::array<glm::dvec2, 6> at;
    for (std::uint32_t i = 0; i < outline.count; ++i)
    {
        glm::dvec3 corner = centre;
        for (int axis = 0; axis < 3; ++axis)
            corner += outline.corners[i] >> axis & 1 ? half[axis] : -half[axis];
        at[i] = glm::dvec2(corner) / corner.z;
    }
    // Relative to the first corner, so that large coordinates do not cost precision.
    double twice = 0.0;
    for (std::uint32_t i = 1; i + 1 < outline.count; ++i)
    {
        const glm::dvec2 a = at[i] - at[0], b = at[i + 1] - at[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(0.5 * twice);
}

} // namespace osgPMObjects::core
