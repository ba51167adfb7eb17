// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/LeafArena.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

/// Keeps the slots of an arena's leaves, as its user must, the order in which they have to lie, and what a
/// graphics card would hold that was sent the changes alone.
struct Keeper
{
    Keeper(std::uint32_t regions, LeafPlacement placement) : arena(regions, placement), order(regions) {}

    static TriangleId leaf(VertexSlot name) { return {name, 0}; }

    void note()
    {
        mirror.resize(arena.slotCount(), leaf(0)); // of a new buffer the content is not known
        for (const std::uint32_t slot : changes.triangles)
        {
            mirror[slot] = arena.leaf(slot);
            if (mirror[slot].exists()) slots[mirror[slot].apex()] = slot;
        }
        changes.clear();
    }

    void start(std::uint32_t region)
    {
        order[region].push_back(++last);
        arena.insert(leaf(last), region, changes);
        note();
    }

    void split(std::uint32_t region, std::size_t place)
    {
        std::vector<VertexSlot>& names = order[region];
        const std::uint32_t slot = slots.at(names[place]);
        slots.erase(names[place]);
        names[place] = ++last;
        names.insert(names.begin() + static_cast<std::ptrdiff_t>(place) + 1, ++last);
        arena.split(slot, leaf(last - 1), leaf(last), changes);
        note();
    }

    /// Two neighbours become one, as where halves merge.
    void merge(std::uint32_t region, std::size_t place)
    {
        std::vector<VertexSlot>& names = order[region];
        erase(region, place + 1);
        const std::uint32_t slot = slots.at(names[place]);
        slots.erase(names[place]);
        names[place] = ++last;
        arena.replace(slot, leaf(last), changes);
        note();
    }

    void erase(std::uint32_t region, std::size_t place)
    {
        std::vector<VertexSlot>& names = order[region];
        arena.erase(slots.at(names[place]), changes);
        slots.erase(names[place]);
        names.erase(names.begin() + static_cast<std::ptrdiff_t>(place));
        note();
    }

    /// Cuts out a run of leaves, as enhMerge does, and puts one in the place of the first.
    void replaceRun(std::uint32_t region, std::size_t place, std::size_t count)
    {
        std::vector<VertexSlot>& names = order[region];
        const auto begin = names.begin() + static_cast<std::ptrdiff_t>(place);
        const std::uint32_t first = slots.at(*begin);
        for (auto name = begin; name != begin + static_cast<std::ptrdiff_t>(count); ++name)
        {
            arena.cutOut(slots.at(*name));
            slots.erase(*name);
        }
        *begin = ++last;
        names.erase(begin + 1, begin + static_cast<std::ptrdiff_t>(count));
        arena.fillGap(first, leaf(last));
        arena.closeGaps(changes);
        note();
    }

    void changeAnything(Random& random, std::uint32_t growth)
    {
        const std::uint32_t region = random.below(static_cast<std::uint32_t>(order.size()));
        const auto count = static_cast<std::uint32_t>(order[region].size());
        if (count == 0) return start(region);
        const std::uint32_t place = random.below(count);
        if (random.below(100) < growth) return split(region, place);
        if (random.below(10) == 0) return replaceRun(region, place, 1 + random.below(count - place));
        if (place + 1 < count && random.below(4) != 0) return merge(region, place);
        erase(region, place);
    }

