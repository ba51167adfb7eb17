// SPDX-License-Identifier: Apache-2.0
#include "CellClip.h"

#include <algorithm>

namespace osgTerrainROAM::core
{

namespace
{

/// Keeps what is on the side of `border` that `sign` points to.
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
        crossing[axis] = border; // exactly, so that it is known for a border
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

bool segmentMeetsBox(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& low, const glm::dvec2& high)
{
    double enters = 0.0, leaves = 1.0;
    for (int axis = 0; axis < 2; ++axis)
    {
        const double way = b[axis] - a[axis];
        if (way == 0.0)
        {
            if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
            continue;
        }
        const double atLow = (low[axis] - a[axis]) / way, atHigh = (high[axis] - a[axis]) / way;
        enters = std::max(enters, std::min(atLow, atHigh));
        leaves = std::min(leaves, std::max(atLow, atHigh));
    }
    return enters <= leaves;
}

} // namespace osgTerrainROAM::core
