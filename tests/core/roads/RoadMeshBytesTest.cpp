// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <foundation/Random.h>
#include <gtest/gtest.h>

#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgRoads/core/surface/PagedRoadMesh.h>
#include <osgRoads/core/surface/RoadMeshBytes.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

/// Whether no bit differs.
bool areSame(const std::vector<MeshVertex>& a, const std::vector<MeshVertex>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(MeshVertex)) == 0;
}

/// All pages of a paged mesh; absent: one is damaged.
std::optional<RoadMesh> wholeOf(const PagedRoadMesh& paged)
{
    RoadMesh mesh = paged.outline();
    mesh.vertices.clear();
    mesh.indices.clear();
    for (std::size_t page = 0; page < paged.pages().size(); ++page)
    {
        const auto content = paged.read(page);
        if (!content) return std::nullopt;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        EXPECT_EQ(first, paged.pages()[page].firstVertex);
        EXPECT_EQ(mesh.indices.size(), paged.pages()[page].firstIndex);
        mesh.vertices.insert(mesh.vertices.end(), content->vertices.begin(), content->vertices.end());
        for (const std::uint32_t index : content->indices)
            mesh.indices.push_back(first + index);
    }
    return mesh;
}

std::optional<RoadMesh> roadMeshIn(std::string_view bytes)
{
    const auto paged = PagedRoadMesh::in(bytes, nullptr);
    return paged ? wholeOf(*paged) : std::nullopt;
}

/// Ribbons of 100 rows of 5 vertices, each with two levels: 500 vertices a chunk.
RoadMesh ribbons(std::uint32_t chunks)
{
    constexpr std::uint32_t kRows = 100, kColumns = 5;
    RoadMesh mesh;
    mesh.marks.resize(3);
    mesh.decals.resize(1);
    for (std::uint32_t c = 0; c < chunks; ++c)
    {
        RoadChunk chunk;
        chunk.firstVertex = static_cast<std::uint32_t>(mesh.vertices.size());
        chunk.vertexCount = kRows * kColumns;
        for (std::uint32_t row = 0; row < kRows; ++row)
            for (std::uint32_t column = 0; column < kColumns; ++column)
            {
                MeshVertex vertex;
                vertex.position = {static_cast<std::int32_t>(row * 1000 + c),
                                   static_cast<std::int32_t>(column * 900),
                                   static_cast<std::int32_t>(row % 7)};
                vertex.s = static_cast<float>(row);
                vertex.rightRow = column % 3;
                mesh.vertices.push_back(vertex);
            }
        for (const std::uint32_t step : {1U, 11U})
        {
            ChunkLevel level{static_cast<std::uint32_t>(mesh.indices.size()), 0, 0.01 * step, 0};
            for (std::uint32_t row = 0; row + step < kRows; row += step)
                for (std::uint32_t column = 0; column + 1 < kColumns; ++column)
                {
                    const std::uint32_t a = chunk.firstVertex + row * kColumns + column,
                                        b = a + step * kColumns;
                    for (const std::uint32_t index : {a, b, a + 1, a + 1, b, b + 1})
                        mesh.indices.push_back(index);
                }
            level.indexCount = static_cast<std::uint32_t>(mesh.indices.size()) - level.firstIndex;
            chunk.levels.push_back(level);
        }
        mesh.chunks.push_back(chunk);
    }
    return mesh;
}

std::size_t bytesInMemory(const RoadMesh& mesh)
{
    return mesh.vertices.size() * sizeof(MeshVertex) + mesh.indices.size() * sizeof(std::uint32_t);
}

TEST(RoadMeshBytes, ComeBack)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    const std::string bytes = bytesOf(mesh).value();
    const auto read = roadMeshIn(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytesOf(*read), bytes);
    EXPECT_EQ(read->indices, mesh.indices);
    EXPECT_TRUE(areSame(read->vertices, mesh.vertices));
    ASSERT_EQ(read->chunks.size(), mesh.chunks.size());
    EXPECT_EQ(read->chunks.back().levels.back().errorM, mesh.chunks.back().levels.back().errorM);
    EXPECT_EQ(read->placeOf(read->vertices.back()), mesh.placeOf(mesh.vertices.back()));
}

TEST(RoadMeshBytes, AreAQuarterOfWhatAMeshTakesInMemory)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    EXPECT_LT(bytesOf(mesh)->size(), bytesInMemory(mesh) / 4);
    EXPECT_FALSE(bytesOf(mesh, bytesOf(mesh)->size() - 1));
    EXPECT_TRUE(bytesOf(mesh, bytesOf(mesh)->size()));
}

// Nothing of a made mesh is taken for granted: numbers and indices at random come back bit by bit.
TEST(RoadMeshBytes, OfAnyNumbersComeBack)
{
    foundation::SplitMix64 random(7);
    for (int trial = 0; trial < 20; ++trial)
    {
        RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
        for (MeshVertex& vertex : mesh.vertices)
            if (random() % 4 == 0)
            {
                for (std::int32_t& step : vertex.position)
                    step = static_cast<std::int32_t>(random());
                vertex.s = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
                vertex.normal[1] = static_cast<std::int8_t>(random());
            }
        for (std::uint32_t& index : mesh.indices)
            if (random() % 16 == 0) index = static_cast<std::uint32_t>(random() % mesh.vertices.size());
        if (trial % 2 != 0) std::swap(mesh.chunks.front(), mesh.chunks.back()); // no longer in order
        const auto read = roadMeshIn(bytesOf(mesh).value());
        ASSERT_TRUE(read);
        EXPECT_EQ(read->indices, mesh.indices);
        EXPECT_TRUE(areSame(read->vertices, mesh.vertices));
    }
}

