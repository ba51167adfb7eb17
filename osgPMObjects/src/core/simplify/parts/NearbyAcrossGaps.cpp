// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <queue>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/PointGrid.h>

#include "NearbyParts.h"

namespace osgPMObjects::core
{

namespace
{

/// A way that is longer than this times the gap leads around it.
constexpr double kAroundGap = 3.0;

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours neighboursOf(std::size_t positions, std::span<const Triangle> triangles)
{
    Neighbours neighbours(positions);
    for (const Triangle& t : triangles)
        for (int corner = 0; corner < 3; ++corner)
        {
            neighbours[t[corner]].push_back(t[(corner + 1) % 3]);
            neighbours[t[corner]].push_back(t[(corner + 2) % 3]);
        }
    return neighbours;
}

/// Returns the positions to which a way of at most `most` along edges leads, with its length.
std::unordered_map<std::uint32_t, double>
waysFrom(std::uint32_t from, double most, std::span<const glm::dvec3> positions, const Neighbours& neighbours)
{
    std::unordered_map<std::uint32_t, double> ways{{from, 0.0}};
    std::priority_queue<std::pair<double, std::uint32_t>> open;
    open.push({0.0, from});
    while (!open.empty())
    {
        const auto [negative, at] = open.top();
        open.pop();
        if (-negative > ways[at]) continue;
        for (const std::uint32_t next : neighbours[at])
        {
            const double way = glm::distance(positions[at], positions[next]) - negative;
            const auto known = ways.find(next);
            if (way > most || (known != ways.end() && known->second <= way)) continue;
            ways[next] = way;
            open.push({-way, next});
        }
    }
    return ways;
}

} // namespace

std::vector<std::uint32_t> nearestAcrossGaps(std::span<const glm::dvec3> positions,
                                             std::span<const Triangle> triangles, double distance)
{
    constexpr std::uint32_t kNone = ~0u;
    const Neighbours neighbours = neighboursOf(positions.size(), triangles);
    PointGrid grid(distance, positions.size());
    for (const glm::dvec3& p : positions)
        grid.add(p);
    std::vector<std::uint32_t> nearest(positions.size(), kNone);
    const auto find = [&](std::uint32_t p)
    {
        const auto ways = waysFrom(p, kAroundGap * distance, positions, neighbours);
        double least = distance;
        grid.visitBox(positions[p] - distance, positions[p] + distance,
                      [&](std::uint32_t other)
                      {
                          if (neighbours[other].empty() || ways.contains(other)) return;
                          const double away = glm::distance(positions[p], positions[other]);
                          if (away < least || (away == least && other < nearest[p]))
                              least = away, nearest[p] = other;
                      });
    };
    parallelShares(positions.size(), 1024,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t p = first; p < last; ++p)
                           if (!neighbours[p].empty()) find(static_cast<std::uint32_t>(p));
                   });
    return nearest;
}

} // namespace osgPMObjects::core
