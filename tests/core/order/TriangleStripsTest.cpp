// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/order/TriangleStrips.h>

#include "OrderMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::IndexedMesh;
using testsupport::Random;

std::vector<Triangle> decoded(const IndexedMesh& mesh, const TriangleStrips& strips)
{
    std::vector<Triangle> drawn;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
        const auto one = decodeStrip(encodeStrip(mesh.triangles, strips.strip(i)));
        drawn.insert(drawn.end(), one.begin(), one.end());
    }
    return drawn;
}

double sentPerTriangle(const IndexedMesh& mesh, const TriangleStrips& strips)
{
    std::size_t sent = 0;
    for (std::size_t i = 0; i < strips.size(); ++i)
        sent += encodeStrip(mesh.triangles, strips.strip(i)).size();
    return static_cast<double>(sent) / static_cast<double>(mesh.triangles.size());
}

TEST(TriangleStrips, OfARowSendTwoVerticesMoreThanTriangles)
{
    IndexedMesh row = testsupport::gridMesh(50, 1);
    for (const TriangleStrips& strips : {sgiStrips(row.triangles), dualGraphStrips(row.triangles)})
    {
        ASSERT_EQ(strips.size(), 1u);
        EXPECT_EQ(encodeStrip(row.triangles, strips.strip(0)).size(),
                  103u); // it begins against its orientation
    }
    for (Triangle& t : row.triangles)
        std::swap(t[0], t[1]);
    EXPECT_EQ(encodeStrip(row.triangles, sgiStrips(row.triangles).strip(0)).size(), 102u);
}

TEST(TriangleStrips, OfAFanRepeatAVertexAtEachTurn)
{
    IndexedMesh fan;
    for (std::uint32_t i = 1; i <= 10; ++i)
        fan.triangles.push_back({0, i, i + 1});
    TriangleStrips all;
    all.firsts = {0};
    for (std::uint32_t i = 0; i < 10; ++i)
        all.triangles.push_back(i);
    EXPECT_TRUE(areStrips(all, TriangleAdjacency(fan.triangles)));
    const auto sent = encodeStrip(fan.triangles, all.strip(0));
    EXPECT_EQ(decodeStrip(sent).size(), 10u);
    EXPECT_EQ(sent.size(), 12u + 7u); // the first three triangles can be laid either way
    EXPECT_EQ(testsupport::orientedSet(decodeStrip(sent)), testsupport::orientedSet(fan.triangles));
}

TEST(TriangleStrips, DoubleTheFirstVertexWhereTheyBeginAgainstTheirOrientation)
{
    // The figure of Jin's lecture: triangle 0 (v0 v1 v2) turns against the beginning of the strip.
    const std::vector<Triangle> triangles = {{1, 0, 2}, {1, 2, 3}, {3, 2, 4}, {3, 4, 5}};
    const std::vector<std::uint32_t> strip = {0, 1, 2, 3};
    const auto sent = encodeStrip(triangles, strip);
    EXPECT_EQ(sent.size(), 4u + 2u + 1u);
    EXPECT_EQ(sent[0], sent[1]);
    EXPECT_EQ(testsupport::orientedSet(decodeStrip(sent)), testsupport::orientedSet(triangles));
}

TEST(TriangleStrips, DrawEveryTriangleFromTheSameSide)
{
    Random random(61);
    std::vector<IndexedMesh> meshes = {testsupport::gridMesh(30, 20), testsupport::sphereMesh(12, 20)};
    for (int i = 0; i < 500; ++i)
        meshes.push_back(testsupport::soup(random, 1 + random.below(60), 3 + random.below(12)));
    for (IndexedMesh& mesh : meshes)
    {
        testsupport::shuffle(mesh, random);
        const TriangleAdjacency adjacency(mesh.triangles);
        const TriangleStrips sgi = sgiStrips(mesh.triangles), dual = dualGraphStrips(mesh.triangles);
        for (const TriangleStrips& strips :
             {sgi, dual, cacheOrderedStrips(mesh.triangles, mesh.vertexCount(), sgi, 16),
              cacheOrderedStrips(mesh.triangles, mesh.vertexCount(), dual, 10)})
        {
            ASSERT_TRUE(areStrips(strips, adjacency));
            ASSERT_EQ(testsupport::orientedSet(decoded(mesh, strips)),
                      testsupport::orientedSet(mesh.triangles));
        }
    }
}

