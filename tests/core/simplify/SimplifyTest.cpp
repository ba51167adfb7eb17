// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::meshOf;

constexpr Placement kPlacements[] = {Placement::subset, Placement::optimal, Placement::quality};

Mesh levelOf(const Mesh& mesh, const CollapseSequence& sequence, std::size_t faces)
{
    return meshAfter(mesh, sequence, stepsToFaces(sequence, faces));
}

/// Returns the mean distance in per cent of the diagonal.
double meanErrorPercent(const Mesh& mesh, const Mesh& level)
{
    return 100.0 * surfaceChange(mesh, level, 20000).mean / diagonalOf(mesh);
}

std::vector<Mesh> awkwardMeshes()
{
    testsupport::Random random(1);
    Mesh fan = meshOf({{0, 0, 0}}, {});
    for (std::uint32_t i = 0; i < 3000; ++i)
    {
        fan.positions.emplace_back(std::cos(i * 0.002), std::sin(i * 0.002), 0.0);
        fan.wedgePositions.push_back(i + 1);
        if (i > 0) fan.faces.push_back({{0, i, i + 1}, 0, 0});
    }
    return {testsupport::cube(),
            testsupport::waves(20, 30),
            meshOf(testsupport::sphereMesh(20, 30)),
            meshOf(testsupport::soup(random, 2000, 200)),
            meshOf(testsupport::soup(random, 300, 900)),
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}),
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 2}}),
            meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 0, 1}}),
            meshOf({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}),
            meshOf({}, {}),
            fan};
}

TEST(Simplify, GoesDownToNothingWhateverTheMesh)
{
    for (const Mesh& mesh : awkwardMeshes())
        for (const Placement placement : kPlacements)
        {
            const CollapseSequence sequence = simplify(mesh, {.placement = placement});
            EXPECT_TRUE(isSequenceOf(sequence, mesh));
            if (!sequence.steps.empty())
            {
                EXPECT_EQ(sequence.steps.back().facesAfter, 0u);
            }
            EXPECT_TRUE(isValid(levelOf(mesh, sequence, mesh.faces.size() / 2)));
        }
}

TEST(Simplify, GoesDownToNothingByAccumulatedQuadrics)
{
    for (const Mesh& mesh : awkwardMeshes())
        for (const Placement placement : kPlacements)
        {
            const CollapseSequence sequence =
                simplify(mesh, {.placement = placement, .quadrics = Quadrics::accumulated});
            EXPECT_TRUE(isSequenceOf(sequence, mesh));
            if (!sequence.steps.empty())
            {
                EXPECT_EQ(sequence.steps.back().facesAfter, 0u);
            }
            EXPECT_TRUE(isValid(levelOf(mesh, sequence, mesh.faces.size() / 2)));
        }
}

/// The two ways give other levels, and neither is far better.
TEST(Simplify, ByAccumulatedQuadricsIsAboutAsNearOnASmoothBody)
{
    const Mesh mesh = meshOf(testsupport::sphereMesh(40, 60));
    for (const Placement placement : kPlacements)
    {
        const auto error = [&](Quadrics quadrics)
        {
            return meanErrorPercent(
                mesh, levelOf(mesh, simplify(mesh, {.placement = placement, .quadrics = quadrics}), 300));
        };
        const double memoryless = error(Quadrics::memoryless), accumulated = error(Quadrics::accumulated);
        EXPECT_NE(accumulated, memoryless); // the mutation: the setting does nothing
        EXPECT_LT(accumulated, 1.5 * memoryless);
        EXPECT_GT(accumulated, 0.67 * memoryless);
    }
}

TEST(Simplify, ReachesEveryCountOfClosedMeshesWithinFourFaces)
{
    const Mesh mesh = meshOf(testsupport::sphereMesh(40, 60));
    for (const Placement placement : kPlacements)
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        for (std::size_t faces = mesh.faces.size(); faces >= 8; faces -= 7)
            EXPECT_NEAR(double(levelOf(mesh, sequence, faces).faces.size()), double(faces), 4.0);
    }
}

