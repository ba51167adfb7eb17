// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/TJunctions.h>
#include <osgPMObjects/core/mesh/UnionFind.h>
#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/mesh/WedgeHash.h>

namespace osgPMObjects::core
{

namespace
{

std::size_t countAttributeVertices(const Mesh& mesh)
{
    struct Vertex
    {
        std::uint32_t wedge, material;
    };
    std::vector<Vertex> vertices;
    HashIndex index(mesh.wedgeCount());
    const auto hashOf = [&](const Vertex& v) { return stir(hashWedge(wedgeOf(mesh, v.wedge)), v.material); };
    for (const Face& face : mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
        {
            const Vertex candidate{wedge, face.material};
            const auto next = static_cast<std::uint32_t>(vertices.size());
            const std::uint32_t found = index.findOrAdd(
                next, hashOf(candidate),
                [&](std::uint32_t i)
                {
                    const Vertex& known = vertices[i];
                    return known.material == candidate.material &&
                           (known.wedge == wedge || wedgeOf(mesh, known.wedge) == wedgeOf(mesh, wedge));
                },
                [&](std::uint32_t i) { return hashOf(vertices[i]); });
            if (found == next) vertices.push_back(candidate);
        }
    return vertices.size();
}

std::size_t countDuplicates(std::vector<Triangle> triangles)
{
    for (Triangle& t : triangles)
        t = sortedCorners(t);
    std::sort(triangles.begin(), triangles.end());
    return triangles.size() -
           static_cast<std::size_t>(std::unique(triangles.begin(), triangles.end()) - triangles.begin());
}

std::size_t countComponents(std::span<const Triangle> triangles, const std::vector<bool>& isUsed)
{
    UnionFind groups(isUsed.size());
    for (const Triangle& t : triangles)
    {
        groups.join(t[0], t[1]);
        groups.join(t[1], t[2]);
    }
    std::size_t count = 0;
    for (std::uint32_t p = 0; p < isUsed.size(); ++p)
        count += isUsed[p] && groups.root(p) == p;
    return count;
}

} // namespace

Triangle sortedCorners(Triangle t)
{
    std::sort(t.begin(), t.end());
    return t;
}

Extent extentOfFaces(const Mesh& mesh)
{
    Extent extent;
    for (const Face& face : mesh.faces)
        for (int corner = 0; corner < 3; ++corner)
            extent.add(mesh.at(face, corner));
    return extent;
}

std::vector<Triangle> properTriangles(const Mesh& mesh)
{
    std::vector<Triangle> triangles = positionTriangles(mesh);
    std::erase_if(triangles, repeatsCorner);
    return triangles;
}

MeshCounts countMesh(const Mesh& mesh)
{
    MeshCounts counts;
    counts.triangles = mesh.faces.size();
    counts.attributeVertices = countAttributeVertices(mesh);
    std::vector<Triangle> triangles = positionTriangles(mesh);
    std::vector<bool> isUsed(mesh.positions.size(), false);
    for (const Triangle& t : triangles)
        for (const std::uint32_t p : t)
            isUsed[p] = true;
    counts.positions = static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), true));
    counts.components = countComponents(triangles, isUsed);

    const double diagonal = diagonalOf(mesh);
    std::erase_if(triangles, repeatsCorner);
    counts.degenerates = mesh.faces.size() - triangles.size();
    const auto& at = mesh.positions;
    for (const Triangle& t : triangles)
        counts.degenerates += heightOf(at[t[0]], at[t[1]], at[t[2]]) <= kDegenerateHeight * diagonal;

    const EdgeTable edges(triangles, mesh.positions.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
    {
        counts.boundaryEdges += edges.isBoundary(e);
        counts.nonManifoldEdges += !edges.isManifold(e);
    }
    counts.tJunctions =
        countTVertices(mesh.positions, triangles, edges, kTJunctionTolerance * diagonal, OpenEdges::boundary);
    counts.duplicates = countDuplicates(std::move(triangles));
    return counts;
}

} // namespace osgPMObjects::core
