// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "DrawnFaces.h"

namespace
{

using namespace osgPMObjects::core;

std::vector<std::uint32_t> indicesOf(const ProgressiveLevel& level)
{
    if (!level.hasNarrowIndices()) return {level.wideIndices().begin(), level.wideIndices().end()};
    return {level.narrowIndices().begin(), level.narrowIndices().end()};
}

/// Returns the drawn faces without holes, and counts the holes.
testsupport::SeenFaces drawnOf(const ProgressiveMesh& progressive, const ProgressiveLevel& level,
                               std::size_t& holes)
{
    testsupport::SeenFaces faces;
    holes = 0;
    const std::vector<std::uint32_t> indices = indicesOf(level);
    for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
    {
        std::vector<SlotRange> ranges;
        level.appendRanges(group, ranges);
        for (const SlotRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            {
                const std::uint32_t* const at = &indices[3 * std::size_t{slot}];
                EXPECT_LT(std::max({at[0], at[1], at[2]}), level.wedgeCount());
                if (at[0] == at[1])
                    ++holes;
                else
                    testsupport::addSeen(faces, progressive.mesh, progressive.groups[group].material,
                                         {at[0], at[1], at[2]});
            }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

constexpr std::array kArrangements{Arrangement::plain, Arrangement::tswap, Arrangement::blocks,
                                   Arrangement::windows};

TEST(ProgressiveLevel, DrawsTheFacesOfEveryLevelWhateverTheirOrder)
{
    for (const auto& subject : testsupport::progressiveSubjects())
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const Arrangement arrangement : kArrangements)
        {
            const ProgressiveMesh progressive =
                buildProgressiveMesh(subject.mesh, sequence, testsupport::smallBlocks(arrangement));
            ASSERT_EQ(progressive.stepCount, sequence.steps.size()) << subject.name;
            ASSERT_TRUE(isValid(progressive)) << subject.name;
            ProgressiveLevel level(progressive);
            std::size_t mostHoles = 0;
            for (std::uint32_t steps = 0; steps <= progressive.stepCount; ++steps)
            {
                level.moveTo(steps);
                std::size_t holes = 0;
                const testsupport::SeenFaces drawn = drawnOf(progressive, level, holes);
                mostHoles = std::max(mostHoles, holes);
                ASSERT_EQ(drawn.size(), level.faceCount());
                ASSERT_EQ(drawn, testsupport::seenOf(meshAfter(subject.mesh, sequence, steps)))
                    << subject.name << ", arrangement " << static_cast<int>(arrangement) << ", step "
                    << steps;
            }
            EXPECT_EQ(mostHoles > 0, arrangement == Arrangement::windows || arrangement == Arrangement::tswap)
                << subject.name;
        }
    }
}

TEST(ProgressiveLevel, GoesUpThroughTheVeryBuffersThatItWentDown)
{
    for (const auto& subject : testsupport::progressiveSubjects())
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const Arrangement arrangement : kArrangements)
        {
            const ProgressiveMesh progressive =
                buildProgressiveMesh(subject.mesh, sequence, testsupport::smallBlocks(arrangement));
            ProgressiveLevel level(progressive);
            std::vector<std::vector<std::uint32_t>> down;
            for (std::uint32_t steps = 0; steps <= progressive.stepCount; ++steps)
            {
                level.moveTo(steps);
                down.push_back(indicesOf(level));
            }
            for (std::uint32_t steps = progressive.stepCount + 1; steps-- > 0;)
            {
                level.moveTo(steps);
                ASSERT_EQ(indicesOf(level), down[steps])
                    << subject.name << ", arrangement " << static_cast<int>(arrangement) << ", step "
                    << steps;
            }
        }
    }
}

/// Returns how many holes of a buffer do not hold the last index of the slot before them, or 0 behind an
/// unused slot.
std::size_t wrongHoles(const ProgressiveMesh& progressive, const ProgressiveLevel& level,
                       const std::vector<std::uint32_t>& indices)
{
    std::vector<bool> isDrawn(progressive.slotCount, false);
    for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
    {
        std::vector<SlotRange> ranges;
        level.appendRanges(group, ranges);
        for (const SlotRange& range : ranges)
            std::fill_n(isDrawn.begin() + range.first, range.count, true);
    }
    std::size_t wrong = 0;
    for (std::uint32_t slot = 0; slot < progressive.slotCount; ++slot)
    {
        const std::uint32_t* const at = &indices[3 * std::size_t{slot}];
        if (!isDrawn[slot] || at[0] != at[1]) continue;
        const std::uint32_t expected = slot > 0 && isDrawn[slot - 1] ? at[-1] : 0;
        wrong += at[0] != expected || at[2] != expected;
    }
    return wrong;
}

TEST(ProgressiveLevel, HolesRepeatTheLastIndexBeforeThem)
{
    for (const auto& subject : testsupport::progressiveSubjects())
        for (const Arrangement arrangement : {Arrangement::windows, Arrangement::tswap})
        {
            const ProgressiveMesh progressive = buildProgressiveMesh(subject.mesh, simplify(subject.mesh),
                                                                     testsupport::smallBlocks(arrangement));
            ProgressiveLevel level(progressive);
            std::size_t told = 0;
            for (std::uint32_t i = 0; i <= 2 * progressive.stepCount; ++i)
            {
                level.moveTo(i <= progressive.stepCount ? i : 2 * progressive.stepCount - i);
                std::vector<std::uint32_t> indices = indicesOf(level);
                ASSERT_EQ(wrongHoles(progressive, level, indices), 0u) << subject.name << ", move " << i;
                for (std::size_t first = 0; first < indices.size();
                     first += 3) // the control: other last indices
                    if (indices[first] != indices[first + 1]) ++indices[first + 2];
                told += wrongHoles(progressive, level, indices) > 0;
            }
            EXPECT_GT(told, progressive.stepCount / 2) << subject.name;
        }
}

TEST(ProgressiveLevel, ReachesTheSameBuffersInMovesOfAnyLength)
{
    // Large enough for more changed slots in one move than the few hundred after which holes are brought up
    // to date.
    const Mesh mesh =
        testsupport::together(testsupport::waves(40, 30), testsupport::torus(24, 16), {20, 0, 0});
    const CollapseSequence sequence = simplify(mesh);
    for (const Arrangement arrangement : kArrangements)
    {
        const ProgressiveMesh progressive =
            buildProgressiveMesh(mesh, sequence, testsupport::smallBlocks(arrangement));
        ProgressiveLevel single(progressive);
        std::vector<std::vector<std::uint32_t>> buffers;
        for (std::uint32_t steps = 0; steps <= progressive.stepCount; ++steps)
        {
            single.moveTo(steps);
            buffers.push_back(indicesOf(single));
        }
        ProgressiveLevel level(progressive);
        for (const std::uint32_t length : {2u, 7u, 60u, 500u, progressive.stepCount})
            for (std::uint32_t i = 0; i < 2 * progressive.stepCount + length; i += length)
            {
                const std::uint32_t steps = i <= progressive.stepCount      ? i
                                            : i < 2 * progressive.stepCount ? 2 * progressive.stepCount - i
                                                                            : 0;
                level.moveTo(steps);
                ASSERT_EQ(indicesOf(level), buffers[steps]) << "arrangement " << static_cast<int>(arrangement)
                                                            << ", " << length << " steps to " << steps;
            }
        EXPECT_NE(buffers.front(), buffers[progressive.stepCount / 2]); // the control: levels differ
    }
}

} // namespace
