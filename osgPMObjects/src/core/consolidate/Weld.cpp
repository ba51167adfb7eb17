// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/PointGrid.h>

namespace osgPMObjects::core
{

namespace
{

/// Cell size in tolerances: then few search balls reach into a second cell, and hardly any cell has two
/// remaining positions.
constexpr double kCell = 16.0;

} // namespace

std::size_t weldPositions(Mesh& mesh, double tolerance)
{
    if (mesh.positions.empty() || !(tolerance >= 0.0)) return 0;
    const double smallestCell = extentOf(mesh.positions).diagonal() / (1 << 20);
    PointGrid grid(std::max({kCell * tolerance, smallestCell, 1e-300}), mesh.positions.size());
    std::vector<std::uint32_t> kept;   // by number in the grid
    std::vector<std::uint32_t> joined; // by position
    joined.reserve(mesh.positions.size());
    for (std::uint32_t p = 0; p < mesh.positions.size(); ++p)
    {
        const glm::dvec3 where = mesh.positions[p];
        double nearest = tolerance;
        std::uint32_t target = p;
        grid.visitBox(where - tolerance, where + tolerance,
                      [&](std::uint32_t number)
                      {
                          const double distance = glm::length(mesh.positions[kept[number]] - where);
                          if (distance > nearest || (distance == nearest && target < kept[number])) return;
                          nearest = distance;
                          target = kept[number];
                      });
        joined.push_back(target);
        if (target != p) continue;
        kept.push_back(p);
        grid.add(where);
    }
    for (std::uint32_t& position : mesh.wedgePositions)
        position = joined[position];
    return mesh.positions.size() - kept.size();
}

} // namespace osgPMObjects::core