TEST(TriangleStrips, JoinedDrawEveryTriangleFromTheSameSideAndOneVertexLessShows)
{
    Random random(63);
    std::vector<IndexedMesh> meshes = {testsupport::gridMesh(30, 20), testsupport::sphereMesh(12, 20)};
    for (int i = 0; i < 200; ++i)
        meshes.push_back(testsupport::soup(random, 1 + random.below(60), 3 + random.below(12)));
    for (IndexedMesh& mesh : meshes)
    {
        testsupport::shuffle(mesh, random);
        for (const StripKind kind : {StripKind::sgi, StripKind::dualGraph})
        {
            const TriangleStrips strips = stripsOf(mesh.triangles, mesh.vertexCount(), kind);
            ASSERT_TRUE(areStrips(strips, TriangleAdjacency(mesh.triangles)));
            std::vector<std::uint32_t> sent = joinStrips(mesh.triangles, strips);
            const auto wanted = testsupport::orientedSet(mesh.triangles);
            ASSERT_EQ(testsupport::orientedSet(decodeStrip(sent)), wanted);
            sent.pop_back();
            if (&mesh == &meshes.front()) // whose triangles all have an area
            {
                EXPECT_NE(testsupport::orientedSet(decodeStrip(sent)), wanted);
            }
        }
    }
    EXPECT_TRUE(joinStrips({}, {}).empty());
}

TEST(TriangleStrips, OfSgiAlternate)
{
    Random random(62);
    IndexedMesh mesh = testsupport::sphereMesh(20, 30);
    testsupport::shuffle(mesh, random);
    const TriangleStrips strips = sgiStrips(mesh.triangles);
    for (std::size_t i = 0; i < strips.size(); ++i)
        EXPECT_LE(encodeStrip(mesh.triangles, strips.strip(i)).size(),
                  strips.strip(i).size() + 3); // 1 if it is turned
    EXPECT_LT(sentPerTriangle(mesh, strips), 1.25);
    EXPECT_LT(dualGraphStrips(mesh.triangles).size(), strips.size());
}

TEST(TriangleStrips, CheckFindsWhatIsNone)
{
    const IndexedMesh mesh = testsupport::gridMesh(10, 10);
    const TriangleAdjacency adjacency(mesh.triangles);
    const TriangleStrips sound = sgiStrips(mesh.triangles);
    ASSERT_TRUE(areStrips(sound, adjacency));
    TriangleStrips mutated = sound;
    std::swap(mutated.triangles[3], mutated.triangles[40]);
    EXPECT_FALSE(areStrips(mutated, adjacency));
    mutated = sound;
    mutated.triangles[3] = mutated.triangles[4];
    EXPECT_FALSE(areStrips(mutated, adjacency));
    mutated = sound;
    mutated.triangles.pop_back();
    EXPECT_FALSE(areStrips(mutated, adjacency));
    mutated = sound;
    mutated.firsts.erase(mutated.firsts.begin() + 1);
    EXPECT_FALSE(areStrips(mutated, adjacency));
    auto sent = encodeStrip(mesh.triangles, sound.strip(0));
    sent.erase(sent.begin());
    EXPECT_NE(testsupport::orientedSet(decodeStrip(sent)),
              testsupport::orientedSet(decodeStrip(encodeStrip(mesh.triangles, sound.strip(0)))));
}

TEST(TriangleAdjacency, PairsSidesThatRunAgainstOneAnother)
{
    const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4},
                                             {1, 0, 5}, {0, 1, 6}, {0, 0, 1}};
    const TriangleAdjacency adjacency(triangles);
    EXPECT_EQ(adjacency.across(0, 0), 1u);
    EXPECT_EQ(adjacency.across(1, 0), 0u);
    EXPECT_EQ(adjacency.across(2, 0), 3u);
    EXPECT_EQ(adjacency.across(4, 0), TriangleAdjacency::kNone); // the third that runs up
    for (int edge = 0; edge < 3; ++edge)
        EXPECT_EQ(adjacency.across(5, edge), TriangleAdjacency::kNone);
}

} // namespace
