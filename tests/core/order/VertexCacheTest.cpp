// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <set>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <osgPMObjects/core/order/VertexCacheCost.h>

#include "OrderMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::IndexedMesh;
using testsupport::Random;

/// A queue of vertices, written in the plainest way.
std::uint64_t byQueue(const IndexedMesh& mesh, std::size_t size)
{
    std::deque<std::uint32_t> queue;
    std::uint64_t misses = 0;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
        {
            if (std::find(queue.begin(), queue.end(), v) != queue.end()) continue;
            ++misses;
            queue.push_back(v);
            if (queue.size() > size) queue.pop_front();
        }
    return misses;
}

/// Batches of triangles, written in the plainest way.
std::uint64_t bySets(const IndexedMesh& mesh, std::size_t vertices, std::size_t triangles)
{
    std::set<std::uint32_t> batch;
    std::size_t drawn = 0;
    std::uint64_t misses = 0;
    for (const Triangle& t : mesh.triangles)
    {
        std::set<std::uint32_t> with = batch;
        with.insert(t.begin(), t.end());
        if (drawn == triangles || with.size() > vertices)
        {
            misses += batch.size();
            with = {t.begin(), t.end()};
            drawn = 0;
        }
        batch = with;
        ++drawn;
    }
    return misses + batch.size();
}

TEST(VertexCache, OfARowByHand)
{
    const IndexedMesh row = testsupport::gridMesh(100, 1);
    EXPECT_EQ(fifoTransforms(row.triangles, row.vertexCount(), 10), 202u);
    EXPECT_EQ(fifoTransforms(row.triangles, row.vertexCount(), 3), 202u);
    // 30 triangles of a row have 32 vertices; 200 triangles are six such batches and one of 20.
    EXPECT_EQ(batchTransforms(row.triangles, row.vertexCount()), 6u * 32u + 22u);
    // Thirds of 32 indices: 10 triangles of 12 vertices.
    EXPECT_EQ(batchTransforms(row.triangles, row.vertexCount(), {.triangles = 10}), 20u * 12u);
    EXPECT_EQ(batchTransforms(row.triangles, row.vertexCount(), {}), 202u);
}

TEST(VertexCache, IsTheQueueAndTheBatchesAsTheyAreTold)
{
    Random random(71);
    for (int i = 0; i < 2000; ++i)
    {
        const IndexedMesh mesh = testsupport::soup(random, 1 + random.below(100), 1 + random.below(60));
        const std::uint32_t size = 1 + random.below(40), vertices = 3 + random.below(40),
                            triangles = 1 + random.below(40);
        ASSERT_EQ(fifoTransforms(mesh.triangles, mesh.vertexCount(), size), byQueue(mesh, size));
        ASSERT_EQ(batchTransforms(mesh.triangles, mesh.vertexCount(), {vertices, triangles}),
                  bySets(mesh, vertices, triangles));
    }
}

TEST(VertexCache, CountsWhatTheLibrarysAnalysisCounts)
{
    Random random(72);
    IndexedMesh mesh = testsupport::sphereMesh(40, 50);
    int differs = 0;
    for (int round = 0; round < 2; ++round)
    {
        const auto analyse = [&](unsigned cache, unsigned warp, unsigned group)
        {
            return meshopt_analyzeVertexCache(mesh.triangles.front().data(), 3 * mesh.triangles.size(),
                                              mesh.vertexCount(), cache, warp, group)
                .vertices_transformed;
        };
        for (const std::uint32_t size : {10u, 16u, 32u, 100u})
            EXPECT_EQ(fifoTransforms(mesh.triangles, mesh.vertexCount(), size), analyse(size, 0, 0));
        EXPECT_EQ(batchTransforms(mesh.triangles, mesh.vertexCount()), analyse(1000, 32, 32));
        differs +=
            batchTransforms(mesh.triangles, mesh.vertexCount(), {.triangles = 32}) != analyse(1000, 32, 32);
        testsupport::shuffle(mesh, random);
    }
    EXPECT_EQ(differs, 2); // the mutation: without the limit on vertices
}

TEST(VertexCache, ForgetsNothingThatIsTakenBack)
{
    Random random(73);
    foundation::FifoCache cache(20, 6), untouched(20, 6);
    for (int i = 0; i < 2000; ++i)
    {
        const std::uint32_t vertex = random.below(20);
        std::vector<std::pair<std::uint32_t, std::uint64_t>> tried;
        for (int k = 0; k < 10; ++k)
        {
            const std::uint32_t other = random.below(20);
            const std::uint64_t before = cache.lastMiss(other);
            if (cache.transform(other)) tried.emplace_back(other, before);
        }
        for (; !tried.empty(); tried.pop_back())
            cache.takeBack(tried.back().first, tried.back().second);
        ASSERT_EQ(cache.transform(vertex), untouched.transform(vertex));
        ASSERT_EQ(cache.misses(), untouched.misses());
    }
}

} // namespace
