// SPDX-License-Identifier: Apache-2.0
#include "Star.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

void Star::gather(const StarMesh& mesh, std::span<const glm::dvec3> positions, std::uint32_t position)
{
    middle = position;
    faces.clear();
    sides.clear();
    neighbours.clear();
    mesh.visitStar(
        position,
        [&](std::uint32_t face, int corner)
        {
            const Triangle& p = mesh.positions(face);
            Spoked spoked{
                face, mesh.wedges(face)[corner], p[(corner + 1) % 3], p[(corner + 2) % 3], glm::dvec3(0.0),
                0.0};
            const glm::dvec3 normal = glm::cross(positions[spoked.second] - positions[position],
                                                 positions[spoked.third] - positions[position]);
            spoked.doubleArea = glm::length(normal);
            if (spoked.doubleArea > 0.0) spoked.normal = normal / spoked.doubleArea;
            const auto number = static_cast<std::uint32_t>(faces.size());
            sides.push_back({spoked.second, number});
            sides.push_back({spoked.third, number});
            faces.push_back(spoked);
        });
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.to != b.to ? a.to < b.to : a.spoked < b.spoked; });
    for (const Side& side : sides)
        if (neighbours.empty() || neighbours.back() != side.to) neighbours.push_back(side.to);
}

std::span<const Star::Side> Star::sidesFrom(std::size_t at) const
{
    std::size_t end = at;
    while (end < sides.size() && sides[end].to == sides[at].to)
        ++end;
    return {sides.data() + at, end - at};
}

std::span<const Star::Side> Star::sidesTo(std::uint32_t to) const
{
    const auto first = std::lower_bound(sides.begin(), sides.end(), to,
                                        [](const Side& side, std::uint32_t t) { return side.to < t; });
    if (first == sides.end() || first->to != to) return {};
    return sidesFrom(static_cast<std::size_t>(first - sides.begin()));
}

} // namespace osgPMObjects::core
