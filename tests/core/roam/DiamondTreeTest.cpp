// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

#include "SyntheticField.h"
#include "TreeWalks.h"
#include "measurement/SplitFully.h"

namespace osgTerrainROAM::core
{

/// Breaks a tree in one place, to prove that the check sees it.
struct DiamondTreeMutator
{
    DiamondTree& tree;
    DiamondPlace& place(VertexSlot v) { return tree._places[v]; }
    VertexSlot& parent(VertexSlot v, int i) { return tree._diamonds[v].parents[i]; }
    std::uint32_t& link(TriangleId t) { return tree.link(t); }
    void loseVertexSlot() { tree._freeSlots.push_back(4); }
    void splitAlone(TriangleId t) { tree.splitLeaf(t, tree.addVertex(t, tree.acrossBase(t))); }
};

} // namespace osgTerrainROAM::core

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;
using testsupport::randomDescent;

DiamondTree hillTree(int columns = 33, int rows = 33)
{
    return DiamondTree(testsupport::planarTile(testsupport::hills(columns, rows)));
}

/// The first leaf on the way that always takes one half.
TriangleId leafBelow(const DiamondTree& tree, TriangleId t, unsigned half)
{
    while (!tree.isLeaf(t))
        t = tree.children(t)[half];
    return t;
}

TEST(DiamondTree, StartsAsTwoTriangles)
{
    const DiamondTree tree = hillTree();
    EXPECT_EQ(tree.leafCount(), 2u);
    EXPECT_TRUE(tree.isConforming());
}

TEST(DiamondTree, SplittingTheRootSplitsTheDiamond)
{
    DiamondTree tree = hillTree();
    EXPECT_EQ(tree.splitsNeeded(DiamondTree::kRoots[0]), 2u);
    EXPECT_EQ(tree.forceSplit(DiamondTree::kRoots[0]), 2u);
    EXPECT_EQ(tree.leafCount(), 4u);
    EXPECT_EQ(tree.vertexSlots(), 5u);
    EXPECT_TRUE(tree.isConforming());
}

TEST(DiamondTree, HalvesAreThoseOfTheGridTriangle)
{
    DiamondTree tree = hillTree();
    measurement::splitFully(tree);
    std::vector<TriangleId> open(std::begin(DiamondTree::kRoots), std::end(DiamondTree::kRoots));
    while (!open.empty())
    {
        const TriangleId t = open.back();
        open.pop_back();
        if (tree.isLeaf(t)) continue;
        const auto wanted = tree.gridTriangle(t).children();
        const auto children = tree.children(t);
        for (std::size_t half = 0; half < 2; ++half)
        {
            ASSERT_EQ(tree.gridTriangle(children[half]), wanted[half]);
            open.push_back(children[half]);
        }
    }
}

TEST(DiamondTree, SplittingOneCornerForcesTheChainOfCoarserNeighbours)
{
    DiamondTree tree = hillTree();
    TriangleId t = DiamondTree::kRoots[0];
    std::uint32_t splits = 0, longest = 0;
    while (!tree.isLeaf(t) || tree.canSplit(t))
    {
        if (tree.isLeaf(t))
        {
            const std::uint32_t needed = tree.splitsNeeded(t), done = tree.forceSplit(t);
            EXPECT_EQ(done, needed);
            splits += done;
            longest = std::max(longest, done);
        }
        t = tree.children(t)[0];
    }
    EXPECT_EQ(tree.level(t), 10); // 33 = 2^5 + 1
    EXPECT_GT(longest, 2u);
    EXPECT_EQ(tree.leafCount(), 2u + splits);
    EXPECT_TRUE(tree.isConforming());
}

