// SPDX-License-Identifier: Apache-2.0
#include "LeftRay.h"

#include <osgPMObjects/core/tessellate/Orientation.h>

namespace osgPMObjects::core
{

namespace
{

/// Tells which of two edges the ray hits first: whether `f` lies right of `e` there.
bool isNearer(std::span<const glm::dvec2> points, const UprightEdge& f, const UprightEdge& e)
{
    if (e.low == f.low) return orientation(points[e.low], points[e.high], points[f.high]) < 0.0;
    if (points[f.low].y >= points[e.low].y)
        return orientation(points[e.low], points[e.high], points[f.low]) < 0.0;
    return orientation(points[f.low], points[f.high], points[e.low]) > 0.0;
}

} // namespace

std::optional<std::size_t> firstEdgeLeft(std::span<const glm::dvec2> points,
                                         std::span<const UprightEdge> edges, const glm::dvec2& from)
{
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
        const glm::dvec2 &low = points[edges[i].low], &high = points[edges[i].high];
        if (low.y > from.y || high.y <= from.y) continue;
        if (low.x > from.x && high.x > from.x) continue;
        if (orientation(low, high, from) >= 0.0) continue;
        if (!first || isNearer(points, edges[i], edges[*first])) first = i;
    }
    return first;
}

} // namespace osgPMObjects::core
