// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>

#include "FullSplit.h"
#include "SyntheticField.h"

namespace osgTerrainROAM::core
{

/// Breaks a tree in one place, to prove that the check sees it.
struct BinTriangleTreeMutator
{
    BinTriangleTree& tree;
    BinTriangle& node(NodeIndex t) { return tree._nodes[t]; }
    void moveVertex(std::uint32_t slot, SampleIndex sample) { tree._sampleOfVertex[slot] = sample; }
    void loseVertexSlot() { tree._freeVertices.push_back(0); }
    void splitAlone(NodeIndex t) { tree.splitOne(t, tree.addVertex(tree.node(t).splitSample)); }
};

} // namespace osgTerrainROAM::core

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

BinTriangleTree hillTree(int side = 33)
{
    return BinTriangleTree(testsupport::planarTile(testsupport::hills(side, side)));
}

/// A random leaf that can split, or a random split triangle: found by a random way down.
NodeIndex randomNode(const BinTriangleTree& tree, Random& random, bool leaf)
{
    NodeIndex t = BinTriangleTree::kRoots[random.below(2)];
    while (!tree.node(t).isLeaf())
    {
        if (!leaf && random.below(6) == 0) return t;
        t = tree.node(t).firstChild + random.below(2);
    }
    return leaf ? t : tree.node(t).parent;
}

TEST(BinTriangleTree, StartsAsTwoTriangles)
{
    const BinTriangleTree tree = hillTree();
    EXPECT_EQ(tree.leafCount(), 2u);
    EXPECT_TRUE(tree.isConforming());
}

TEST(BinTriangleTree, SplittingTheRootSplitsTheDiamond)
{
    BinTriangleTree tree = hillTree();
    EXPECT_EQ(tree.forceSplit(0), 2u);
    EXPECT_EQ(tree.leafCount(), 4u);
    EXPECT_EQ(tree.vertices().size(), 5u);
    EXPECT_TRUE(tree.isConforming());
}

TEST(BinTriangleTree, SplittingOneCornerForcesTheChainOfCoarserNeighbours)
{
    BinTriangleTree tree = hillTree();
    NodeIndex t = 0;
    std::uint32_t splits = 0;
    while (tree.node(t).isLeaf() ? tree.canSplit(t) : true)
    {
        if (tree.node(t).isLeaf()) splits += tree.forceSplit(t);
        t = tree.node(t).firstChild;
    }
    EXPECT_EQ(tree.node(t).level, 10); // 33 = 2^5 + 1
    EXPECT_GT(splits, 10u);
    EXPECT_EQ(tree.leafCount(), 2u + splits);
    EXPECT_TRUE(tree.isConforming());
}

TEST(BinTriangleTree, StaysConformingAfterTenThousandRandomSplitsAndMerges)
{
    BinTriangleTree tree = hillTree();
    Random random(7);
    std::uint32_t largest = 0;
    for (int i = 0; i < 10000; ++i)
    {
        // Phases of growth and of decline, so that every size is met often.
        const bool grow = random.below(100) < (i / 500 % 2 == 0 ? 80u : 20u);
        const NodeIndex t = randomNode(tree, random, grow);
        if (grow && tree.canSplit(t))
            tree.forceSplit(t);
        else if (!grow && t != kNone && tree.isMergeable(t))
            tree.merge(t);
        else if (!grow && t != kNone && tree.node(t).level > 5)
            tree.forceMerge(t);
        ASSERT_TRUE(i % 10 != 0 || tree.isConforming()) << "operation " << i;
        largest = std::max(largest, tree.leafCount());
    }
    EXPECT_GT(largest, 500u);
}

