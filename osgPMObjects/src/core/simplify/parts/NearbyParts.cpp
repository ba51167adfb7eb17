// SPDX-License-Identifier: Apache-2.0
#include "NearbyParts.h"

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/PointGrid.h>

namespace osgPMObjects::core
{

std::vector<std::uint32_t> nearestOfOtherParts(std::span<const glm::dvec3> positions,
                                               std::span<const std::uint32_t> partOf, double distance)
{
    constexpr std::uint32_t kNone = ~0u;
    PointGrid grid(distance, positions.size());
    for (const glm::dvec3& p : positions)
        grid.add(p);
    std::vector<std::uint32_t> nearest(positions.size(), kNone);
    const auto find = [&](std::uint32_t p)
    {
        double least = distance;
        grid.visitBox(positions[p] - distance, positions[p] + distance,
                      [&](std::uint32_t other)
                      {
                          if (partOf[other] == kNone || partOf[other] == partOf[p]) return;
                          const double away = glm::distance(positions[p], positions[other]);
                          if (away < least || (away == least && other < nearest[p]))
                              least = away, nearest[p] = other;
                      });
    };
    parallelShares(positions.size(), 4096,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t p = first; p < last; ++p)
                           if (partOf[p] != kNone) find(static_cast<std::uint32_t>(p));
                   });
    return nearest;
}

} // namespace osgPMObjects::core
