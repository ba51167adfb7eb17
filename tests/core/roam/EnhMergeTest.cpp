// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>

#include "FullSplit.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

/// Samples of all leaves, drawn or not.
std::set<std::array<SampleIndex, 3>> leafSet(const BinTriangleTree& tree)
{
    std::set<std::array<SampleIndex, 3>> leaves;
    std::vector<NodeIndex> open{0, 1};
    while (!open.empty())
    {
        const BinTriangle& node = tree.node(open.back());
        open.pop_back();
        if (node.isLeaf())
            leaves.insert({tree.sampleOf(node.vertices[0]), tree.sampleOf(node.vertices[1]),
                           tree.sampleOf(node.vertices[2])});
        else
            open.insert(open.end(), {node.firstChild, node.firstChild + 1});
    }
    return leaves;
}

/// Trees of one tile whose history is the same, so that node indices mean the same in each.
struct Twins
{
    explicit Twins(int columns, int rows)
        : tile(testsupport::planarTile(testsupport::hills(columns, rows))), one(tile), other(tile)
    {
    }

    /// Splits towards random places, deeper near one of them.
    void grow(Random& random, int splits)
    {
        for (int i = 0; i < splits; ++i)
        {
            NodeIndex t = BinTriangleTree::kRoots[random.below(2)];
            while (!one.node(t).isLeaf())
                t = one.node(t).firstChild + (random.below(3) == 0 ? 1u : 0u);
            if (!one.canSplit(t)) continue;
            one.forceSplit(t);
            other.forceSplit(t);
        }
    }

    std::shared_ptr<const RoamTile> tile;
    BinTriangleTree one, other;
};

/// A split triangle on a random way down; kNone when there is none.
NodeIndex randomSplit(const BinTriangleTree& tree, Random& random, unsigned stopOneIn)
{
    NodeIndex t = BinTriangleTree::kRoots[random.below(2)];
    while (!tree.node(t).isLeaf() && random.below(stopOneIn) != 0)
        t = tree.node(t).firstChild + random.below(2);
    return tree.node(t).isLeaf() ? tree.node(t).parent : t;
}

TEST(EnhMerge, LeavesTheMeshThatSingleMergesLeave)
{
    Random random(11);
    for (int round = 0; round < 60; ++round)
    {
        Twins twins(round % 3 == 0 ? 23 : 33, 33);
        twins.grow(random, 20 + static_cast<int>(random.below(400)));
        const NodeIndex t = randomSplit(twins.one, random, 4);
        if (t == kNone) continue;
        const std::uint32_t before = twins.one.leafCount();
        const std::uint32_t merges = twins.one.enhMerge(t);
        EXPECT_EQ(merges, twins.other.forceMerge(t));
        EXPECT_EQ(before - merges, twins.one.leafCount());
        ASSERT_TRUE(twins.one.isConforming()) << "round " << round;
        ASSERT_EQ(leafSet(twins.one), leafSet(twins.other)) << "round " << round;
    }
}

/// Whether a place of a 33×33 tile lies in a triangle, its border included.
bool touches(const BinTriangleTree& tree, NodeIndex t, int column, int row)
{
    constexpr int kSide = 33;
    const auto corner = [&](int i) { return static_cast<int>(tree.sampleOf(tree.node(t).vertices[i])); };
    for (int i = 0; i < 3; ++i)
    {
        const int a = corner(i), b = corner((i + 1) % 3);
        const int across =
            (b % kSide - a % kSide) * (row - a / kSide) - (b / kSide - a / kSide) * (column - a % kSide);
        if (across < 0) return false;
    }
    return true;
}

/// Splits everything around one place to the finest level.
void refineAround(Twins& twins, int column, int row)
{
    std::vector<NodeIndex> open{0, 1};
    while (!open.empty())
    {
        const NodeIndex t = open.back();
        open.pop_back();
        if (!touches(twins.one, t, column, row)) continue;
        if (twins.one.canSplit(t))
        {
            twins.one.forceSplit(t);
            twins.other.forceSplit(t);
        }
        if (const BinTriangle& node = twins.one.node(t); !node.isLeaf())
            open.insert(open.end(), {node.firstChild, node.firstChild + 1});
    }
}

/// The way around a corner, finer at every step, leads back into what is being merged.
TEST(EnhMerge, IsNotLostInASpiralAroundACorner)
{
    for (const auto& [column, row] :
         {std::pair{8, 8}, std::pair{16, 16}, std::pair{16, 8}, std::pair{12, 20}})
    {
        Twins twins(33, 33);
        refineAround(twins, column, row);
        std::vector<NodeIndex> open{0, 1};
        std::size_t tried = 0;
        while (!open.empty())
        {
            const NodeIndex t = open.back();
            open.pop_back();
            if (twins.one.node(t).isLeaf()) continue;
            open.insert(open.end(), {twins.one.node(t).firstChild, twins.one.node(t).firstChild + 1});
            BinTriangleTree merged = twins.one, reference = twins.other;
            ASSERT_EQ(merged.enhMerge(t), reference.forceMerge(t));
            ASSERT_TRUE(merged.isConforming());
            ASSERT_EQ(leafSet(merged), leafSet(reference));
            ++tried;
        }
        EXPECT_GT(tried, 50u);
    }
}

TEST(EnhMerge, EveryOperationOfARandomMixLeavesAConformingMesh)
{
    BinTriangleTree tree(testsupport::planarTile(testsupport::hills(33, 20)));
    Random random(5);
    std::uint32_t largest = 0, removed = 0;
    for (int i = 0; i < 6000; ++i)
    {
        const bool grow = random.below(100) < (i / 300 % 2 == 0 ? 93u : 40u);
        if (grow)
        {
            NodeIndex t = BinTriangleTree::kRoots[random.below(2)];
            while (!tree.node(t).isLeaf())
                t = tree.node(t).firstChild + random.below(2);
            if (tree.canSplit(t)) tree.forceSplit(t);
        }
        else if (const NodeIndex t = randomSplit(tree, random, 9); t != kNone)
        {
            if (tree.isMergeable(t))
                tree.merge(t);
            else
                removed += tree.enhMerge(t);
        }
        ASSERT_TRUE(tree.isConforming()) << "operation " << i;
        largest = std::max(largest, tree.leafCount());
    }
    EXPECT_GT(largest, 150u);
    EXPECT_GT(removed, 500u);
}

TEST(EnhMerge, WhatItCutOffIsUsedAgain)
{
    BinTriangleTree tree(testsupport::planarTile(testsupport::hills(65, 65)));
    testsupport::splitFully(tree);
    const std::size_t vertices = tree.vertices().size(), slots = tree.leaves().triangles().size();
    const std::uint32_t leaves = tree.leafCount();
    for (int i = 0; i < 4; ++i)
    {
        const std::uint32_t merges = tree.enhMerge(i % 2 == 0 ? 0 : tree.node(0).firstChild);
        EXPECT_EQ(merges, leaves - tree.leafCount());
        EXPECT_TRUE(tree.isConforming());
        testsupport::splitFully(tree);
        EXPECT_EQ(tree.leafCount(), leaves);
    }
    EXPECT_EQ(tree.vertices().size(), vertices);
    EXPECT_LE(tree.leaves().triangles().size(), slots + slots / 8);
    EXPECT_TRUE(tree.isConforming());
}

} // namespace
