// SPDX-License-Identifier: Apache-2.0
// Foliage of cards: remaining cards grow as others are removed.
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "Foliage.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::crown;
using testsupport::LeafKind;

constexpr Placement kLeafPlacements[] = {Placement::subset, Placement::optimal, Placement::quality};

Mesh levelOfShare(const Mesh& mesh, const CollapseSequence& sequence, double share)
{
    return meshAfter(mesh, sequence, stepsToFaces(sequence, std::size_t(share * double(mesh.faces.size()))));
}

bool isSame(const CollapseSequence& a, const CollapseSequence& b)
{
    const auto sameStep = [](const CollapseStep& x, const CollapseStep& y)
    {
        return x.from == y.from && x.to == y.to && x.facesAfter == y.facesAfter && x.goesOn == y.goesOn &&
               x.firstWedge == y.firstWedge && x.firstMoved == y.firstMoved && x.error == y.error;
    };
    return std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(), sameStep) &&
           a.wedges == b.wedges && a.places == b.places && a.movedWedges.size() == b.movedWedges.size();
}

bool staysAsItWas(const Mesh& mesh, Placement placement)
{
    return isSame(simplify(mesh, {.placement = placement}),
                  simplify(mesh, {.placement = placement, .growLeaves = false}));
}

TEST(LeafCollapse, CoversAtATwentiethWhatThinnedFoliageDoesNot)
{
    const Mesh mesh = crown(LeafKind::quad, 3000, 0.1);
    const Extent box = extentOf(mesh.positions);
    const int full = testsupport::cover(mesh, box);
    for (const Placement placement : kLeafPlacements)
    {
        const Mesh grown = levelOfShare(mesh, simplify(mesh, {.placement = placement}), 0.05);
        const Mesh thin =
            levelOfShare(mesh, simplify(mesh, {.placement = placement, .growLeaves = false}), 0.05);
        const double most = testsupport::cover(grown, box), least = testsupport::cover(thin, box);
        EXPECT_GT(most, 0.55 * full);
        EXPECT_LT(most, 1.1 * full); // nor more than there was
        EXPECT_LT(least, 0.45 * full);
    }
}

TEST(LeafCollapse, MakesSoundSequencesOfAllKindsOfLeaves)
{
    for (const LeafKind kind : {LeafKind::triangle, LeafKind::quad, LeafKind::doubled})
        for (const Placement placement : kLeafPlacements)
        {
            const Mesh mesh = crown(kind, 300, 0.2);
            const CollapseSequence sequence = simplify(mesh, {.placement = placement});
            EXPECT_TRUE(isSequenceOf(sequence, mesh));
            EXPECT_EQ(sequence.steps.back().facesAfter, 0u);
            EXPECT_FALSE(staysAsItWas(mesh, placement));
        }
}

TEST(LeafCollapse, ReachesCountsWithinItsBox)
{
    const Mesh mesh = crown(LeafKind::quad, 3000, 0.1);
    const Extent box = extentOf(mesh.positions);
    for (const Placement placement : kLeafPlacements)
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        for (const double share : {0.5, 0.25, 0.1, 0.05, 0.01})
        {
            const Mesh level = levelOfShare(mesh, sequence, share);
            const double wanted = share * double(mesh.faces.size());
            EXPECT_NEAR(double(level.faces.size()), wanted, std::max(0.01 * wanted, 4.0));
            EXPECT_TRUE(box.contains(extentOf(level.positions)));
        }
    }
}

TEST(LeafCollapse, ShowsWholeLeavesOnly)
{
    const Mesh mesh = crown(LeafKind::quad, 1000, 0.1);
    for (const Placement placement : kLeafPlacements)
    {
        const Mesh level = levelOfShare(mesh, simplify(mesh, {.placement = placement}), 0.05);
        for (const Face& face : level.faces)
        {
            double cut[2];
            for (int axis = 0; axis < 2; ++axis)
            {
                const auto at = [&](int c) { return level.texCoords[0][face.wedges[c]][axis]; };
                cut[axis] = std::max({at(0), at(1), at(2)}) - std::min({at(0), at(1), at(2)});
            }
            EXPECT_TRUE(cut[0] == 1.0 && cut[1] == 1.0);
        }
    }
}

TEST(LeafCollapse, IsSoundBetweenItsStepsAndDoesNotStopThere)
{
    const Mesh mesh = crown(LeafKind::quad, 400, 0.2);
    for (const Placement placement : kLeafPlacements)
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        std::size_t between = 0;
        for (std::size_t step = 0; step < sequence.steps.size(); step += 7)
        {
            between += sequence.steps[step].goesOn;
            EXPECT_TRUE(isValid(meshAfter(mesh, sequence, step + 1)));
        }
        EXPECT_GT(between, 20u);
        for (std::size_t faces = 40; faces < mesh.faces.size(); faces += 13)
            EXPECT_FALSE(sequence.steps[stepsToFaces(sequence, faces) - 1].goesOn);
    }
}

TEST(LeafCollapse, LeavesMeshesWithoutFoliageAsTheyWere)
{
    Mesh cubes = testsupport::waves(12, 12);
    for (int i = 0; i < 90; ++i)
        cubes = testsupport::together(cubes, testsupport::cube(), {i % 9 * 2.0, i / 9 * 2.0, 4.0});
    Mesh tiles = crown(LeafKind::quad, 300, 0.1); // all have the same direction: a wall
    for (glm::dvec3& p : tiles.positions)
        p.z = 0.01 * p.z;
    Mesh uneven = crown(LeafKind::quad, 300, 0.1);
    for (std::size_t i = 0; i < uneven.texCoords[0].size();
         ++i) // no two show the same region: debris, not leaves
        uneven.texCoords[0][i] += glm::vec2(float(i / 4) * 0.01f);
    for (const Mesh& mesh : {cubes, tiles, uneven, crown(LeafKind::quad, 40, 0.1)})
        for (const Placement placement : kLeafPlacements)
            EXPECT_TRUE(staysAsItWas(mesh, placement));
    EXPECT_FALSE(staysAsItWas(crown(LeafKind::quad, 300, 0.1), Placement::subset));
}

} // namespace
