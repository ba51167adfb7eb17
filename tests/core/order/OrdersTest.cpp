// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/TriangleStrips.h>
#include <osgPMObjects/core/order/VertexCacheCost.h>

#include "OrderMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::IndexedMesh;
using testsupport::Random;

struct NamedOrder
{
    const char* name;
    std::function<std::vector<std::uint32_t>(const IndexedMesh&)> make;
};

const std::vector<NamedOrder>& orders()
{
    static const std::vector<NamedOrder> all = {
        {"sgi", [](const IndexedMesh& m) { return sgiStrips(m.triangles).triangles; }},
        {"dual graph", [](const IndexedMesh& m) { return dualGraphStrips(m.triangles).triangles; }},
        {"cache-ordered", [](const IndexedMesh& m)
         { return cacheOrderedStrips(m.triangles, m.vertexCount(), sgiStrips(m.triangles), 16).triangles; }},
        {"hilbert", [](const IndexedMesh& m) { return hilbertOrder(m.triangles, m.positions); }},
        {"universal", [](const IndexedMesh& m) { return universalOrder(m.triangles); }},
        {"locality", [](const IndexedMesh& m) { return localityOrder(m.triangles, m.vertexCount()); }},
        {"library", [](const IndexedMesh& m) { return libraryOrder(m.triangles, m.vertexCount()); }},
    };
    return all;
}

bool isPermutation(std::vector<std::uint32_t> order, std::size_t size)
{
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i] != i) return false;
    return order.size() == size;
}

std::vector<IndexedMesh> variedMeshes()
{
    Random random(51);
    std::vector<IndexedMesh> meshes = {{},
                                       testsupport::gridMesh(1, 1),
                                       testsupport::gridMesh(40, 30),
                                       testsupport::sphereMesh(20, 30),
                                       testsupport::soup(random, 1, 3)};
    meshes.push_back({{{0, 0, 0}}, {{1, 2, 3}}});
    for (std::uint32_t i = 0; i < 300; ++i)
        meshes.push_back(testsupport::soup(random, 1 + random.below(60), 1 + random.below(30)));
    IndexedMesh fan; // a hub that all triangles share
    fan.positions.resize(2002);
    for (std::uint32_t i = 1; i <= 2000; ++i)
        fan.triangles.push_back({0, i, i + 1});
    meshes.push_back(fan);
    for (IndexedMesh* mesh : {&meshes[2], &meshes[3]})
    {
        IndexedMesh shuffled = *mesh;
        testsupport::shuffle(shuffled, random);
        meshes.push_back(shuffled);
    }
    return meshes;
}

TEST(Orders, HaveEveryTriangleOnceAsItWas)
{
    for (const IndexedMesh& mesh : variedMeshes())
        for (const NamedOrder& order : orders())
        {
            const auto made = order.make(mesh);
            ASSERT_TRUE(isPermutation(made, mesh.triangles.size())) << order.name;
            ASSERT_EQ(testsupport::orientedSet(inOrder(mesh.triangles, made)),
                      testsupport::orientedSet(mesh.triangles))
                << order.name;
        }
}

TEST(Orders, CheckFindsALostATwofoldAndATurnedTriangle)
{
    const IndexedMesh mesh = testsupport::gridMesh(4, 4);
    auto order = universalOrder(mesh.triangles);
    order.pop_back();
    EXPECT_FALSE(isPermutation(order, mesh.triangles.size()));
    order.push_back(order.front());
    EXPECT_FALSE(isPermutation(order, mesh.triangles.size()));
    auto turned = mesh.triangles;
    std::swap(turned[5][0], turned[5][1]);
    EXPECT_NE(testsupport::orientedSet(turned), testsupport::orientedSet(mesh.triangles));
    std::rotate(turned[5].begin(), turned[5].begin() + 1, turned[5].end());
    std::swap(turned[5][0], turned[5][1]);
    std::swap(turned[5][1], turned[5][2]);
    std::swap(turned[5][0], turned[5][1]);
    EXPECT_EQ(testsupport::orientedSet(turned), testsupport::orientedSet(mesh.triangles));
}

TEST(Orders, AreTheSameEachTime)
{
    Random random(52);
    IndexedMesh mesh = testsupport::sphereMesh(24, 32);
    testsupport::shuffle(mesh, random);
    for (const NamedOrder& order : orders())
        EXPECT_EQ(order.make(mesh), order.make(mesh)) << order.name;
}