TEST(DiamondTree, MergeUndoesSplit)
{
    DiamondTree tree = hillTree();
    Random random(3);
    for (int i = 0; i < 200; ++i)
        if (const TriangleId t = randomDescent(tree, random); tree.canSplit(t)) tree.forceSplit(t);
    for (int i = 0; i < 200; ++i)
    {
        const TriangleId t = randomDescent(tree, random);
        if (!tree.canSplit(t)) continue;
        const bool chained = tree.splitsNeeded(t) > 2;
        const auto before = testsupport::leafSet(tree);
        tree.forceSplit(t);
        tree.merge(tree.splitVertex(t));
        if (chained) continue; // what was forced stays
        ASSERT_EQ(testsupport::leafSet(tree), before);
    }
    EXPECT_TRUE(tree.isConforming());
    tree.forceMerge(tree.splitVertex(DiamondTree::kRoots[0]));
    EXPECT_EQ(tree.leafCount(), 2u);
    EXPECT_TRUE(tree.isConforming());
}

TEST(DiamondTree, PoolsAreReusedSoThatRepetitionNeedsNoMemory)
{
    DiamondTree tree = hillTree();
    measurement::splitFully(tree);
    EXPECT_EQ(tree.leafCount(), 2u * 32 * 32);
    EXPECT_EQ(tree.vertexSlots(), 33u * 33);
    const std::size_t slots = tree.leaves().slotCount();
    for (int i = 0; i < 5; ++i)
    {
        tree.forceMerge(tree.splitVertex(DiamondTree::kRoots[0]));
        measurement::splitFully(tree);
    }
    EXPECT_EQ(tree.vertexSlots(), 33u * 33);
    EXPECT_LE(tree.leaves().slotCount(), slots + slots / 4);
    EXPECT_TRUE(tree.isConforming());
}

TEST(DiamondTree, LeavesBeyondTheDataAreNotDrawn)
{
    DiamondTree tree = hillTree(20, 33);
    measurement::splitFully(tree);
    EXPECT_EQ(tree.leafCount(), 2u * 32 * 32);
    EXPECT_EQ(tree.leaves().leafCount(), 2u * 19 * 32);
    EXPECT_TRUE(tree.isConforming());
}

TEST(DiamondTree, RegionsAreTheSubtreesAtTheirLevel)
{
    for (const int side : {5, 33, 129})
    {
        DiamondTree tree = hillTree(side, side);
        measurement::splitFully(tree);
        // Down the tree with the path that RegionBounds counts.
        const int level = tree.tile().regions.level();
        std::vector<std::pair<TriangleId, std::uint32_t>> open{{DiamondTree::kRoots[0], 0},
                                                               {DiamondTree::kRoots[1], 1}};
        while (!open.empty())
        {
            const auto [t, path] = open.back();
            open.pop_back();
            ASSERT_EQ(tree.regionOf(t), tree.level(t) >= level ? path + 1 : 0u);
            if (tree.isLeaf(t)) continue;
            for (const std::uint32_t half : {0u, 1u})
                open.emplace_back(tree.children(t)[half], tree.level(t) < level ? 2 * path + half : path);
        }
    }
}

TEST(DiamondTree, CheckSeesEveryKindOfDamage)
{
    const auto damaged = [](auto damage)
    {
        DiamondTree tree = hillTree();
        for (int i = 0; i < 4; ++i)
            tree.forceSplit(leafBelow(tree, DiamondTree::kRoots[0], 1));
        EXPECT_TRUE(tree.isConforming());
        DiamondTreeMutator mutator{tree};
        const TriangleId leaf = leafBelow(tree, DiamondTree::kRoots[0], 1);
        EXPECT_TRUE(tree.acrossBase(leaf).exists());
        damage(tree, mutator, leaf);
        return !tree.isConforming();
    };
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId) { m.place(5).column += 2; }));
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId) { m.place(5).level += 2; }));
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId leaf)
                        { std::swap(m.parent(leaf.apex(), 0), m.parent(leaf.apex(), 1)); }));
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId leaf) { m.place(leaf.apex()).firstQuadrant ^= 1; }));
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId leaf) { m.link(leaf) += 1; })); // another leaf's slot
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId) { m.loseVertexSlot(); }));
    EXPECT_TRUE(damaged([](auto&, auto& m, TriangleId leaf) { m.splitAlone(leaf); })); // a T-junction
}

} // namespace
