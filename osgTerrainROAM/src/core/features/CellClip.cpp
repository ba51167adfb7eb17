// SPDX-License-Identifier: Apache-2.0
#include "CellClip.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Keeps the part of a ring on the side of `border` that `sign` points to.
Ring clippedToSide(const Ring& ring, int axis, double border, double sign)
{
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2& a = ring[i];
        const glm::dvec2& b = ring[(i + 1) % ring.size()];
        const double fromA = sign * (a[axis] - border);
        const double fromB = sign * (b[axis] - border);
        if (fromA >= 0.0) kept.push_back(a);
        if ((fromA >= 0.0) == (fromB >= 0.0)) continue;
        glm::dvec2 crossing = glm::mix(a, b, fromA / (fromA - fromB));
        crossing[axis] = border; // exact, so that border edges are recognised
        kept.push_back(crossing);
    }
    return kept;
}

} // namespace

std::vector<Ring> clippedToBand(const std::vector<Ring>& rings, int axis, double low, double high)
{
    std::vector<Ring> kept;
    for (const Ring& ring : rings)
    {
        Ring clipped = clippedToSide(clippedToSide(ring, axis, low, 1.0), axis, high, -1.0);
        if (clipped.size() >= 3) kept.push_back(std::move(clipped));
    }
    return kept;
}

} // namespace osgTerrainROAM::core
