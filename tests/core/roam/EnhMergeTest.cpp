// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

#include "SyntheticField.h"
#include "TreeWalks.h"
#include "measurement/SplitFully.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::leafSet;
using testsupport::Random;
using testsupport::randomDescent;
using testsupport::randomVertex;

/// Trees of one tile whose history is the same, so that vertex slots mean the same in each.
struct Twins
{
    Twins(int columns, int rows)
        : tile(testsupport::planarTile(testsupport::hills(columns, rows))), one(tile), other(tile)
    {
    }

    void split(TriangleId t)
    {
        if (!one.canSplit(t)) return;
        one.forceSplit(t);
        other.forceSplit(t);
    }

    /// Splits towards random places, deeper on one side.
    void grow(Random& random, int splits)
    {
        for (int i = 0; i < splits; ++i)
        {
            TriangleId t = DiamondTree::kRoots[random.below(2)];
            while (!one.isLeaf(t))
                t = one.children(t)[random.below(3) == 0 ? 1u : 0u];
            split(t);
        }
    }

    std::shared_ptr<const RoamTile> tile;
    DiamondTree one, other;
};

TEST(EnhMerge, LeavesTheMeshThatSingleMergesLeave)
{
    Random random(11);
    for (int round = 0; round < 200; ++round)
    {
        Twins twins(round % 3 == 0 ? 23 : 33, 33);
        twins.grow(random, 20 + static_cast<int>(random.below(400)));
        const VertexSlot v = randomVertex(twins.one, random, 4);
        if (v == kNone) continue;
        const std::uint32_t before = twins.one.leafCount();
        const std::uint32_t merges = twins.one.enhMerge(v);
        EXPECT_EQ(merges, twins.other.forceMerge(v));
        EXPECT_EQ(before - merges, twins.one.leafCount());
        ASSERT_TRUE(twins.one.isConforming()) << "round " << round;
        ASSERT_EQ(leafSet(twins.one), leafSet(twins.other)) << "round " << round;
    }
}

/// Whether a place lies in a triangle, its border included.
bool touches(const GridTriangle& t, GridPoint p)
{
    const auto across = [p](GridPoint a, GridPoint b)
    { return (b.column - a.column) * (p.row - a.row) - (b.row - a.row) * (p.column - a.column); };
    return across(t.apex, t.left) >= 0 && across(t.left, t.right) >= 0 && across(t.right, t.apex) >= 0;
}

/// Splits everything around one place to the finest level.
void refineAround(Twins& twins, GridPoint p)
{
    std::vector<TriangleId> open(std::begin(DiamondTree::kRoots), std::end(DiamondTree::kRoots));
    while (!open.empty())
    {
        const TriangleId t = open.back();
        open.pop_back();
        if (!touches(twins.one.gridTriangle(t), p)) continue;
        twins.split(t);
        if (twins.one.isLeaf(t)) continue;
        for (const TriangleId child : twins.one.children(t))
            open.push_back(child);
    }
}

/// The way around a corner, finer at every step, leads back into what is being merged.
TEST(EnhMerge, IsNotLostInASpiralAroundACorner)
{
    for (const GridPoint p : {GridPoint{8, 8}, GridPoint{16, 16}, GridPoint{16, 8}, GridPoint{12, 20}})
    {
        Twins twins(33, 33);
        refineAround(twins, p);
        std::size_t tried = 0;
        for (VertexSlot v = DiamondTree::kCorners; v < twins.one.vertexSlots(); ++v)
        {
            DiamondTree merged = twins.one, reference = twins.other;
            ASSERT_EQ(merged.enhMerge(v), reference.forceMerge(v));
            ASSERT_TRUE(merged.isConforming());
            ASSERT_EQ(leafSet(merged), leafSet(reference));
            ++tried;
        }
        EXPECT_GT(tried, 30u);
    }
}

/// A million random operations in all, in four shards, each validated: forced splits, merges and enhMerges,
/// in phases of growth and of decline, so that every size is met often.
class RandomOperations : public testing::TestWithParam<int>
{
};

TEST_P(RandomOperations, EachLeavesAConformingMesh)
{
    const int shard = GetParam();
    DiamondTree tree(
        testsupport::planarTile(shard % 2 == 0 ? testsupport::hills(9, 9) : testsupport::hills(17, 12)));
    Random random(static_cast<std::uint64_t>(5 + shard));
    std::uint32_t largest = 0, removed = 0, smallest = 1000000;
    for (int i = 0; i < 250000; ++i)
    {
        const bool grow = random.below(100) < (i / 300 % 2 == 0 ? 93u : 40u);
        if (grow)
        {
            if (const TriangleId t = randomDescent(tree, random); tree.canSplit(t)) tree.forceSplit(t);
        }
        else if (const VertexSlot v = randomVertex(tree, random, 9); v != kNone)
        {
            if (tree.isMergeable(v))
                tree.merge(v);
            else
                removed += tree.enhMerge(v);
        }
        tree.clearChanges();
        ASSERT_TRUE(tree.isConforming()) << "operation " << i;
        largest = std::max(largest, tree.leafCount());
        smallest = std::min(smallest, tree.leafCount());
    }
    EXPECT_GT(largest, 80u);
    EXPECT_EQ(smallest, 2u);
    EXPECT_GT(removed, 50000u);
}

INSTANTIATE_TEST_SUITE_P(Shards, RandomOperations, testing::Range(0, 4));

TEST(EnhMerge, WhatItTookOutIsUsedAgain)
{
    DiamondTree tree(testsupport::planarTile(testsupport::hills(129, 129)));
    measurement::splitFully(tree);
    const std::size_t vertices = tree.vertexSlots(), slots = tree.leaves().slotCount();
    const std::uint32_t leaves = tree.leafCount();
    for (int i = 0; i < 4; ++i)
    {
        const TriangleId root = DiamondTree::kRoots[0];
        const std::uint32_t merges =
            tree.enhMerge(tree.splitVertex(i % 2 == 0 ? root : tree.children(root)[0]));
        EXPECT_EQ(merges, leaves - tree.leafCount());
        EXPECT_TRUE(tree.isConforming());
        measurement::splitFully(tree);
        EXPECT_EQ(tree.leafCount(), leaves);
    }
    EXPECT_EQ(tree.vertexSlots(), vertices);
    EXPECT_LE(tree.leaves().slotCount(), slots + slots / 8);
    EXPECT_TRUE(tree.isConforming());
}

} // namespace
