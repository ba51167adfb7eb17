// SPDX-License-Identifier: Apache-2.0
#include "EdgeCrossing.h"

#include <cmath>

#include <foundation/NearestOnSegment.h>

namespace osgPMObjects::core
{

glm::dvec2 onGrid(const glm::dvec2& point, double grid)
{
    return glm::round(point / grid) * grid + 0.0; // + 0.0: no negative zero
}

glm::dvec2 crossingOf(std::span<const glm::dvec2> points, const EdgeEnds& first, const EdgeEnds& second,
                      double grid)
{
    const glm::dvec2 &a = points[first[0]], &b = points[first[1]];
    const glm::dvec2 &c = points[second[0]], &d = points[second[1]];
    const glm::dvec2 along = b - a, other = d - c, between = c - a;
    const double determinant = along.x * other.y - along.y * other.x;
    const double share = (between.x * other.y - between.y * other.x) / determinant;
    const glm::dvec2 low = glm::max(glm::min(a, b), glm::min(c, d));
    const glm::dvec2 high = glm::min(glm::max(a, b), glm::max(c, d));
    const glm::dvec2 position = std::isfinite(share) ? a + along * share : (low + high) * 0.5;
    return onGrid(glm::clamp(position, low, high), grid);
}

InsertedPoint betweenCorners(std::span<const glm::dvec2> corners, const std::array<EdgeEnds, 2>& edges,
                             const glm::dvec2& position)
{
    InsertedPoint inserted;
    for (int edge = 0; edge < 2; ++edge)
    {
        const auto [begin, end] = edges[edge];
        const double share = foundation::nearestShare(position, corners[begin], corners[end]);
        inserted.corners[2 * edge] = begin;
        inserted.corners[2 * edge + 1] = end;
        inserted.weights[2 * edge] = 0.5 * (1.0 - share);
        inserted.weights[2 * edge + 1] = 0.5 * share;
    }
    return inserted;
}

} // namespace osgPMObjects::core
