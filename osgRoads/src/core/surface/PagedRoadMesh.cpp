// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <foundation/PlainBytes.h>

#include <osgRoads/core/surface/PagedRoadMesh.h>

#include "OutlineBytes.h"
#include "PackedPage.h"

namespace osgRoads::core
{

namespace
{

/// Whether chunks have all vertices and indices, one after the other.
bool followEachOther(const std::vector<RoadChunk>& chunks, std::uint32_t vertices, std::uint32_t indices)
{
    std::uint64_t vertex = 0, index = 0;
    for (const RoadChunk& chunk : chunks)
    {
        if (chunk.firstVertex != vertex || chunk.levels.empty()) return false;
        vertex += chunk.vertexCount;
        for (const ChunkLevel& level : chunk.levels)
        {
            if (level.firstIndex != index) return false;
            index += level.indexCount;
        }
    }
    return vertex == vertices && index == indices;
}

bool canBeDrawn(const RoadPageContent& page, const RoadMesh& outline)
{
    const std::size_t vertices = page.vertices.size(), marks = outline.marks.size(),
                      decals = outline.decals.size();
    return std::all_of(page.indices.begin(), page.indices.end(),
                       [&](std::uint32_t index) { return index < vertices; }) &&
           std::all_of(page.vertices.begin(), page.vertices.end(),
                       [&](const MeshVertex& vertex)
                       {
                           return vertex.kind <= SurfaceKind::skirt && vertex.rightRow < marks &&
                                  vertex.leftRow < marks && vertex.decalRow < decals;
                       });
}

} // namespace

std::vector<RoadPage> pagesOf(const std::vector<RoadChunk>& chunks, std::uint32_t vertices,
                              std::uint32_t indices)
{
    std::vector<RoadPage> pages;
    if (!followEachOther(chunks, vertices, indices)) return {{0, vertices, 0, indices}};
    for (const RoadChunk& chunk : chunks)
    {
        if (pages.empty() || pages.back().vertexCount + chunk.vertexCount > PagedRoadMesh::kPageVertices)
            pages.push_back({chunk.firstVertex, 0, chunk.levels.front().firstIndex, 0});
        RoadPage& page = pages.back();
        page.vertexCount = chunk.firstVertex + chunk.vertexCount - page.firstVertex;
        page.indexCount = chunk.levels.back().firstIndex + chunk.levels.back().indexCount - page.firstIndex;
    }
    return pages;
}

PagedRoadMesh::PagedRoadMesh(std::shared_ptr<const RoadMesh> mesh)
    : _mesh(std::move(mesh)),
      _pages(pagesOf(_mesh->chunks, static_cast<std::uint32_t>(_mesh->vertices.size()),
                     static_cast<std::uint32_t>(_mesh->indices.size())))
{
}

std::optional<PagedRoadMesh> PagedRoadMesh::in(std::string_view bytes, std::shared_ptr<const void> owner)
{
    foundation::ValueTaker taker(bytes);
    auto outline = std::make_shared<RoadMesh>();
    MeshSize size;
    if (!takeOutline(taker, *outline, size)) return std::nullopt;
    PagedRoadMesh mesh;
    mesh._pages = pagesOf(outline->chunks, size.vertices, size.indices);
    mesh._packed.resize(mesh._pages.size());
    for (Packed& packed : mesh._packed)
        if (!taker.take(packed.vertices) || !taker.take(packed.indices)) return std::nullopt;
    mesh._mesh = std::move(outline);
    mesh._owner = std::move(owner);
    return taker.isEmpty() ? std::optional(std::move(mesh)) : std::nullopt;
}

std::size_t PagedRoadMesh::pageOf(std::uint32_t index) const
{
    const auto after =
        std::upper_bound(_pages.begin(), _pages.end(), index,
                         [](std::uint32_t i, const RoadPage& page) { return i < page.firstIndex; });
    return static_cast<std::size_t>(after - _pages.begin()) - 1;
}

std::optional<RoadPageContent> PagedRoadMesh::read(std::size_t page) const
{
    const RoadPage& range = _pages[page];
    RoadPageContent content;
    if (!_packed.empty())
    {
        const Packed& packed = _packed[page];
        const bool isWhole = unpackVertices(packed.vertices, range.vertexCount, content.vertices) &&
                             unpackIndices(packed.indices, range.indexCount, content.indices) &&
                             canBeDrawn(content, *_mesh);
        return isWhole ? std::optional(std::move(content)) : std::nullopt;
    }
    const auto vertex = _mesh->vertices.begin() + range.firstVertex;
    content.vertices.assign(vertex, vertex + range.vertexCount);
    const auto index = _mesh->indices.begin() + range.firstIndex;
    content.indices.assign(index, index + range.indexCount);
    for (std::uint32_t& i : content.indices)
        i -= range.firstVertex;
    return content;
}

} // namespace osgRoads::core
