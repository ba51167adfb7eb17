// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/mesh/EqualWedges.h>
#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/order/TriangleOrders.h>

namespace osgPMObjects::core
{

namespace
{

/// The faces of a group, with their vertices (firstEqualWedges()) numbered from 0 in order of first use.
struct DrawnTogether
{
    std::vector<Triangle> triangles;
    std::vector<glm::dvec3> positions; ///< by vertex
};

DrawnTogether numbered(const Mesh& mesh, const std::vector<std::uint32_t>& vertexOfWedge,
                       const std::vector<std::size_t>& faces)
{
    DrawnTogether drawn;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    for (const std::size_t f : faces)
    {
        Triangle& t = drawn.triangles.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            const std::uint32_t vertex = vertexOfWedge[mesh.faces[f].wedges[corner]];
            const auto [at, isNew] =
                numbers.try_emplace(vertex, static_cast<std::uint32_t>(drawn.positions.size()));
            if (isNew) drawn.positions.push_back(mesh.positions[mesh.wedgePositions[vertex]]);
            t[corner] = at->second;
        }
    }
    return drawn;
}

} // namespace

void orderFaces(Mesh& mesh, FaceOrder order)
{
    if (order == FaceOrder::asTheyAre) return;
    orderFaces(mesh,
               [order](std::span<const Triangle> triangles, std::span<const glm::dvec3> positions)
               {
                   const auto vertexCount = static_cast<std::uint32_t>(positions.size());
                   switch (order)
                   {
                   case FaceOrder::universal:
                       return universalOrder(triangles);
                   case FaceOrder::locality:
                       return localityOrder(triangles, vertexCount);
                   default:
                       return libraryOrder(triangles, vertexCount);
                   }
               });
}

void orderFaces(Mesh& mesh, const TriangleOrder& order)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> groups;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        groups[{mesh.faces[f].part, mesh.faces[f].material}].push_back(f);
    const std::vector<Face> before = mesh.faces;
    const std::vector<std::uint32_t> vertexOfWedge = firstEqualWedges(mesh);
    for (const auto& [group, places] : groups)
    {
        const DrawnTogether drawn = numbered(mesh, vertexOfWedge, places);
        const std::vector<std::uint32_t> sequence = order(drawn.triangles, drawn.positions);
        for (std::size_t i = 0; i < places.size(); ++i)
            mesh.faces[places[i]] = before[places[sequence[i]]];
    }
}

} // namespace osgPMObjects::core
