// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/PointGrid.h>

namespace osgPMObjects::core
{

/// Positions this near are the same where symmetry is asked for; the diagonal is 1. Files have rounded
/// floats.
constexpr double kSamePlace = 1e-6;

/// A grid of positions for positionAt().
inline PointGrid samePlaceGrid(std::span<const glm::dvec3> positions)
{
    PointGrid grid(4.0 * kSamePlace, positions.size());
    for (const glm::dvec3& p : positions)
        grid.add(p);
    return grid;
}

/// Returns the position nearest to a point; ~0 where none is within kSamePlace.
inline std::uint32_t positionAt(const glm::dvec3& place, std::span<const glm::dvec3> positions,
                                const PointGrid& grid)
{
    std::uint32_t nearest = ~0u;
    double least = kSamePlace;
    grid.visitBox(place - kSamePlace, place + kSamePlace,
                  [&](std::uint32_t p)
                  {
                      const double distance = glm::distance(positions[p], place);
                      if (distance < least) least = distance, nearest = p;
                  });
    return nearest;
}

} // namespace osgPMObjects::core