TEST(Simplify, TakesFromAPlaneAllButItsCorners)
{
    const Mesh mesh = testsupport::grid(17, 23);
    for (const Placement placement : kPlacements)
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        const std::size_t steps = stepsToFaces(sequence, 2);
        EXPECT_LT(sequence.steps[steps - 1].error.distance, 1e-6 * diagonalOf(mesh));
        EXPECT_LT(surfaceChange(mesh, meshAfter(mesh, sequence, steps), 1000).largest,
                  1e-6 * diagonalOf(mesh));
    }
}

TEST(Simplify, LeavesOriginalVerticesWithSubsetPlacement)
{
    const Mesh mesh = testsupport::waves(20, 20);
    const Mesh level = levelOf(mesh, simplify(mesh), 100);
    for (const glm::dvec3& p : level.positions)
        EXPECT_NE(std::find(mesh.positions.begin(), mesh.positions.end(), p), mesh.positions.end());
}

TEST(Simplify, IsNearerWithPlacesThanWithVerticesOnly)
{
    const Mesh mesh = meshOf(testsupport::sphereMesh(40, 60));
    const auto error = [&](Placement placement)
    { return meanErrorPercent(mesh, levelOf(mesh, simplify(mesh, {.placement = placement}), 300)); };
    const double subset = error(Placement::subset);
    EXPECT_LT(error(Placement::optimal), 0.7 * subset);
    EXPECT_LT(error(Placement::quality), 0.7 * subset);
}

TEST(Simplify, StaysInTheBox)
{
    const Mesh mesh = testsupport::waves(30, 30);
    const Extent box = extentOf(mesh.positions);
    for (const Placement placement : kPlacements)
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        for (const std::size_t faces : {900u, 300u, 30u, 4u})
            EXPECT_TRUE(box.contains(extentOf(levelOf(mesh, sequence, faces).positions)));
    }
}

TEST(Simplify, KeepsAThinPlateThatIsFoldedOntoItself)
{ // its two sides coincide: without the weight of folds its outline would shrink at no cost
    Mesh mesh = testsupport::grid(10, 10);
    const std::vector<Face> front = mesh.faces;
    for (const Face& f : front)
        mesh.faces.push_back({{f.wedges[0], f.wedges[2], f.wedges[1]}, 0, 0});
    const Mesh level = levelOf(mesh, simplify(mesh), 8);
    EXPECT_LT(surfaceChange(mesh, level, 1000).largest, 1e-6);
}

TEST(Simplify, LetsSmallPartsVanishBeforeLargeOnesSuffer)
{
    Mesh mesh = meshOf(testsupport::sphereMesh(20, 30));
    Mesh crumb = testsupport::cube();
    for (glm::dvec3& p : crumb.positions)
        p *= 0.002;
    for (int i = 0; i < 40; ++i)
        mesh = testsupport::together(mesh, crumb, {0.6 * std::cos(i), 0.6 * std::sin(i), 0.9});
    const CollapseSequence sequence = simplify(mesh, {.keepSeams = false});
    const Mesh level = levelOf(mesh, sequence, 400);
    EXPECT_EQ(countMesh(level).components, 1u);
    EXPECT_LT(meanErrorPercent(meshOf(testsupport::sphereMesh(20, 30)), level), 0.5);
}

TEST(Simplify, KeepsPartsThatAreFarFromOthersAsLongAsItCan)
{
    Mesh mesh = meshOf(testsupport::sphereMesh(20, 30));
    mesh = testsupport::together(mesh, mesh, {5, 0, 0});
    EXPECT_EQ(countMesh(levelOf(mesh, simplify(mesh), 60)).components, 2u);
}

TEST(Simplify, DoesTheSameEveryTime)
{
    Mesh mesh = testsupport::waves(25, 25);
    for (int i = 0; i < 5; ++i)
        mesh = testsupport::together(mesh, testsupport::cube(), {i * 2.0, 3.0, 4.0});
    const CollapseSequence once = simplify(mesh), again = simplify(mesh);
    ASSERT_EQ(once.steps.size(), again.steps.size());
    for (std::size_t i = 0; i < once.steps.size(); ++i)
        EXPECT_TRUE(once.steps[i].from == again.steps[i].from && once.steps[i].to == again.steps[i].to);
}

} // namespace
