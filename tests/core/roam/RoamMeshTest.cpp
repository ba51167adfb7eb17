// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "SyntheticField.h"
#include "flights/AnchorFlight.h"

namespace
{

using namespace osgTerrainROAM::core;
using flights::AnchorFlight;

std::shared_ptr<const RoamTile> flightTile()
{
    static const auto tile = testsupport::planarTile(testsupport::hills(257, 257, 90.0));
    return tile;
}

std::set<SampleTriangle> leavesOf(const RoamMesh& mesh)
{
    std::set<SampleTriangle> leaves;
    std::vector<TriangleRange> ranges;
    mesh.visibleRanges(viewlod::Frustum(glm::dmat4(0.0)), ranges);
    for (const auto& t : gathered(mesh.triangles(), ranges))
        leaves.insert({mesh.tree().sampleOf(t.vertices[0]), mesh.tree().sampleOf(t.vertices[1]),
                       mesh.tree().sampleOf(t.vertices[2])});
    return leaves;
}

std::set<SampleTriangle> meshFromScratch(const viewlod::ViewState& view, double tolerancePx)
{
    std::vector<SampleTriangle> leaves;
    refineFromScratch(*flightTile(), view, tolerancePx, leaves);
    return {leaves.begin(), leaves.end()};
}

std::uint64_t hashOf(const std::set<SampleTriangle>& leaves)
{
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const SampleTriangle& corners : leaves)
        for (const SampleIndex s : corners)
            hash = (hash ^ s) * 0x100000001b3ull;
    return hash;
}

TEST(RoamMesh, FollowsAFlightToTheMeshThatStartsFromScratch)
{
    RoamMesh mesh(flightTile());
    for (int frame = 0; frame < AnchorFlight::kFrames; frame += 7)
    {
        const auto view = AnchorFlight{}.view(flightTile()->tile, frame);
        const double tolerancePx = frame % 3 + 1.5;
        const RefineResult result = mesh.refine(view, {.errorTolerancePx = tolerancePx});
        ASSERT_EQ(leavesOf(mesh), meshFromScratch(view, tolerancePx)) << frame;
        EXPECT_EQ(result.triangles, mesh.tree().leaves().leafCount());
    }
    EXPECT_TRUE(mesh.isConforming());
}

TEST(RoamMesh, GivesTheSameMeshWhateverCameBefore)
{
    RoamMesh travelled(flightTile()), fresh(flightTile());
    for (int frame = 0; frame <= 200; frame += 10)
        travelled.refine(AnchorFlight{}.view(flightTile()->tile, frame), {});
    fresh.refine(AnchorFlight{}.view(flightTile()->tile, 200), {});
    EXPECT_EQ(leavesOf(travelled), leavesOf(fresh));
    const auto again = travelled.refine(AnchorFlight{}.view(flightTile()->tile, 200), {});
    EXPECT_EQ(again.splits + again.merges, 0u);
    EXPECT_TRUE(travelled.changes().triangles.empty());
}

TEST(RoamMesh, NoVisibleSampleIsOffByMoreThanTheTolerance)
{
    RoamMesh mesh(flightTile());
    double worst = 0.0;
    for (int frame = 0; frame < AnchorFlight::kFrames; frame += 20)
    {
        const auto view = AnchorFlight{}.view(flightTile()->tile, frame);
        mesh.refine(view, {.errorTolerancePx = 3.0});
        std::vector<TriangleRange> ranges;
        mesh.visibleRanges(viewlod::Frustum(glm::dmat4(0.0)), ranges);
        const auto report =
            checkDrawnMesh(*flightTile(), mesh.vertices(), gathered(mesh.triangles(), ranges), &view);
        EXPECT_EQ(report.tJunctions + report.cracks, 0u);
        EXPECT_LE(report.maxErrorPx, 3.0);
        worst = std::max(worst, report.maxErrorPx);
    }
    EXPECT_GT(worst, 1.0); // a check that always sees 0 would pass, too

    // The mutation: a mesh made for twice the tolerance breaks the bound.
    const auto view = AnchorFlight{}.view(flightTile()->tile, 0);
    mesh.refine(view, {.errorTolerancePx = 12.0});
    std::vector<TriangleRange> ranges;
    mesh.visibleRanges(viewlod::Frustum(glm::dmat4(0.0)), ranges);
    EXPECT_GT(
        checkDrawnMesh(*flightTile(), mesh.vertices(), gathered(mesh.triangles(), ranges), &view).maxErrorPx,
        3.0);
}

TEST(RoamMesh, CeilingIsNeverExceededAndRaisesTheToleranceForTheWholeFrame)
{
    RoamMesh mesh(flightTile());
    for (const std::uint32_t ceiling : {2u, 3u, 100u, 1000u, 5000u})
        for (int frame = 0; frame < AnchorFlight::kFrames; frame += 30)
        {
            const auto view = AnchorFlight{}.view(flightTile()->tile, frame);
            const RefineResult result = mesh.refine(view, {.errorTolerancePx = 0.5, .maxTriangles = ceiling});
            ASSERT_LE(result.leaves, ceiling);
            ASSERT_TRUE(result.ceilingBound);
            ASSERT_GT(result.tolerancePx, 0.5);
            ASSERT_EQ(leavesOf(mesh), meshFromScratch(view, result.tolerancePx));
            EXPECT_GE(result.leaves,
                      ceiling < 1000 ? 2 : ceiling * 98 / 100); // detail is used where it may be
        }
    EXPECT_TRUE(mesh.isConforming());
}

TEST(RoamMesh, CeilingThatDoesNotBindChangesNothing)
{
    RoamMesh limited(flightTile()), free(flightTile());
    const auto view = AnchorFlight{}.view(flightTile()->tile, 50);
    const auto wanted = free.refine(view, {});
    const auto result = limited.refine(view, {.errorTolerancePx = 1.0, .maxTriangles = wanted.leaves});
    EXPECT_FALSE(result.ceilingBound);
    EXPECT_EQ(leavesOf(limited), leavesOf(free));
}

TEST(RoamMesh, RecordedFlightHasItsGoldenHash)
{
    const auto flown = [](double aboveGroundM)
    {
        RoamMesh mesh(flightTile());
        std::uint64_t hash = 0;
        for (int frame = 0; frame < AnchorFlight::kFrames; frame += 4)
        {
            mesh.refine(AnchorFlight{.aboveGroundM = aboveGroundM}.view(flightTile()->tile, frame),
                        {.errorTolerancePx = 2.0});
            hash = hash * 31 + hashOf(leavesOf(mesh));
        }
        return hash;
    };
    constexpr std::uint64_t kGolden = 0x94359f0ff5f98efeull;
    EXPECT_EQ(flown(300.0), kGolden) << std::hex << flown(300.0);
    EXPECT_NE(flown(300.5), kGolden); // half a metre higher is another flight
}

TEST(RoamMesh, ViewIndependentRefinementGoesBothWays)
{
    RoamMesh mesh(flightTile());
    const auto fine = mesh.refine(2.0).triangles;
    const auto coarse = mesh.refine(60.0).triangles;
    EXPECT_LT(coarse, fine);
    EXPECT_TRUE(mesh.isConforming());
    EXPECT_EQ(mesh.refine(2.0).triangles, fine);
    EXPECT_EQ(mesh.refine(-1.0).triangles, 2u * 256 * 256); // every error exceeds it
}

} // namespace
