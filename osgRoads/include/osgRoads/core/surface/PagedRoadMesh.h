// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Chunks that follow each other and have their vertices and indices for themselves: ranges of those of the
/// mesh.
struct RoadPage
{
    std::uint32_t firstVertex = 0, vertexCount = 0, firstIndex = 0, indexCount = 0;

    std::size_t bytes() const
    {
        return vertexCount * sizeof(MeshVertex) + indexCount * sizeof(std::uint32_t);
    }
};

/// What a page holds.
struct RoadPageContent
{
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices; ///< counted from the first vertex of the page
};

/// The drawn surface of a network, page by page: of a mesh in memory, or of packed bytes, of which only the
/// pages that are asked for are unpacked.
/// Memory: of packed bytes the chunks, marks and decals. Threads: immutable.
class PagedRoadMesh
{
public:
    static constexpr std::uint32_t kPageVertices = 1U << 15; ///< about, and no less than a chunk's

    /// Of a mesh in memory.
    explicit PagedRoadMesh(std::shared_ptr<const RoadMesh> mesh);

    /// Of the bytes that bytesOf() made, which `owner` keeps. Absent: it did not make them. What a page holds
    /// is checked when it is read.
    static std::optional<PagedRoadMesh> in(std::string_view bytes, std::shared_ptr<const void> owner);

    /// All but vertices and indices, which may be missing.
    const RoadMesh& outline() const { return *_mesh; }

    std::span<const RoadPage> pages() const { return _pages; }

    /// Returns the number of the page that holds an index of the mesh; there is one.
    std::size_t pageOf(std::uint32_t index) const;

    /// Reads a page. Absent: its bytes are damaged. What is returned can be drawn: indices lie within the
    /// vertices, rows within marks and decals.
    std::optional<RoadPageContent> read(std::size_t page) const;

private:
    /// Packed vertices and indices of a page.
    struct Packed
    {
        std::string_view vertices, indices;
    };

    PagedRoadMesh() = default;

    std::shared_ptr<const RoadMesh> _mesh;
    std::vector<RoadPage> _pages;
    std::vector<Packed> _packed; ///< as many as pages; none: the mesh has vertices and indices
    std::shared_ptr<const void> _owner;
};

/// Cuts a mesh of so many vertices and indices into pages. Where chunks do not follow each other, all is one
/// page.
std::vector<RoadPage> pagesOf(const std::vector<RoadChunk>& chunks, std::uint32_t vertices,
                              std::uint32_t indices);

} // namespace osgRoads::core
