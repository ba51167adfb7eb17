// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/consolidate/Orient.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>
#include <osgPMObjects/core/mesh/UnionFind.h>

namespace osgPMObjects::core
{

namespace
{

/// The least volume of a group, as a share of that of a cube with the same area; below, it is flat.
constexpr double kFlat = 1e-6;

/// A set of faces connected by edges with two faces.
struct Group
{
    std::vector<std::uint32_t> faces;
    Extent extent;
    double volume = 0.0;
    double area = 0.0;
    bool isClosed = true;

    bool isInsideOut() const { return isClosed && volume < -kFlat * std::pow(area / 6.0, 1.5); }
};

std::vector<Group> groupsOf(const Mesh& mesh)
{
    const std::vector<Triangle> triangles = positionTriangles(mesh);
    const EdgeTable edges(triangles, mesh.positions.size());
    UnionFind joined(triangles.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        if (edges.sides(e).size() == 2) joined.join(faceOf(edges.sides(e)[0]), faceOf(edges.sides(e)[1]));

    std::vector<Group> groups;
    std::vector<std::uint32_t> groupOfRoot(triangles.size());
    for (std::uint32_t f = 0; f < triangles.size(); ++f)
    {
        const std::uint32_t root = joined.root(f);
        if (root == f)
        {
            groupOfRoot[f] = static_cast<std::uint32_t>(groups.size());
            groups.emplace_back();
        }
        Group& group = groups[groupOfRoot[root]];
        // Volume about a point of the group: far from the origin the terms would cancel.
        const glm::dvec3 origin = group.faces.empty() ? mesh.positions[triangles[f][0]]
                                                      : mesh.positions[triangles[group.faces[0]][0]];
        group.faces.push_back(f);
        const glm::dvec3 a = mesh.positions[triangles[f][0]] - origin,
                         b = mesh.positions[triangles[f][1]] - origin,
                         c = mesh.positions[triangles[f][2]] - origin;
        group.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        group.area += glm::length(glm::cross(b - a, c - a)) / 2.0;
        for (int i = 0; i < 3; ++i)
        {
            group.extent.add(mesh.positions[triangles[f][i]]);
            const std::uint32_t edge = edges.edgeOf(3 * f + static_cast<HalfEdge>(i));
            group.isClosed = group.isClosed && edge != EdgeTable::kNone && edges.sides(edge).size() == 2;
        }
    }
    return groups;
}

/// A direction near +x that meets no edge of axis-aligned buildings.
const glm::dvec3 kAskew(1.0, 0.00372913, 0.00781521);

bool isInside(const Mesh& mesh, const glm::dvec3& point, const Group& group)
{
    bool inside = false;
    for (const std::uint32_t f : group.faces)
        if (const Face& face = mesh.faces[f];
            rayDistance(point, kAskew, mesh.at(face, 0), mesh.at(face, 1), mesh.at(face, 2)) > 0.0)
            inside = !inside;
    return inside;
}

/// Whether a group is inside another closed one, as the inner wall of a hollow body.
bool isCavity(const Mesh& mesh, const Group& group, const std::vector<Group>& groups)
{
    const glm::dvec3 point = mesh.at(mesh.faces[group.faces[0]], 0);
    for (const Group& other : groups)
        if (&other != &group && other.isClosed && std::abs(other.volume) > std::abs(group.volume) &&
            other.extent.contains(group.extent) && isInside(mesh, point, other))
            return true;
    return false;
}

} // namespace

InsideOut turnInsideOut(Mesh& mesh)
{
    const std::vector<Group> groups = groupsOf(mesh);
    InsideOut report;
    std::vector<const Group*> wrong;
    for (const Group& group : groups)
    {
        report.closedGroups += group.isClosed;
        if (!group.isInsideOut()) continue;
        if (isCavity(mesh, group, groups))
            ++report.cavities;
        else
            wrong.push_back(&group);
    }
    for (const Group* group : wrong)
        for (const std::uint32_t f : group->faces)
            turnFace(mesh, f, true);
    report.turnedGroups = wrong.size();
    return report;
}

} // namespace osgPMObjects::core
