// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a kept surface of roads: each of its pages can be drawn, or is refused.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <osgRoads/core/surface/PagedRoadMesh.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using osgRoads::core::PagedRoadMesh;

void require(bool condition)
{
    if (!condition) std::abort();
}

void readPage(const PagedRoadMesh& mesh, std::size_t number)
{
    const osgRoads::core::RoadPage& page = mesh.pages()[number];
    const auto content = mesh.read(number);
    if (!content) return;
    require(content->vertices.size() == page.vertexCount && content->indices.size() == page.indexCount);
    for (const std::uint32_t index : content->indices)
        require(index < content->vertices.size());
    for (const auto& vertex : content->vertices)
        require(vertex.rightRow < mesh.outline().marks.size() &&
                vertex.leftRow < mesh.outline().marks.size() &&
                vertex.decalRow < mesh.outline().decals.size());
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto mesh = PagedRoadMesh::in({reinterpret_cast<const char*>(data), size}, nullptr);
    if (!mesh) return 0;
    for (std::size_t page = 0; page < mesh->pages().size(); ++page)
        readPage(*mesh, page);
    for (const auto& chunk : mesh->outline().chunks)
        for (const auto& level : chunk.levels)
            if (level.indexCount > 0) require(mesh->pageOf(level.firstIndex) < mesh->pages().size());
    return 0;
}
