// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/simplify/SupportVertices.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kMostDivisions = 1024;

/// Squared distances of a cell's support vertices from its centre.
struct Reach
{
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -1.0;
};

} // namespace

OctreeDivisions OctreeDivisions::ofDepth(std::uint32_t depth)
{
    const std::uint32_t count = 1u << std::min(depth, 10u);
    return {{count, count, count}};
}

bool OctreeDivisions::isValid() const
{
    return std::all_of(counts.begin(), counts.end(),
                       [](std::uint32_t k) { return std::has_single_bit(k) && k <= kMostDivisions; });
}

std::array<std::uint32_t, 3> cellOf(const glm::dvec3& point, const Extent& box,
                                    const OctreeDivisions& divisions)
{
    std::array<std::uint32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis)
    {
        const double size = box.high[axis] - box.low[axis];
        if (!(size > 0.0)) continue;
        const double last = divisions.counts[axis] - 1;
        const double at = std::floor((point[axis] - box.low[axis]) / size * divisions.counts[axis]);
        cell[axis] = static_cast<std::uint32_t>(std::clamp(at, 0.0, last));
    }
    return cell;
}

glm::dvec3 centreOf(const std::array<std::uint32_t, 3>& cell, const Extent& box,
                    const OctreeDivisions& divisions)
{
    glm::dvec3 centre;
    for (int axis = 0; axis < 3; ++axis)
        centre[axis] =
            box.low[axis] + (cell[axis] + 0.5) / divisions.counts[axis] * (box.high[axis] - box.low[axis]);
    return centre;
}

std::vector<bool> supportVertices(const Mesh& mesh, const OctreeDivisions& divisions, SupportRule rule)
{
    assert(divisions.isValid());
    std::vector<bool> isSupport(mesh.positions.size(), false), isUsed(mesh.positions.size(), false);
    if (rule == SupportRule::none) return isSupport;
    Extent box;
    for (const Face& face : mesh.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            isUsed[mesh.positionOf(face, corner)] = true;
            box.add(mesh.at(face, corner));
        }
    const auto squared = [&](const glm::dvec3& p, const std::array<std::uint32_t, 3>& cell)
    {
        const glm::dvec3 away = p - centreOf(cell, box, divisions);
        return glm::dot(away, away);
    };
    std::map<std::array<std::uint32_t, 3>, Reach> cells;
    for (std::size_t i = 0; i < isUsed.size(); ++i)
    {
        if (!isUsed[i]) continue;
        const auto cell = cellOf(mesh.positions[i], box, divisions);
        Reach& reach = cells[cell];
        reach.nearest = std::min(reach.nearest, squared(mesh.positions[i], cell));
        reach.farthest = std::max(reach.farthest, squared(mesh.positions[i], cell));
    }
    for (std::size_t i = 0; i < isUsed.size(); ++i)
    {
        if (!isUsed[i]) continue;
        const auto cell = cellOf(mesh.positions[i], box, divisions);
        const double d = squared(mesh.positions[i], cell);
        isSupport[i] = d == cells[cell].farthest ||
                       (rule == SupportRule::farthestAndNearest && d == cells[cell].nearest);
    }
    return isSupport;
}

} // namespace osgPMObjects::core
