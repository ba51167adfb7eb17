// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/LeafArena.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

/// Keeps the slots of an arena's leaves, as its user must.
struct Keeper
{
    explicit Keeper(std::uint32_t regions) : arena(regions) {}

    struct Leaf
    {
        std::uint32_t region, slot;
    };

    void note(const MeshChanges& changes, std::size_t from)
    {
        for (std::size_t i = from; i < changes.triangles.size(); ++i)
            if (const TriangleId leaf = arena.leaf(changes.triangles[i]); leaf.exists())
                leaves[leaf.apex()].slot = changes.triangles[i];
    }

    void insert(VertexSlot apex, std::uint32_t region, MeshChanges& changes)
    {
        leaves[apex].region = region;
        const std::size_t from = changes.triangles.size();
        arena.insert(TriangleId(apex, 0), region, changes);
        note(changes, from);
    }

    void erase(VertexSlot apex, MeshChanges& changes)
    {
        const Leaf leaf = leaves.at(apex);
        leaves.erase(apex);
        const std::size_t from = changes.triangles.size();
        arena.erase(leaf.slot, changes);
        note(changes, from);
    }

    bool isRight() const
    {
        for (const auto& [apex, leaf] : leaves)
        {
            const TriangleRange range = arena.region(leaf.region);
            const bool inRegion = leaf.slot >= range.first && leaf.slot < range.first + range.count;
            if (!inRegion || arena.leaf(leaf.slot) != TriangleId(apex, 0)) return false;
        }
        return arena.isConsistent() && arena.leafCount() == leaves.size();
    }

    LeafArena arena;
    std::map<VertexSlot, Leaf> leaves;
};

TEST(LeafArena, KeepsEveryRegionsLeavesTogetherThroughRandomChanges)
{
    Keeper keeper(5);
    MeshChanges changes;
    testsupport::Random random(11);
    for (int i = 0; i < 20000; ++i)
    {
        const VertexSlot apex = random.below(700);
        if (keeper.leaves.count(apex))
            keeper.erase(apex, changes);
        else
            keeper.insert(apex, random.below(5), changes);
        ASSERT_TRUE(i % 100 != 0 || keeper.isRight());
    }
}

TEST(LeafArena, ReportsEverySlotItWrites)
{
    Keeper keeper(3);
    testsupport::Random random(5);
    std::vector<TriangleId> mirror; // what a graphics card would hold that was sent the changes alone
    for (int frame = 0; frame < 300; ++frame)
    {
        MeshChanges changes;
        for (int i = 0; i < 25; ++i)
        {
            const VertexSlot apex = random.below(400);
            if (!keeper.leaves.count(apex))
                keeper.insert(apex, apex % 3, changes);
            else if (random.below(3) != 0)
                keeper.erase(apex, changes);
            else // its slot goes to another leaf of the region
            {
                const Keeper::Leaf leaf = keeper.leaves.at(apex);
                const VertexSlot heir = apex + 400;
                if (keeper.leaves.count(heir)) continue;
                keeper.arena.replace(leaf.slot, TriangleId(heir, 0), changes);
                keeper.leaves.erase(apex);
                keeper.leaves[heir] = leaf;
            }
        }
        mirror.resize(keeper.arena.slotCount());
        for (const std::uint32_t slot : changes.triangles)
            mirror[slot] = keeper.arena.leaf(slot);
        for (const auto& [apex, leaf] : keeper.leaves)
            ASSERT_EQ(mirror[leaf.slot], TriangleId(apex, 0));
        ASSERT_TRUE(keeper.isRight());
    }
}

TEST(LeafArena, ClosesManyGapsAtOnceAndReusesTheRoom)
{
    Keeper keeper(3);
    MeshChanges changes;
    testsupport::Random random(4);
    std::uint32_t most = 0;
    for (int round = 0; round < 50; ++round)
    {
        for (VertexSlot apex = 0; apex < 300; ++apex)
            if (!keeper.leaves.count(apex)) keeper.insert(apex, apex % 3, changes);
        ASSERT_TRUE(keeper.isRight());
        if (round == 0) most = keeper.arena.slotCount();
        const std::uint32_t share = random.below(101);
        const std::size_t from = changes.triangles.size();
        for (VertexSlot apex = 0; apex < 300; ++apex)
        {
            if (random.below(100) >= share) continue;
            const Keeper::Leaf leaf = keeper.leaves.at(apex);
            keeper.arena.cutOut(leaf.slot);
            keeper.leaves.erase(apex);
        }
        keeper.arena.closeGaps(changes);
        keeper.note(changes, from);
        ASSERT_TRUE(keeper.isRight());
    }
    EXPECT_LE(keeper.arena.slotCount(), 2 * most);
}

TEST(MeshChanges, SlotsJoinIntoRangesAcrossSmallGaps)
{
    const auto ranges = joinedRanges({9, 3, 4, 4, 12, 40}, 2);
    ASSERT_EQ(ranges.size(), 3u);
    EXPECT_EQ(ranges[0].first, 3u);
    EXPECT_EQ(ranges[0].count, 2u);
    EXPECT_EQ(ranges[1].first, 9u);
    EXPECT_EQ(ranges[1].count, 4u);
    EXPECT_EQ(ranges[2].first, 40u);
    EXPECT_TRUE(joinedRanges({}, 8).empty());
}

} // namespace