// A reader that takes bytes for more than they hold would take all memory.
TEST(RoadMeshBytes, WithMoreVerticesOrIndicesThanFollowAreNone)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    const std::string bytes = bytesOf(mesh).value();
    const auto isReadWith = [&](std::size_t at, std::uint32_t count)
    {
        std::string spoiled = bytes;
        std::memcpy(spoiled.data() + at, &count, sizeof count);
        return roadMeshIn(spoiled).has_value();
    };
    const std::size_t vertices = sizeof(glm::dvec3), indices = vertices + sizeof(std::uint32_t);
    EXPECT_TRUE(isReadWith(vertices, static_cast<std::uint32_t>(mesh.vertices.size())));
    EXPECT_TRUE(isReadWith(indices, static_cast<std::uint32_t>(mesh.indices.size())));
    for (const std::uint32_t wrong : {0U, ~0U})
    {
        EXPECT_FALSE(isReadWith(vertices, wrong));
        EXPECT_FALSE(isReadWith(indices, wrong));
    }
    EXPECT_FALSE(isReadWith(vertices, static_cast<std::uint32_t>(mesh.vertices.size() + 1)));
    EXPECT_FALSE(isReadWith(indices, static_cast<std::uint32_t>(mesh.indices.size() + 1)));
}

TEST(PagedRoadMesh, HasPagesOfWholeChunksThatComeBackEachAlone)
{
    const auto mesh = std::make_shared<const RoadMesh>(ribbons(150));
    const PagedRoadMesh inMemory(mesh);
    ASSERT_EQ(inMemory.pages().size(), 3U); // 65 chunks a page
    const auto bytes = std::make_shared<const std::string>(bytesOf(*mesh).value());
    const auto packed = PagedRoadMesh::in(*bytes, bytes);
    ASSERT_TRUE(packed);
    EXPECT_TRUE(packed->outline().vertices.empty());
    for (const std::size_t page : {2U, 0U, 1U})
    {
        const auto a = inMemory.read(page), b = packed->read(page);
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(areSame(a->vertices, b->vertices));
        EXPECT_EQ(a->indices, b->indices);
        EXPECT_LE(a->vertices.size(), PagedRoadMesh::kPageVertices);
    }
    EXPECT_EQ(wholeOf(*packed)->indices, mesh->indices);
    for (const RoadChunk& chunk : mesh->chunks)
        for (const ChunkLevel& level : chunk.levels)
        {
            const RoadPage& page = packed->pages()[packed->pageOf(level.firstIndex)];
            EXPECT_GE(level.firstIndex, page.firstIndex);
            EXPECT_LE(level.firstIndex + level.indexCount, page.firstIndex + page.indexCount);
            EXPECT_GE(chunk.firstVertex, page.firstVertex);
            EXPECT_LE(chunk.firstVertex + chunk.vertexCount, page.firstVertex + page.vertexCount);
        }
}

TEST(PagedRoadMesh, OfNothingHasNoPage)
{
    EXPECT_TRUE(PagedRoadMesh(std::make_shared<const RoadMesh>()).pages().empty());
    EXPECT_TRUE(roadMeshIn(bytesOf(RoadMesh()).value()));
}

TEST(PagedRoadMesh, LosesADamagedPageAlone)
{
    const RoadMesh mesh = ribbons(150);
    std::string bytes = bytesOf(mesh).value();
    bytes.back() = '\xff'; // of a number that goes on
    const auto packed = PagedRoadMesh::in(bytes, nullptr);
    ASSERT_TRUE(packed);
    EXPECT_TRUE(packed->read(0));
    EXPECT_TRUE(packed->read(1));
    EXPECT_FALSE(packed->read(2));
}

TEST(RoadMeshBytes, CutOrLongerOnesAreNone)
{
    const std::string bytes = bytesOf(buildRoadMesh(placed(bentRoad()))).value();
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 50)
        EXPECT_FALSE(roadMeshIn(bytes.substr(0, size))) << size;
    EXPECT_FALSE(roadMeshIn(bytes + "x"));
}

TEST(RoadMeshBytes, MeshesThatCannotBeDrawnAreNone)
{
    const RoadMesh sound = buildRoadMesh(placed(bentRoad()));
    const auto isRead = [&](const auto& spoil)
    {
        RoadMesh mesh = sound;
        spoil(mesh);
        return roadMeshIn(bytesOf(mesh).value()).has_value();
    };
    EXPECT_TRUE(isRead([](RoadMesh&) {}));
    EXPECT_FALSE(isRead([](RoadMesh& mesh)
                        { mesh.indices.back() = static_cast<std::uint32_t>(mesh.vertices.size()); }));
    EXPECT_FALSE(isRead([](RoadMesh& mesh)
                        { mesh.vertices[3].leftRow = static_cast<std::uint32_t>(mesh.marks.size()); }));
    EXPECT_FALSE(isRead([](RoadMesh& mesh)
                        { mesh.vertices[3].decalRow = static_cast<std::uint32_t>(mesh.decals.size()); }));
    EXPECT_FALSE(isRead([](RoadMesh& mesh) { mesh.vertices[3].kind = static_cast<SurfaceKind>(200); }));
    EXPECT_FALSE(isRead(
        [](RoadMesh& mesh) {
            mesh.chunks.back().levels.front().indexCount =
                static_cast<std::uint32_t>(mesh.indices.size() + 1);
        }));
    EXPECT_FALSE(isRead([](RoadMesh& mesh) { mesh.chunks.back().firstVertex = ~0U; }));
    EXPECT_FALSE(isRead([](RoadMesh& mesh)
                        { mesh.chunks[0].levels[0].pavedCount = mesh.chunks[0].levels[0].indexCount + 1; }));
}

} // namespace
