// SPDX-License-Identifier: Apache-2.0
#include "HalfEdges.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <osgPMObjects/core/tessellate/Orientation.h>

#include "LeftRay.h"

namespace osgPMObjects::core
{

HalfEdges::HalfEdges(const NodedEdges& noded) : _noded(noded), _clockwise(size())
{
    std::vector<std::uint32_t> byOrigin(size());
    std::iota(byOrigin.begin(), byOrigin.end(), 0u);
    std::sort(byOrigin.begin(), byOrigin.end(),
              [this](std::uint32_t a, std::uint32_t b)
              { return std::pair(origin(a), a) < std::pair(origin(b), b); });
    for (std::size_t first = 0; first < byOrigin.size();)
    {
        std::size_t end = first;
        while (end < byOrigin.size() && origin(byOrigin[end]) == origin(byOrigin[first]))
            ++end;
        sortAround(std::span(byOrigin).subspan(first, end - first));
        first = end;
    }
}

void HalfEdges::sortAround(std::span<std::uint32_t> fan)
{
    const glm::dvec2& centre = position(origin(fan.front()));
    const auto isUpper = [&](const glm::dvec2& p)
    { return p.y > centre.y || (p.y == centre.y && p.x > centre.x); };
    std::sort(fan.begin(), fan.end(),
              [&](std::uint32_t a, std::uint32_t b)
              {
                  const glm::dvec2 &p = position(target(a)), &q = position(target(b));
                  if (isUpper(p) != isUpper(q)) return isUpper(p);
                  return orientation(centre, p, q) > 0.0;
              });
    for (std::size_t i = 0; i < fan.size(); ++i)
        _clockwise[fan[i]] = fan[(i + fan.size() - 1) % fan.size()];
}

namespace
{

/// Spreads winding numbers from a half-edge over its connected component.
void spread(const HalfEdges& halves, std::uint32_t first, std::vector<std::int32_t>& winding,
            std::vector<char>& isKnown)
{
    std::vector<std::uint32_t> open{first};
    isKnown[first] = 1;
    const auto reach = [&](std::uint32_t half, std::int32_t number)
    {
        if (std::exchange(isKnown[half], 1)) return;
        winding[half] = number;
        open.push_back(half);
    };
    while (!open.empty())
    {
        const std::uint32_t half = open.back();
        open.pop_back();
        reach(halves.next(half), winding[half]);
        reach(half ^ 1u, winding[half] - halves.windingStep(half));
    }
}

} // namespace

std::vector<std::int32_t> windingNumbers(const HalfEdges& halves)
{
    std::vector<std::int32_t> winding(halves.size());
    std::vector<char> isKnown(halves.size(), 0);
    // From left to right: the region left of a component's leftmost point is known when it is reached.
    std::vector<std::uint32_t> byPlace(halves.size());
    std::iota(byPlace.begin(), byPlace.end(), 0u);
    std::sort(byPlace.begin(), byPlace.end(),
              [&](std::uint32_t a, std::uint32_t b)
              {
                  const glm::dvec2 &p = halves.position(halves.origin(a)),
                                   &q = halves.position(halves.origin(b));
                  return std::tie(p.x, p.y, a) < std::tie(q.x, q.y, b);
              });
    std::vector<UprightEdge> edges;
    std::vector<std::uint32_t> downward; // the half-edge of each edge whose left side faces right
    for (std::uint32_t half = 0; half < halves.size(); ++half)
        if (halves.position(halves.origin(half)).y > halves.position(halves.target(half)).y)
        {
            edges.push_back({halves.target(half), halves.origin(half)});
            downward.push_back(half);
        }
    for (const std::uint32_t half : byPlace)
    {
        if (isKnown[half]) continue;
        // All edges at the leftmost point of a component lead to the right. The last of them,
        // counter-clockwise, has the outside of the component on its left.
        std::uint32_t last = half;
        for (std::uint32_t other = halves.clockwise(half); other != half; other = halves.clockwise(other))
            if (orientation(halves.position(halves.origin(half)), halves.position(halves.target(last)),
                            halves.position(halves.target(other))) > 0.0)
                last = other;
        const auto edge = firstEdgeLeft(halves.points(), edges, halves.position(halves.origin(half)));
        winding[last] = edge ? winding[downward[*edge]] : 0;
        spread(halves, last, winding, isKnown);
    }
    return winding;
}

} // namespace osgPMObjects::core
