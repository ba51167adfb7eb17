// SPDX-License-Identifier: Apache-2.0
// How well arrangements use the vertex cache, at all levels.
#include <gtest/gtest.h>

#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/VertexCacheCost.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ScannedMeshes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

constexpr std::uint32_t kCacheSize = 16;

/// The transformed vertices over the vertices, mean of some levels.
struct Transforms
{
    double asDrawn = 0.0, fromScratch = 0.0;
};

Transforms transformsOf(const ProgressiveMesh& progressive)
{
    constexpr std::uint32_t kLevels = 12;
    const auto wedges = static_cast<std::uint32_t>(progressive.mesh.wedgeCount());
    Transforms sum;
    ProgressiveLevel level(progressive);
    for (std::uint32_t i = 0; i < kLevels; ++i)
    {
        level.moveTo(progressive.stepCount / kLevels * i);
        std::vector<Triangle> drawn;
        forEachDrawnFace(progressive, level, [&](const Triangle& t, std::uint32_t) { drawn.push_back(t); });
        const double share = 1.0 / (kLevels * level.wedgeCount());
        sum.asDrawn += share * static_cast<double>(fifoTransforms(drawn, wedges, kCacheSize));
        sum.fromScratch += share * static_cast<double>(fifoTransforms(
                                       inOrder(drawn, libraryOrder(drawn, wedges)), wedges, kCacheSize));
    }
    return sum;
}

TEST(Arrangement, OfAScannedMeshIsNearlyAsGoodAsFromScratchAtEveryLevel)
{
    const Mesh mesh = testsupport::scannedBlob(36);
    const ProgressiveMesh progressive = buildProgressiveMesh(mesh, simplify(mesh));
    const Transforms transforms = transformsOf(progressive);
    EXPECT_LT(transforms.asDrawn, 1.42);
    EXPECT_LT(transforms.asDrawn, 1.07 * transforms.fromScratch);
    EXPECT_LT(static_cast<double>(progressive.overheadBytes()) / static_cast<double>(mesh.positions.size()),
              16.0);
}

TEST(Arrangement, OfARegularMeshIsNearlyAsGoodAsFromScratchAtEveryLevel)
{
    const Mesh mesh = testsupport::waves(70, 70);
    const Transforms transforms = transformsOf(buildProgressiveMesh(mesh, simplify(mesh)));
    EXPECT_LT(transforms.asDrawn, 1.05 * transforms.fromScratch);
}

TEST(Arrangement, WithLookAheadCostsAboutTheSame)
{
    const Mesh mesh = testsupport::scannedBlob(12);
    const CollapseSequence sequence = simplify(mesh);
    const auto costWith = [&](std::uint32_t lookAhead)
    {
        const ProgressiveMesh progressive =
            buildProgressiveMesh(mesh, sequence, {.arrangement = Arrangement::tswap, .lookAhead = lookAhead});
        EXPECT_TRUE(isValid(progressive));
        return transformsOf(progressive).asDrawn;
    };
    const double without = costWith(1), with = costWith(4);
    EXPECT_NE(with, without) << "look-ahead chose nothing else";
    EXPECT_NEAR(with, without, 0.15 * without);
}

} // namespace
