// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/LightChange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <glm/glm.hpp>

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;
using Normals = std::unordered_map<std::uint64_t, glm::dvec3>; // by place on the grid

Normals normalsOf(const DrawnMesh& mesh)
{
    Normals normals;
    normals.reserve(mesh.triangles.size());
    for (const LeafTriangle& t : mesh.triangles)
    {
        if (mesh.isSunk(t)) continue; // it belongs to no surface that is lit
        const glm::dvec3 a = mesh.position(t.vertices[0]);
        const glm::dvec3 across =
            glm::cross(mesh.position(t.vertices[1]) - a, mesh.position(t.vertices[2]) - a);
        for (const std::uint32_t v : t.vertices)
        {
            const GridPoint p = mesh.grid[v];
            normals[static_cast<std::uint64_t>(p.row) << 32 | static_cast<std::uint32_t>(p.column)] += across;
        }
    }
    return normals;
}

} // namespace

LightChange lightChangeBetween(const DrawnMesh& before, const DrawnMesh& now)
{
    const Normals was = normalsOf(before), is = normalsOf(now);
    std::size_t common = 0, turned = 0;
    LightChange change;
    for (const auto& [place, normal] : is)
    {
        const auto old = was.find(place);
        if (old == was.end() || glm::length(old->second) == 0.0 || glm::length(normal) == 0.0) continue;
        ++common;
        const double cosine = glm::dot(glm::normalize(old->second), glm::normalize(normal));
        const double deg = glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
        turned += deg > kSeenDeg ? 1 : 0;
        change.largestDeg = std::max(change.largestDeg, deg);
    }
    if (common > 0) change.turnedPercent = 100.0 * static_cast<double>(turned) / static_cast<double>(common);
    return change;
}

} // namespace terraintool