TEST(Orders, SaveTransformsOnAShuffledMesh)
{
    Random random(53);
    IndexedMesh mesh = testsupport::sphereMesh(60, 80);
    testsupport::shuffle(mesh, random);
    const auto count = static_cast<double>(mesh.triangles.size());
    EXPECT_GT(static_cast<double>(fifoTransforms(mesh.triangles, mesh.vertexCount(), 16)) / count, 2.9);
    for (const NamedOrder& order : orders())
    {
        const auto ordered = inOrder(mesh.triangles, order.make(mesh));
        EXPECT_LT(static_cast<double>(fifoTransforms(ordered, mesh.vertexCount(), 16)) / count, 1.1)
            << order.name;
    }
    const auto perTriangle = [&](const std::vector<std::uint32_t>& order, std::uint32_t cacheSize)
    {
        return static_cast<double>(
                   fifoTransforms(inOrder(mesh.triangles, order), mesh.vertexCount(), cacheSize)) /
               count;
    };
    EXPECT_LT(perTriangle(localityOrder(mesh.triangles, mesh.vertexCount()), 16), 0.70);
    EXPECT_LT(perTriangle(universalOrder(mesh.triangles), 32), 0.72);
    EXPECT_LT(perTriangle(hilbertOrder(mesh.triangles, mesh.positions), 32), 0.85);
    EXPECT_LT(perTriangle(libraryOrder(mesh.triangles, mesh.vertexCount()), 16), 0.72);
}

TEST(Orders, OfAHubOfManyTrianglesEnd)
{ // no order may look through all of them at every step
    Random random(56);
    IndexedMesh fan;
    fan.positions.resize(300'002);
    for (std::uint32_t i = 1; i <= 300'000; ++i)
        fan.triangles.push_back({0, i, i + 1});
    testsupport::shuffle(fan, random);
    for (const NamedOrder& order : orders())
        EXPECT_TRUE(isPermutation(order.make(fan), fan.triangles.size())) << order.name;
}

TEST(HilbertOrder, StepsFromCellToCell)
{
    for (const std::uint32_t depth : {1u, 16u})
    { // a small triangle in each cell of a grid
        Random random(54);
        const std::uint32_t side = depth == 1 ? 64 : 16;
        IndexedMesh mesh;
        for (std::uint32_t z = 0; z < depth; ++z)
            for (std::uint32_t y = 0; y < side; ++y)
                for (std::uint32_t x = 0; x < side; ++x)
                {
                    const std::uint32_t v = mesh.vertexCount();
                    mesh.triangles.push_back({v, v + 1, v + 2});
                    for (const double share : {0.5, 0.0, 1.0}) // its centre is that of the cell
                        mesh.positions.emplace_back(x + share, y + share, depth > 1 ? z + share : 0.0);
                }
        testsupport::shuffle(mesh, random);
        const auto order = hilbertOrder(mesh.triangles, mesh.positions);
        for (std::size_t i = 1; i < order.size(); ++i)
        {
            const glm::dvec3 way =
                mesh.positions[mesh.triangles[order[i]][0]] - mesh.positions[mesh.triangles[order[i - 1]][0]];
            ASSERT_EQ(std::abs(way.x) + std::abs(way.y) + std::abs(way.z), 1.0) << depth << " " << i;
        }
    }
}

TEST(UniversalOrder, KeepsHalvesOfAGridTogether)
{
    Random random(55);
    IndexedMesh mesh = testsupport::gridMesh(32, 32);
    testsupport::shuffle(mesh, random);
    const auto order = universalOrder(mesh.triangles);
    const TriangleAdjacency adjacency(mesh.triangles);
    std::vector<std::size_t> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        rank[order[i]] = i;
    const auto cutBetween = [&](std::size_t middle)
    {
        int cut = 0;
        for (std::uint32_t t = 0; t < adjacency.size(); ++t)
            for (const std::uint32_t n : adjacency.neighbours(t))
                cut += n != TriangleAdjacency::kNone && rank[t] < middle && rank[n] >= middle;
        return cut;
    };
    int least = 1 << 30;
    for (std::size_t middle = order.size() * 7 / 16; middle <= order.size() * 9 / 16; ++middle)
        least = std::min(least, cutBetween(middle));
    EXPECT_LE(least, 48); // a straight cut has 32, the mutation, an order by chance, about half of 3000
    for (std::size_t i = 0; i < rank.size(); ++i)
        rank[i] = i;
    EXPECT_GT(cutBetween(order.size() / 2), 500);
}

} // namespace