TEST(BinTriangleTree, MergeUndoesSplitToTheLastBit)
{
    BinTriangleTree tree = hillTree();
    Random random(3);
    for (int i = 0; i < 200; ++i)
        if (const NodeIndex t = randomNode(tree, random, true); tree.canSplit(t)) tree.forceSplit(t);
    const std::uint32_t leaves = tree.leafCount();
    for (int i = 0; i < 200; ++i)
    {
        const NodeIndex t = randomNode(tree, random, true);
        if (!tree.canSplit(t)) continue;
        const BinTriangle before = tree.node(t);
        const bool chained = before.base != kNone && tree.node(before.base).base != t;
        tree.forceSplit(t);
        tree.merge(t);
        if (chained) continue; // what was forced stays
        const BinTriangle& after = tree.node(t);
        ASSERT_EQ(std::tie(after.base, after.left, after.right),
                  std::tie(before.base, before.left, before.right));
    }
    EXPECT_GE(tree.leafCount(), leaves);
    EXPECT_TRUE(tree.isConforming());
    tree.forceMerge(0);
    EXPECT_EQ(tree.leafCount(), 2u);
    EXPECT_TRUE(tree.isConforming());
}

TEST(BinTriangleTree, PoolsAreReusedSoThatRepetitionNeedsNoMemory)
{
    BinTriangleTree tree = hillTree();
    testsupport::splitFully(tree);
    EXPECT_EQ(tree.leafCount(), 2u * 32 * 32);
    const std::size_t vertices = tree.vertices().size(), slots = tree.leaves().triangles().size();
    for (int i = 0; i < 5; ++i)
    {
        tree.forceMerge(0);
        testsupport::splitFully(tree);
    }
    EXPECT_EQ(tree.vertices().size(), vertices);
    EXPECT_EQ(tree.leaves().triangles().size(), slots);
    EXPECT_TRUE(tree.isConforming());
}

TEST(BinTriangleTree, LeavesBeyondTheDataAreNotDrawn)
{
    BinTriangleTree tree(testsupport::planarTile(testsupport::hills(20, 33)));
    for (int i = 0; i < 6; ++i)
        for (NodeIndex t : {NodeIndex{0}, NodeIndex{1}})
            while (!tree.node(t).isLeaf() || tree.canSplit(t))
            {
                if (tree.node(t).isLeaf()) tree.forceSplit(t);
                t = tree.node(t).firstChild + static_cast<NodeIndex>(i % 2);
                if (tree.node(t).level > i + 3) break;
            }
    EXPECT_LT(tree.leaves().leafCount(), tree.leafCount());
    EXPECT_TRUE(tree.isConforming());
}

TEST(BinTriangleTree, CheckSeesEveryKindOfDamage)
{
    const auto damaged = [](auto damage)
    {
        BinTriangleTree tree = hillTree();
        for (int i = 0; i < 4; ++i)
        {
            NodeIndex t = 0;
            while (!tree.node(t).isLeaf())
                t = tree.node(t).firstChild + 1;
            tree.forceSplit(t);
        }
        EXPECT_TRUE(tree.isConforming());
        BinTriangleTreeMutator mutator{tree};
        damage(tree, mutator);
        return !tree.isConforming();
    };
    NodeIndex leaf = 0;
    const auto findLeaf = [&leaf](const BinTriangleTree& tree)
    {
        leaf = 0;
        while (!tree.node(leaf).isLeaf() || tree.node(leaf).base == kNone)
            leaf = tree.node(leaf).isLeaf() ? 1 : tree.node(leaf).firstChild;
        return leaf;
    };
    EXPECT_TRUE(damaged([&](auto& tree, auto& m) { m.node(findLeaf(tree)).base = kNone; }));
    EXPECT_TRUE(
        damaged([&](auto& tree, auto& m) { std::swap(m.node(findLeaf(tree)).left, m.node(leaf).right); }));
    EXPECT_TRUE(damaged([&](auto& tree, auto& m) { m.node(findLeaf(tree)).level += 3; }));
    EXPECT_TRUE(damaged([&](auto& tree, auto& m)
                        { std::swap(m.node(findLeaf(tree)).vertices[0], m.node(leaf).vertices[1]); }));
    EXPECT_TRUE(damaged([](auto&, auto& m) { m.moveVertex(4, 17); }));
    EXPECT_TRUE(damaged([](auto&, auto& m) { m.loseVertexSlot(); }));
    EXPECT_TRUE(damaged([&](auto& tree, auto& m) { m.splitAlone(findLeaf(tree)); })); // a T-junction
}

} // namespace
