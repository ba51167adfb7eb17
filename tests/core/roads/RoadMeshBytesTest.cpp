// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstring>
#include <memory>
#include <utility>

#include <foundation/Random.h>
#include <gtest/gtest.h>

#include <osgRoads/core/surface/BuildRoadMesh.h>
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
    const auto isReadWith = [&](std::size_t at, std::uint64_t count)
    {
        std::string spoiled = bytes;
        std::memcpy(spoiled.data() + at, &count, sizeof count);
        return roadMeshIn(spoiled).has_value();
    };
    const std::size_t vertices = sizeof(glm::dvec3);
    std::uint64_t packed = 0;
    std::memcpy(&packed, bytes.data() + vertices + 8, sizeof packed);
    const std::size_t indices = vertices + 16 + static_cast<std::size_t>(packed);
    EXPECT_TRUE(isReadWith(vertices, mesh.vertices.size()));
    EXPECT_TRUE(isReadWith(indices, mesh.indices.size()));
    for (const std::uint64_t wrong : {std::uint64_t{0}, std::uint64_t{1} << 62})
    {
        EXPECT_FALSE(isReadWith(vertices, wrong));
        EXPECT_FALSE(isReadWith(indices, wrong));
    }
    EXPECT_FALSE(isReadWith(vertices, mesh.vertices.size() + 1));
    EXPECT_FALSE(isReadWith(indices, mesh.indices.size() + 1));
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
