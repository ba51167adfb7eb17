// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/LevelMesh.h>

#include "FieldScenes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::FieldSubject;

/// Returns the faces by group, each beginning at its least corner.
std::vector<std::vector<Triangle>> sorted(std::vector<std::vector<Triangle>> groups)
{
    for (auto& group : groups)
    {
        for (Triangle& t : group)
            std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        std::sort(group.begin(), group.end());
    }
    return groups;
}

std::vector<std::vector<Triangle>> facesOfRung(const LevelLadder& ladder, std::uint32_t rung)
{
    std::vector<std::vector<Triangle>> groups(ladder.groups);
    for (std::uint32_t group = 0; group < ladder.groups; ++group)
    {
        const SlotRange range = ladder.facesOf(rung, group);
        groups[group].assign(ladder.faces.begin() + range.first,
                             ladder.faces.begin() + range.first + range.count);
    }
    return sorted(std::move(groups));
}

TEST(LevelLadder, HasTheFacesOfTheProgressiveMeshOnEveryRung)
{
    const FieldSubject subject(testsupport::together(testsupport::texturedInHalves(24, 21),
                                                     testsupport::torus(22, 18), {20.0, 0.0, 0.0}));
    const LevelLadder& ladder = subject.ladder;
    ASSERT_TRUE(isLadder(ladder));
    ASSERT_GE(ladder.rungs.size(), 8u);
    EXPECT_EQ(ladder.rungs.back().steps, subject.table.mostSteps());
    ProgressiveLevel level(subject.progressive);
    for (std::uint32_t rung = 0; rung < ladder.rungs.size(); ++rung)
    {
        level.moveTo(ladder.rungs[rung].steps);
        std::vector<std::vector<Triangle>> expected(ladder.groups);
        forEachDrawnFace(subject.progressive, level,
                         [&](const Triangle& face, std::uint32_t group) { expected[group].push_back(face); });
        EXPECT_EQ(facesOfRung(ladder, rung), sorted(std::move(expected))) << rung;
        EXPECT_EQ(ladder.rungs[rung].wedges, level.wedgeCount()) << rung;
    }
}

TEST(LevelLadder, LosesTheSameShareOfFacesFromRungToRung)
{
    const LevelLadder& ladder = FieldSubject::torus().ladder;
    for (std::size_t rung = 1; rung + 1 < ladder.rungs.size() && ladder.rungs[rung].faces > 100; ++rung)
        EXPECT_NEAR(double(ladder.rungs[rung].faces) / ladder.rungs[rung - 1].faces,
                    LevelLadder::kDefaultRatio, 0.02)
            << rung;
}

TEST(LevelLadder, DrawsALevelByTheRungThatIsNoCoarser)
{
    const LevelLadder& ladder = FieldSubject::torus().ladder;
    for (std::uint32_t rung = 0; rung < ladder.rungs.size(); ++rung)
    {
        EXPECT_EQ(ladder.rungOf(ladder.rungs[rung].steps), rung);
        const bool isNextRung =
            rung + 1 < ladder.rungs.size() && ladder.rungs[rung + 1].steps == ladder.rungs[rung].steps + 1;
        EXPECT_EQ(ladder.rungOf(ladder.rungs[rung].steps + 1), rung + isNextRung);
        if (rung > 0)
        {
            EXPECT_EQ(ladder.rungOf(ladder.rungs[rung].steps - 1), rung - 1);
        }
    }
}

TEST(LevelLadder, IsRefusedWhenAFaceUsesWhatItsRungDoesNotHaveOrOneIsMissing)
{
    LevelLadder wrong = FieldSubject::torus().ladder;
    wrong.faces.back()[1] = wrong.rungs.back().wedges;
    EXPECT_FALSE(isLadder(wrong));
    wrong = FieldSubject::torus().ladder;
    --wrong.ends.front();
    EXPECT_FALSE(isLadder(wrong));
    wrong = FieldSubject::torus().ladder;
    std::swap(wrong.rungs[1], wrong.rungs[2]);
    EXPECT_FALSE(isLadder(wrong));
}

} // namespace
