// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "DrawnFaces.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::SeenFaces;

SeenFaces drawnOf(const ProgressiveMesh& progressive, const CompactedLevel& level)
{
    SeenFaces faces;
    for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
    {
        const SlotRange range = level.rangeOf(group);
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
            testsupport::addSeen(faces, progressive.mesh, progressive.groups[group].material,
                                 level.triangle(i));
    }
    EXPECT_EQ(faces.size(), level.triangleCount());
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// Levels from one end to the other, each far from the one before.
std::vector<std::uint32_t> jumpsOver(std::uint32_t steps)
{
    std::vector<std::uint32_t> levels;
    for (std::uint32_t i = 0; i <= steps; ++i)
    {
        levels.push_back(i);
        levels.push_back(steps - i);
    }
    return levels;
}

TEST(CompactedLevel, HasTheFacesOfEveryLevelHoweverFarTheJump)
{
    for (const auto& subject : testsupport::progressiveSubjects())
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        const ProgressiveMesh progressive =
            buildProgressiveMesh(subject.mesh, sequence, testsupport::smallBlocks(Arrangement::windows));
        CompactedLevel level(progressive);
        for (const std::uint32_t steps : jumpsOver(progressive.stepCount))
        {
            level.moveTo(steps);
            ASSERT_EQ(drawnOf(progressive, level),
                      testsupport::seenOf(meshAfter(subject.mesh, sequence, steps)))
                << subject.name << ", step " << steps;
        }
    }
}

TEST(CompactedLevel, DiffersFromTheNextLevelByOneStep)
{
    const Mesh mesh = testsupport::torus(17, 9);
    const CollapseSequence sequence = simplify(mesh);
    const ProgressiveMesh progressive = buildProgressiveMesh(mesh, sequence);
    CompactedLevel level(progressive);
    for (std::uint32_t steps = 0; steps < progressive.stepCount; ++steps)
    {
        level.moveTo(steps);
        EXPECT_FALSE(drawnOf(progressive, level) ==
                     testsupport::seenOf(meshAfter(mesh, sequence, steps + 1)));
    }
}

TEST(CompactedLevel, HasWideIndicesWhereNarrowOnesDoNotReach)
{
    const Mesh mesh = testsupport::waves(260, 260); // 67 600 wedges
    CollapseSequence sequence = simplify(mesh);
    const ProgressiveMesh progressive =
        buildProgressiveMesh(mesh, sequence, {.arrangement = Arrangement::plain});
    CompactedLevel level(progressive);
    EXPECT_TRUE(level.narrowIndices().empty());
    for (const std::uint32_t steps : {0u, progressive.stepCount / 2})
    {
        level.moveTo(steps);
        EXPECT_EQ(level.wideIndices().size(), 3u * level.triangleCount());
        EXPECT_EQ(drawnOf(progressive, level), testsupport::seenOf(meshAfter(mesh, sequence, steps)));
    }
}

} // namespace
