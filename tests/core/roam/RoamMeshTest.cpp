// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <set>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "SyntheticField.h"
#include "TreeWalks.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace
{

using namespace osgTerrainROAM::core;
namespace core = osgTerrainROAM::core;
using measurement::BenchmarkFlight;

std::shared_ptr<const RoamTile> flightTile()
{
    static const auto tile = testsupport::planarTile(testsupport::hills(257, 257, 90.0));
    return tile;
}

using testsupport::CornerIndices;
using testsupport::leafSet;

std::vector<CornerIndices> meshFromScratch(const viewlod::ViewState& view, double tolerancePx)
{
    std::vector<GridTriangle> leaves;
    refineFromScratch(flightTile(), view, tolerancePx, leaves);
    return leafSet(leaves);
}

/// Of the corners' linear indices, in their order.
std::uint64_t hashOf(const std::vector<CornerIndices>& leaves)
{
    std::set<std::array<int, 3>> samples;
    for (const CornerIndices& c : leaves)
        samples.insert({c[1] * 257 + c[0], c[3] * 257 + c[2], c[5] * 257 + c[4]});
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const auto& corners : samples)
        for (const int s : corners)
            hash = (hash ^ static_cast<std::uint64_t>(s)) * 0x100000001b3ull;
    return hash;
}

class RoamMeshTest : public testing::TestWithParam<Driver>
{
};

TEST_P(RoamMeshTest, FollowsAFlightToTheMeshThatStartsFromScratch)
{
    core::RoamMesh mesh(flightTile(), GetParam());
    for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += 7)
    {
        const auto view = BenchmarkFlight{}.view(flightTile()->tile, frame);
        const double tolerancePx = frame % 3 + 1.5;
        const RefineResult result = mesh.refine(view, {.errorTolerancePx = tolerancePx});
        ASSERT_EQ(leafSet(mesh.tree()), meshFromScratch(view, tolerancePx)) << frame;
        EXPECT_EQ(result.triangles, mesh.tree().leaves().leafCount());
    }
    EXPECT_TRUE(mesh.isConforming());
}

TEST_P(RoamMeshTest, GivesTheSameMeshWhateverCameBefore)
{
    core::RoamMesh travelled(flightTile(), GetParam()), fresh(flightTile(), GetParam());
    for (int frame = 0; frame <= 200; frame += 10)
        travelled.refine(BenchmarkFlight{}.view(flightTile()->tile, frame), {});
    fresh.refine(BenchmarkFlight{}.view(flightTile()->tile, 200), {});
    EXPECT_EQ(leafSet(travelled.tree()), leafSet(fresh.tree()));
    const auto again = travelled.refine(BenchmarkFlight{}.view(flightTile()->tile, 200), {});
    EXPECT_EQ(again.splits + again.merges, 0u);
    EXPECT_TRUE(travelled.changes().triangles.empty());
}

TEST_P(RoamMeshTest, NoVisibleSampleIsOffByMoreThanTheTolerance)
{
    core::RoamMesh mesh(flightTile(), GetParam());
    double worst = 0.0;
    for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += 20)
    {
        const auto view = BenchmarkFlight{}.view(flightTile()->tile, frame);
        mesh.refine(view, {.errorTolerancePx = 3.0});
        const auto report = checkDrawnMesh(*flightTile(), mesh.drawn(), &view);
        EXPECT_EQ(report.tJunctions + report.cracks, 0u);
        EXPECT_LE(report.maxErrorPx, 3.0);
        worst = std::max(worst, report.maxErrorPx);
    }
    EXPECT_GT(worst, 1.0); // a check that always sees 0 would pass, too

    // The mutation: a mesh made for twice the tolerance breaks the bound.
    const auto view = BenchmarkFlight{}.view(flightTile()->tile, 0);
    mesh.refine(view, {.errorTolerancePx = 12.0});
    EXPECT_GT(checkDrawnMesh(*flightTile(), mesh.drawn(), &view).maxErrorPx, 3.0);
}

TEST_P(RoamMeshTest, CeilingIsNeverExceededAndRaisesTheToleranceForTheWholeFrame)
{
    core::RoamMesh mesh(flightTile(), GetParam());
    for (const std::uint32_t ceiling : {2u, 3u, 100u, 1000u, 5000u})
        for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += 30)
        {
            const auto view = BenchmarkFlight{}.view(flightTile()->tile, frame);
            const RefineResult result = mesh.refine(view, {.errorTolerancePx = 0.5, .maxTriangles = ceiling});
            ASSERT_LE(result.leaves, ceiling);
            ASSERT_TRUE(result.ceilingBound);
            ASSERT_GT(result.tolerancePx, 0.5);
            const auto within = meshFromScratch(view, result.tolerancePx);
            if (GetParam() == Driver::queue)
                ASSERT_LE(within.size(), result.leaves); // it also splits some of those that are exactly at τ
            else
                ASSERT_EQ(leafSet(mesh.tree()), within);
            EXPECT_GE(
                result.leaves,
                ceiling < 1000 ? 2 : ceiling - std::max(ceiling / 100, 4u)); // detail is used where it may be
        }
    EXPECT_TRUE(mesh.isConforming());
}

TEST_P(RoamMeshTest, CeilingThatDoesNotBindChangesNothing)
{
    core::RoamMesh limited(flightTile(), GetParam()), free(flightTile(), GetParam());
    const auto view = BenchmarkFlight{}.view(flightTile()->tile, 50);
    const auto wanted = free.refine(view, {});
    const auto result = limited.refine(view, {.errorTolerancePx = 1.0, .maxTriangles = wanted.leaves});
    EXPECT_FALSE(result.ceilingBound);
    EXPECT_EQ(leafSet(limited.tree()), leafSet(free.tree()));
}

TEST_P(RoamMeshTest, RecordedFlightHasItsGoldenHash)
{
    const auto flown = [](double aboveGroundM)
    {
        core::RoamMesh mesh(flightTile(), GetParam());
        std::uint64_t hash = 0;
        for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += 4)
        {
            mesh.refine(BenchmarkFlight{.aboveGroundM = aboveGroundM}.view(flightTile()->tile, frame),
                        {.errorTolerancePx = 2.0});
            hash = hash * 31 + hashOf(leafSet(mesh.tree()));
        }
        return hash;
    };
    constexpr std::uint64_t kGolden = 0xd2cd262dcd24e006ull;
    EXPECT_EQ(flown(300.0), kGolden) << std::hex << flown(300.0);
    EXPECT_NE(flown(300.5), kGolden); // half a metre higher is another flight
}

TEST_P(RoamMeshTest, ViewIndependentRefinementGoesBothWays)
{
    core::RoamMesh mesh(flightTile(), GetParam());
    const auto fine = mesh.refine(2.0).triangles;
    const auto coarse = mesh.refine(60.0).triangles;
    EXPECT_LT(coarse, fine);
    EXPECT_TRUE(mesh.isConforming());
    EXPECT_EQ(mesh.refine(2.0).triangles, fine);
    EXPECT_EQ(mesh.refine(-1.0).triangles, 2u * 256 * 256); // every error exceeds it
}

INSTANTIATE_TEST_SUITE_P(Drivers, RoamMeshTest, testing::ValuesIn(kDrivers),
                         [](const auto& given) { return std::string(driverName(given.param)); });

} // namespace
