// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <gtest/gtest.h>

#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgRoads/core/surface/RoadMeshBytes.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

TEST(RoadMeshBytes, ComeBack)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    const std::string bytes = bytesOf(mesh);
    const auto read = roadMeshIn(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytesOf(*read), bytes);
    EXPECT_EQ(read->indices, mesh.indices);
    ASSERT_EQ(read->chunks.size(), mesh.chunks.size());
    EXPECT_EQ(read->chunks.back().levels.back().errorM, mesh.chunks.back().levels.back().errorM);
    EXPECT_EQ(read->placeOf(read->vertices.back()), mesh.placeOf(mesh.vertices.back()));
}

TEST(RoadMeshBytes, CutOrLongerOnesAreNone)
{
    const std::string bytes = bytesOf(buildRoadMesh(placed(bentRoad())));
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
        return roadMeshIn(bytesOf(mesh)).has_value();
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