    /// What is drawn for a region, from the graphics card's side.
    std::vector<VertexSlot> drawn(std::uint32_t region) const
    {
        std::vector<TriangleRange> ranges;
        std::vector<VertexSlot> names;
        arena.appendRanges(region, ranges);
        for (const TriangleRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                if (mirror[slot].exists()) names.push_back(mirror[slot].apex());
        return names;
    }

    bool isRight(bool isInOrder) const
    {
        std::size_t leaves = 0;
        for (std::uint32_t region = 0; region < order.size(); ++region)
        {
            std::vector<VertexSlot> names = drawn(region), expected = order[region];
            if (!isInOrder)
            {
                std::sort(names.begin(), names.end());
                std::sort(expected.begin(), expected.end());
            }
            if (names != expected) return false;
            for (const VertexSlot name : names)
                if (arena.regionOf(slots.at(name)) != region || arena.leaf(slots.at(name)) != leaf(name))
                    return false;
            leaves += names.size();
        }
        return arena.isConsistent() && arena.leafCount() == leaves;
    }

    LeafArena arena;
    std::vector<std::vector<VertexSlot>> order; ///< by region
    std::map<VertexSlot, std::uint32_t> slots;
    std::vector<TriangleId> mirror;
    MeshChanges changes;
    VertexSlot last = 0;
};

class LeafArenas : public testing::TestWithParam<LeafPlacement>
{
protected:
    static bool isInOrder() { return GetParam() == LeafPlacement::inOrder; }
};

TEST_P(LeafArenas, DrawEveryRegionsLeavesThroughRandomChanges)
{
    Keeper keeper(5, GetParam());
    Random random(11);
    std::uint32_t most = 0;
    for (int i = 0; i < 30000; ++i)
    {
        keeper.changeAnything(random, i / 3000 % 2 == 0 ? 75 : 30);
        most = std::max(most, keeper.arena.leafCount());
        ASSERT_TRUE(i % 50 != 0 || keeper.isRight(isInOrder())) << i;
    }
    EXPECT_GT(most, 500u);
}

TEST_P(LeafArenas, WhatIsGivenBackIsUsedAgain)
{
    Keeper keeper(3, GetParam());
    Random random(4);
    std::uint32_t most = 0;
    for (int round = 0; round < 20; ++round)
    {
        for (std::uint32_t region = 0; region < 3; ++region)
            if (keeper.order[region].empty()) keeper.start(region);
        while (keeper.arena.leafCount() < 900)
        {
            const std::uint32_t region = random.below(3);
            keeper.split(region, random.below(static_cast<std::uint32_t>(keeper.order[region].size())));
        }
        ASSERT_TRUE(keeper.isRight(isInOrder()));
        if (round == 0) most = keeper.arena.slotCount();
        for (std::uint32_t region = 0; region < 3; ++region)
            keeper.replaceRun(region, 0,
                              1 + random.below(static_cast<std::uint32_t>(keeper.order[region].size())));
        ASSERT_TRUE(keeper.isRight(isInOrder()));
    }
    EXPECT_LE(keeper.arena.slotCount(), 2 * most);
}

TEST_P(LeafArenas, AreHalfFullOrMore)
{
    Keeper keeper(1, GetParam());
    Random random(7);
    keeper.start(0);
    for (int i = 0; i < 20000; ++i)
        keeper.changeAnything(random, keeper.arena.leafCount() < 2000 ? 60 : 45);
    std::vector<TriangleRange> ranges;
    const std::uint32_t leaves = keeper.arena.appendRanges(0, ranges);
    std::uint32_t slots = 0;
    for (const TriangleRange& range : ranges)
        slots += range.count;
    EXPECT_LT(slots, 2 * leaves);
}

INSTANTIATE_TEST_SUITE_P(Placements, LeafArenas,
                         testing::Values(LeafPlacement::inOrder, LeafPlacement::nearby),
                         [](const auto& given)
                         { return given.param == LeafPlacement::inOrder ? "inOrder" : "nearby"; });

/// The mutation: what is put where there is room is not in order.
TEST(LeafArena, PlacementNearbyLosesTheOrder)
{
    Keeper keeper(1, LeafPlacement::nearby);
    Random random(3);
    keeper.start(0);
    while (keeper.arena.leafCount() < 200)
        keeper.split(0, random.below(static_cast<std::uint32_t>(keeper.order[0].size())));
    EXPECT_TRUE(keeper.isRight(false));
    EXPECT_FALSE(keeper.isRight(true));
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
