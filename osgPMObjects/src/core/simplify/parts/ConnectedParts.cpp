// SPDX-License-Identifier: Apache-2.0
#include "ConnectedParts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>
#include <osgPMObjects/core/mesh/UnionFind.h>

#include "MaterialContrast.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kReachSamples = 8;

struct FaceTree
{
    std::span<const glm::dvec3> positions;
    std::span<const Triangle> triangles;
    TriangleTree tree{positions, triangles};
};

double doubleAreaOf(std::span<const glm::dvec3> p, const Triangle& t)
{
    return glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
}

/// Assigns each material to the part with the largest area of it, which keeps its last face.
void keepMaterials(const Mesh& mesh, std::span<const glm::dvec3> positions,
                   std::span<const glm::vec3> colours, std::span<const std::uint32_t> numbers,
                   std::vector<ConnectedPart>& parts)
{
    struct Share
    {
        double area = 0.0;
        std::uint32_t faces = 0;
    };
    std::vector<std::map<std::uint32_t, Share>> shares(mesh.materials.size()); // by material and part
    std::vector<double> areas(mesh.materials.size(), 0.0);
    for (const Face& face : mesh.faces)
    {
        const Triangle t{mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)};
        if (repeatsCorner(t)) continue;
        Share& share = shares[face.material][numbers[t[0]]];
        share.area += doubleAreaOf(positions, t);
        areas[face.material] += doubleAreaOf(positions, t);
        ++share.faces;
    }
    const std::vector<double> contrasts = materialContrasts(mesh.materials, colours, areas);
    for (std::uint32_t material = 0; material < shares.size(); ++material)
    {
        const auto most =
            std::max_element(shares[material].begin(), shares[material].end(),
                             [](const auto& a, const auto& b) { return a.second.area < b.second.area; });
        if (most == shares[material].end()) continue;
        parts[most->first].kept.push_back(
            {material, most->second.faces, areas[material], contrasts[material]});
    }
}

/// Returns the distance from a point to the nearest face of another part; `most` where none is nearer.
double distanceToOthers(const glm::dvec3& point, double most, std::uint32_t part,
                        std::span<const std::uint32_t> numbers, const FaceTree& faces)
{
    double squared = most * most;
    faces.tree.visitNear(point, squared,
                         [&](std::uint32_t number)
                         {
                             const Triangle& t = faces.triangles[number];
                             if (numbers[t[0]] == part) return;
                             const glm::dvec3 away =
                                 point - nearestPoint(point, faces.positions[t[0]], faces.positions[t[1]],
                                                      faces.positions[t[2]]);
                             squared = std::min(squared, glm::dot(away, away));
                         });
    return std::sqrt(squared);
}

double sizeOf(const ConnectedPart& part, std::span<const glm::dvec3> positions)
{
    Extent extent;
    for (const std::uint32_t p : part.positions)
        extent.add(positions[p]);
    return extent.diagonal();
}

/// Returns the largest distance of some of the part's positions from the nearest face of another part.
double reachOf(const ConnectedPart& part, std::uint32_t number, std::span<const std::uint32_t> numbers,
               const FaceTree& faces)
{
    const double size = 0.5 * sizeOf(part, faces.positions);
    const std::size_t step = std::max<std::size_t>(1, part.positions.size() / kReachSamples);
    double reach = 0.0;
    for (std::size_t i = 0; i < part.positions.size() && reach < size; i += step)
        reach = std::max(reach,
                         distanceToOthers(faces.positions[part.positions[i]], size, number, numbers, faces));
    return reach;
}

} // namespace

std::vector<ConnectedPart> connectedParts(const Mesh& mesh, std::span<const glm::dvec3> positions,
                                          std::span<const glm::vec3> colours)
{
    const std::vector<Triangle> triangles = properTriangles(mesh);
    UnionFind groups(positions.size());
    std::vector<bool> isUsed(positions.size(), false);
    for (const Triangle& t : triangles)
    {
        groups.join(t[0], t[1]);
        groups.join(t[0], t[2]);
        isUsed[t[0]] = isUsed[t[1]] = isUsed[t[2]] = true;
    }
    std::vector<ConnectedPart> parts;
    std::vector<std::uint32_t> numbers(positions.size(), ~0u);
    for (std::uint32_t p = 0; p < positions.size(); ++p)
    {
        if (!isUsed[p]) continue;
        const std::uint32_t root = groups.root(p); // the lowest member, which has its number already
        if (root == p) numbers[p] = static_cast<std::uint32_t>(parts.size()), parts.emplace_back();
        numbers[p] = numbers[root];
        parts[numbers[p]].positions.push_back(p);
    }
    for (const Triangle& t : triangles)
    {
        parts[numbers[t[0]]].doubleArea += doubleAreaOf(positions, t);
        ++parts[numbers[t[0]]].faces;
    }
    keepMaterials(mesh, positions, colours, numbers, parts);
    if (parts.size() < 2) // no other part
    {
        for (ConnectedPart& part : parts)
            part.reach = extentOf(positions).diagonal();
        return parts;
    }
    const FaceTree faces{positions, triangles};
    parallelShares(parts.size(), 16,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t i = first; i < last; ++i)
                           parts[i].reach = reachOf(parts[i], static_cast<std::uint32_t>(i), numbers, faces);
                   });
    return parts;
}

double meanSize(std::span<const ConnectedPart> parts, std::span<const glm::dvec3> positions)
{
    double area = 0.0, sum = 0.0;
    for (const ConnectedPart& part : parts)
    {
        area += part.doubleArea;
        sum += part.doubleArea * sizeOf(part, positions);
    }
    return area > 0.0 ? sum / area : 0.0;
}

std::vector<std::uint32_t> partNumbers(std::span<const ConnectedPart> parts, std::size_t positionCount)
{
    std::vector<std::uint32_t> numbers(positionCount, ~0u);
    for (std::uint32_t part = 0; part < parts.size(); ++part)
        for (const std::uint32_t position : parts[part].positions)
            numbers[position] = part;
    return numbers;
}

} // namespace osgPMObjects::core
