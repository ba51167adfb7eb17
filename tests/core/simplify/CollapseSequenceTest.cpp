// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::meshOf;

/// Two triangles beside the edge 0–1; 3 merges into 1.
CollapseSequence oneStep()
{
    CollapseSequence sequence;
    sequence.facesBefore = 2;
    CollapseStep step;
    step.from = 3;
    step.to = 1;
    step.facesAfter = 1;
    step.error.distance = 0.5f;
    sequence.steps = {step};
    sequence.wedges = {{3, 1}};
    return sequence;
}

Mesh twoTriangles()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -1, 0}}, {{0, 1, 2}, {0, 3, 1}});
}

TEST(CollapseSequence, TakesTheFacesBesideTheEdge)
{
    const Mesh mesh = twoTriangles();
    const CollapseSequence sequence = oneStep();
    ASSERT_TRUE(isSequenceOf(sequence, mesh));
    EXPECT_EQ(meshAfter(mesh, sequence, 0).faces.size(), 2u);
    const Mesh level = meshAfter(mesh, sequence, 1);
    ASSERT_EQ(level.faces.size(), 1u);
    EXPECT_EQ(level.positions.size(), 3u);
    EXPECT_TRUE(isValid(level));
}

TEST(CollapseSequence, FindsTheLevelByFacesAndByDistance)
{
    const CollapseSequence sequence = oneStep();
    EXPECT_EQ(stepsToFaces(sequence, 2), 0u);
    EXPECT_EQ(stepsToFaces(sequence, 1), 1u);
    EXPECT_EQ(stepsToFaces(sequence, 0), 1u); // the fewest there are
    EXPECT_EQ(stepsToDistance(sequence, 0.4), 0u);
    EXPECT_EQ(stepsToDistance(sequence, 0.5), 1u);
}

TEST(CollapseSequence, DoesNotStopBetweenTwins)
{
    CollapseSequence sequence = oneStep();
    sequence.facesBefore = 60;
    sequence.steps[0].facesAfter = 58;
    sequence.steps.push_back(sequence.steps[0]);
    sequence.steps[1].facesAfter = 56;
    sequence.steps[0].goesOn = true;
    EXPECT_EQ(stepsToFaces(sequence, 58), 2u);
    sequence.steps[1].facesAfter = 50;
    EXPECT_EQ(stepsToFaces(sequence, 58), 1u);
    sequence.steps[1].facesAfter = 56;
    sequence.steps[1].error.distance = 0.6f;
    EXPECT_EQ(stepsToDistance(sequence, 0.55), 0u);
    sequence.steps[0].goesOn = false;
    EXPECT_EQ(stepsToFaces(sequence, 58), 1u);
    EXPECT_EQ(stepsToDistance(sequence, 0.55), 1u);
}

/// Mutations: each makes a valid sequence invalid.
TEST(CollapseSequence, IsRefusedWhenItCannotBePlayed)
{
    const Mesh mesh = testsupport::waves(6, 6);
    const CollapseSequence sound = simplify(mesh);
    ASSERT_TRUE(isSequenceOf(sound, mesh));
    const auto isSoundAfter = [&](const auto& change)
    {
        CollapseSequence sequence = sound;
        change(sequence);
        return isSequenceOf(sequence, mesh);
    };
    EXPECT_TRUE(isSoundAfter([](CollapseSequence&) {}));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { ++s.facesBefore; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps[3].from = s.steps[2].from; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps[3].to = s.steps[2].from; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps[3].from = 49; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps[5].facesAfter += 1; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps.back().error.distance = 0.0f; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps.back().error.texCoord = -1.0f; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.wedges[4].to = s.wedges[4].from; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.wedges[4].to = 1000; }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.places.resize(1); }));
    EXPECT_FALSE(isSoundAfter([](CollapseSequence& s) { s.steps[7].firstWedge = 1; }));
}

/// Two faces beside an edge share the wedge at the removed end, but not at the other one: of the two wedges
/// at the remaining position, only the used one is replaced.
TEST(CollapseSequence, KeepsVanishedFacesAwayWhateverTheirWedges)
{
    testsupport::Random random(7);
    Mesh mesh = meshOf(testsupport::sphereMesh(12, 16));
    for (Face& face : mesh.faces)
        for (std::uint32_t& wedge : face.wedges)
            if (random.below(2) == 0) wedge = appendWedge(mesh, {.position = mesh.wedgePositions[wedge]});
    for (const Placement placement : {Placement::subset, Placement::optimal})
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        EXPECT_TRUE(isSequenceOf(sequence, mesh));
        for (std::size_t steps = 1; steps <= sequence.steps.size(); ++steps)
            ASSERT_EQ(meshAfter(mesh, sequence, steps).faces.size(), sequence.steps[steps - 1].facesAfter);
    }
}

} // namespace
