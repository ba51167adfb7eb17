// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/LeafArena.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

TEST(LeafArena, KeepsEveryRegionsLeavesTogetherThroughRandomChanges)
{
    LeafArena arena(5);
    MeshChanges changes;
    testsupport::Random random(11);
    std::map<NodeIndex, std::uint32_t> regionOf;
    for (int i = 0; i < 20000; ++i)
    {
        const NodeIndex node = random.below(700);
        if (const auto known = regionOf.find(node); known != regionOf.end())
        {
            arena.erase(node, known->second, changes);
            regionOf.erase(known);
        }
        else
        {
            const std::uint32_t region = random.below(5);
            arena.insert(node, region, {{node, node + 1, node + 2}}, changes);
            regionOf[node] = region;
        }
        ASSERT_TRUE(i % 100 != 0 || arena.isConsistent());
    }
    std::map<NodeIndex, std::uint32_t> seen;
    for (std::uint32_t region = 0; region < arena.regionCount(); ++region)
    {
        const TriangleRange range = arena.region(region);
        for (std::uint32_t i = 0; i < range.count; ++i)
            seen[arena.triangles()[range.first + i].vertices[0]] = region;
    }
    EXPECT_EQ(seen, regionOf);
    EXPECT_EQ(arena.leafCount(), regionOf.size());
}

TEST(LeafArena, ReportsEverySlotItWrites)
{
    LeafArena arena(3);
    testsupport::Random random(5);
    std::vector<LeafTriangle> mirror; // what a graphics card would hold that was sent the changes alone
    std::map<NodeIndex, std::uint32_t> regionOf;
    for (int frame = 0; frame < 300; ++frame)
    {
        MeshChanges changes;
        for (int i = 0; i < 25; ++i)
        {
            const NodeIndex node = random.below(400);
            if (const auto known = regionOf.find(node); known != regionOf.end())
            {
                arena.erase(node, known->second, changes);
                regionOf.erase(known);
            }
            else
            {
                arena.insert(node, regionOf[node] = node % 3, {{node, node, node}}, changes);
            }
        }
        mirror.resize(arena.triangles().size());
        for (const std::uint32_t slot : changes.triangles)
            mirror[slot] = arena.triangles()[slot];
        for (std::uint32_t region = 0; region < 3; ++region)
            for (std::uint32_t i = 0; i < arena.region(region).count; ++i)
            {
                const std::uint32_t slot = arena.region(region).first + i;
                ASSERT_EQ(mirror[slot].vertices[0], arena.triangles()[slot].vertices[0]);
            }
    }
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
