// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/polish/PolishByImages.h>
#include <osgPMObjects/core/simplify/JoinSequences.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::meshOf;

constexpr Placement kPlacements[] = {Placement::subset, Placement::optimal, Placement::quality};

PolishSettings quick(Placement placement)
{
    return {.simplify = {.placement = placement}, .views = 4, .sizePx = 24, .moveRounds = 2};
}

CollapseSequence polished(const Mesh& mesh, std::size_t faces, const PolishSettings& settings)
{
    return polishByImages(mesh, simplify(mesh, settings.simplify), faces, {}, settings);
}

TEST(PolishByImages, GoesThroughTheLevelThatIsWantedDownToNothing)
{
    testsupport::Random random(1);
    const Mesh meshes[] = {testsupport::waves(8, 8), meshOf(testsupport::sphereMesh(8, 10)),
                           meshOf(testsupport::soup(random, 80, 30)), meshOf({{1, 1, 1}}, {}),
                           meshOf({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}})};
    for (const Mesh& mesh : meshes)
        for (const Placement placement : kPlacements)
            for (const std::size_t share : {0u, 3u, 10u})
            {
                const std::size_t faces = mesh.faces.size() * share / 10;
                const CollapseSequence sequence = polished(mesh, faces, quick(placement));
                ASSERT_TRUE(isSequenceOf(sequence, mesh));
                if (!sequence.steps.empty())
                {
                    EXPECT_EQ(sequence.steps.back().facesAfter, 0u);
                }
                const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, faces));
                EXPECT_TRUE(isValid(level));
                EXPECT_LE(level.faces.size(), faces);
            }
}

TEST(PolishByImages, ReachesTheCountOfClosedMeshesWithinTwoFaces)
{
    const Mesh mesh = meshOf(testsupport::sphereMesh(20, 30));
    for (const Placement placement : kPlacements)
    {
        const CollapseSequence sequence = polished(mesh, 100, quick(placement));
        EXPECT_NEAR(double(meshAfter(mesh, sequence, stepsToFaces(sequence, 100)).faces.size()), 100.0, 2.0);
    }
}

TEST(PolishByImages, LeavesTheLevelsBeforeAsTheyWere)
{
    const Mesh mesh = testsupport::waves(16, 16);
    const CollapseSequence sequence = simplify(mesh), after = polished(mesh, 60, quick(Placement::subset));
    const std::size_t steps = stepsToFaces(sequence, 180);
    for (std::size_t i = 0; i < steps; ++i)
        ASSERT_TRUE(after.steps[i].from == sequence.steps[i].from &&
                    after.steps[i].to == sequence.steps[i].to);
    bool isOther = after.steps.size() != sequence.steps.size();
    for (std::size_t i = steps; i < std::min(after.steps.size(), sequence.steps.size()); ++i)
        isOther = isOther || after.steps[i].from != sequence.steps[i].from;
    EXPECT_TRUE(isOther);
}

TEST(PolishByImages, LeavesOriginalVerticesWithSubsetPlacement)
{
    const Mesh mesh = testsupport::waves(16, 16);
    const CollapseSequence sequence = polished(mesh, 60, quick(Placement::subset));
    EXPECT_TRUE(sequence.places.empty() && sequence.movedWedges.empty());
}

TEST(PolishByImages, IsTheSameEveryTime)
{
    const Mesh mesh = testsupport::waves(16, 16);
    for (const Placement placement : kPlacements)
    {
        const CollapseSequence a = polished(mesh, 60, quick(placement)),
                               b = polished(mesh, 60, quick(placement));
        ASSERT_EQ(a.steps.size(), b.steps.size());
        EXPECT_EQ(a.places, b.places);
        EXPECT_EQ(a.wedges, b.wedges);
    }
}

TEST(PolishByImages, KeepsEveryMaterial)
{
    Mesh mesh = testsupport::together(testsupport::waves(16, 16), testsupport::cube(), {3.0, 3.0, -2.0});
    const CollapseSequence sequence = polished(mesh, 40, quick(Placement::subset));
    const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, 40));
    for (std::uint32_t material = 0; material < 2; ++material)
        EXPECT_TRUE(std::any_of(level.faces.begin(), level.faces.end(),
                                [&](const Face& face) { return face.material == material; }));
}

/// A sequence cut in two, its second part made again for the level between, joins to a valid one with any
/// placement.
TEST(JoinSequences, MakesOneOfTwo)
{
    const Mesh mesh = meshOf(testsupport::sphereMesh(12, 16));
    for (const Placement first : kPlacements)
        for (const Placement second : kPlacements)
        {
            const CollapseSequence whole = simplify(mesh, {.placement = first});
            for (const std::size_t steps : {std::size_t{0}, whole.steps.size() / 2, whole.steps.size()})
            {
                const CollapseSequence start = firstSteps(whole, steps);
                ASSERT_TRUE(isSequenceOf(start, mesh));
                const Mesh level = meshAfter(mesh, start, steps);
                const CollapseSequence end = simplify(level, {.placement = second});
                CollapseSequence both = joined(mesh, start, end);
                ASSERT_TRUE(isSequenceOf(both, mesh));
                const Mesh direct = meshAfter(level, end, end.steps.size() / 2),
                           through = meshAfter(mesh, both, steps + end.steps.size() / 2);
                EXPECT_EQ(through.positions, direct.positions);
                EXPECT_EQ(through.faces, direct.faces);
            }
        }
}

} // namespace
