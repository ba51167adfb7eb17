// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/bisection/BisectionTree.h>

#include "MadeSurfaces.h"
#include "Random.h"

namespace osgTerrainROAM::core
{

/// Damages a tree, to prove that isConforming() can fail.
struct BisectionTreeMutator
{
    static void flip(BisectionTree& tree, Bisector t)
    {
        tree._isSplit[tree.placeOf(t)] = !tree._isSplit[tree.placeOf(t)];
    }
    static void miscount(BisectionTree& tree) { ++tree._leaves; }
};

namespace
{

constexpr int kTreeLevels = 7;

std::vector<bool> splitsOf(const BisectionTree& tree)
{
    std::vector<bool> splits;
    for (std::uint32_t side = 0; side < tree.mesh().sides(); ++side)
        for (std::uint32_t node = 0; node < 1u << tree.levels(); ++node)
            splits.push_back(node > 0 && tree.isSplit({side, node}));
    return splits;
}

Bisector randomLeaf(const BisectionTree& tree, testsupport::Random& random)
{
    Bisector t{random.below(tree.mesh().sides()), 1};
    while (tree.isSplit(t))
        t = t.half(random.below(2));
    return t;
}

TEST(BisectionTree, neighboursShareASideAndKnowEachOther)
{
    const CoarseMesh cube = cubeMesh();
    for (std::uint32_t side = 0; side < cube.sides(); ++side)
        for (std::uint32_t node = 1; node < 128; ++node)
        {
            const BisectorNeighbours at = neighboursOf(cube, {side, node});
            EXPECT_EQ(neighboursOf(cube, at.base).base, at.self);
            EXPECT_EQ(neighboursOf(cube, at.left).right, at.self);
            EXPECT_EQ(neighboursOf(cube, at.right).left, at.self);
        }
}

TEST(BisectionTree, aForcedSplitSplitsWhatItNeedsAndNoMore)
{
    const CoarseMesh cube = cubeMesh();
    BisectionTree tree(cube, kTreeLevels);
    EXPECT_EQ(tree.leafCount(), 24u);
    EXPECT_EQ(tree.forceSplit({0, 1}), 2u) << "a root and its twin";
    EXPECT_EQ(tree.leafCount(), 26u);
    EXPECT_EQ(tree.forceSplit({0, 2}), 4u) << "the root beside it and its twin are split first";
    EXPECT_TRUE(tree.isConforming());
    EXPECT_EQ(tree.enhMerge({0, 1}), 4u);
    EXPECT_EQ(tree.leafCount(), 26u) << "the root beside it stays split";
    EXPECT_EQ(tree.enhMerge({0, 1}), 0u);
}

TEST(BisectionTree, staysConformingThroughRandomOperationsOnAnyMesh)
{
    for (const BisectionSurface& surface :
         {testsupport::madeSphere(1), testsupport::madeTin(1), testsupport::madeOverhang(1)})
    {
        BisectionTree tree(surface.mesh(), kTreeLevels);
        testsupport::Random random(3);
        for (int i = 0; i < 10000; ++i)
        {
            Bisector t = randomLeaf(tree, random);
            if (random.below(5) != 0)
            {
                if (t.level() < kTreeLevels) tree.forceSplit(t);
            }
            else if (t.node > 1)
                tree.enhMerge({t.side, t.node >> (1 + random.below(static_cast<std::uint32_t>(t.level())))});
            if (i % 500 == 0)
            {
                ASSERT_TRUE(tree.isConforming()) << i;
            }
        }
        EXPECT_TRUE(tree.isConforming());
        for (std::uint32_t side = 0; side < surface.mesh().sides(); ++side)
            tree.enhMerge({side, 1});
        EXPECT_EQ(tree.leafCount(), surface.mesh().sides()) << "the inverse of all splits";
    }
}

/// What is left without a vertex, step by step: triangles go whose parents, or whose base neighbour, have
/// gone.
std::vector<bool> splitsWithout(const BisectionTree& tree, Bisector removed)
{
    std::vector<bool> splits = splitsOf(tree);
    const auto place = [&](Bisector t) { return std::size_t{t.side} << tree.levels() | t.node; };
    splits[place(removed)] = false;
    for (bool isChanging = true; isChanging;)
    {
        isChanging = false;
        for (std::uint32_t side = 0; side < tree.mesh().sides(); ++side)
            for (std::uint32_t node = 1; node < 1u << tree.levels(); ++node)
            {
                const Bisector t{side, node}, base = neighboursOf(tree.mesh(), t).base;
                if (!splits[place(t)]) continue;
                if ((node == 1 || splits[place(t.parent())]) && (!base.exists() || splits[place(base)]))
                    continue;
                splits[place(t)] = false;
                isChanging = true;
            }
    }
    return splits;
}

TEST(BisectionTree, enhMergeRemovesWhatDependsOnTheVertexAndNoMore)
{
    const CoarseMesh cube = cubeMesh();
    testsupport::Random random(8);
    for (int turn = 0; turn < 20; ++turn)
    {
        BisectionTree tree(cube, kTreeLevels);
        for (int i = 0; i < 200; ++i)
            if (const Bisector t = randomLeaf(tree, random); t.level() < kTreeLevels) tree.forceSplit(t);
        const Bisector leaf = randomLeaf(tree, random);
        if (leaf.node == 1) continue;
        const Bisector t{leaf.side,
                         leaf.node >> (1 + random.below(static_cast<std::uint32_t>(leaf.level())))};
        const std::vector<bool> wanted = splitsWithout(tree, t);
        const std::uint32_t before = tree.leafCount(), merged = tree.enhMerge(t);
        EXPECT_EQ(splitsOf(tree), wanted);
        EXPECT_EQ(tree.leafCount() + merged, before);
    }
}

TEST(BisectionTree, damageIsFound)
{
    const CoarseMesh cube = cubeMesh();
    BisectionTree tree(cube, kTreeLevels);
    for (std::uint32_t node : {1u, 2u, 4u, 8u})
        tree.forceSplit({5, node});
    ASSERT_TRUE(tree.isConforming());
    for (const std::uint32_t node : {1u, 2u, 3u, 8u, 16u, 77u})
    {
        BisectionTreeMutator::flip(tree, {5, node});
        EXPECT_FALSE(tree.isConforming()) << node;
        BisectionTreeMutator::flip(tree, {5, node});
    }
    BisectionTreeMutator::miscount(tree);
    EXPECT_FALSE(tree.isConforming());
}

} // namespace

} // namespace osgTerrainROAM::core
