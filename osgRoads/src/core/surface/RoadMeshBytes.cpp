// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <foundation/PlainBytes.h>

#include <osgRoads/core/surface/PagedRoadMesh.h>
#include <osgRoads/core/surface/RoadMeshBytes.h>

#include "OutlineBytes.h"
#include "PackedPage.h"

namespace osgRoads::core
{

namespace
{

/// Returns how many vertices of a chunk lie in a row: those that are as far along the road as the first.
std::uint32_t columnsOf(std::span<const MeshVertex> chunk)
{
    const auto other = std::find_if(chunk.begin(), chunk.end(),
                                    [&](const MeshVertex& vertex) { return vertex.s != chunk.front().s; });
    return static_cast<std::uint32_t>(other - chunk.begin());
}

/// Takes the rows of those chunks that lie in a page, the first of which is `next`, which moves on. A page
/// that is not made of chunks has all its vertices in one column.
std::vector<VertexRows> rowsOf(const RoadMesh& mesh, const RoadPage& page, std::size_t& next)
{
    std::vector<VertexRows> rows;
    std::uint32_t vertex = page.firstVertex;
    const std::uint32_t end = page.firstVertex + page.vertexCount;
    for (; next < mesh.chunks.size() && mesh.chunks[next].firstVertex == vertex &&
           mesh.chunks[next].vertexCount <= end - vertex;
         ++next)
    {
        const std::uint32_t count = mesh.chunks[next].vertexCount;
        if (count > 0) rows.push_back({count, columnsOf(std::span(mesh.vertices).subspan(vertex, count))});
        vertex += count;
    }
    if (vertex < end) rows.push_back({end - vertex, 1});
    return rows;
}

} // namespace

std::optional<std::string> bytesOf(const RoadMesh& mesh, std::uintmax_t mostBytes)
{
    std::string bytes;
    appendOutline(bytes, mesh);
    std::size_t chunk = 0;
    for (const RoadPage& page : pagesOf(mesh.chunks, static_cast<std::uint32_t>(mesh.vertices.size()),
                                        static_cast<std::uint32_t>(mesh.indices.size())))
    {
        const auto rows = rowsOf(mesh, page, chunk);
        foundation::appendText(
            bytes,
            packedVertices(std::span(mesh.vertices).subspan(page.firstVertex, page.vertexCount), rows));
        std::vector<std::uint32_t> indices(mesh.indices.begin() + page.firstIndex,
                                           mesh.indices.begin() + page.firstIndex + page.indexCount);
        for (std::uint32_t& index : indices)
            index -= page.firstVertex;
        foundation::appendText(bytes, packedIndices(indices));
        if (bytes.size() > mostBytes) return std::nullopt;
    }
    return bytes.size() > mostBytes ? std::nullopt : std::optional(std::move(bytes));
}

} // namespace osgRoads::core
