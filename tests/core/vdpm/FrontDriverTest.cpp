// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/vdpm/HeightFieldForest.h>
#include <osgTerrainROAM/core/vdpm/VdpmMesh.h>

#include "RealData.h"
#include "SurfaceError.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace osgTerrainROAM::core
{

namespace
{

using measurement::BenchmarkFlight;
using measurement::Path;
constexpr double kRoundingPx = 0.02; ///< vertices are drawn in whole steps

std::shared_ptr<const BoundedForest> forestFor(const RoamTile& tile)
{
    return std::make_shared<const BoundedForest>(std::move(*heightFieldForest(tile.tile)));
}

viewlod::Budget pixels(double tolerancePx)
{
    viewlod::Budget budget;
    budget.errorTolerancePx = tolerancePx;
    return budget;
}

std::set<std::uint32_t> doneSplits(const VdpmMesh& mesh)
{
    std::set<std::uint32_t> done;
    const ActiveFront& front = mesh.driver().front();
    for (std::uint32_t w = 0; w < front.forest().splitCount(); ++w)
        if (front.isDone(w)) done.insert(w);
    return done;
}

class HillsFlight : public testing::Test
{
protected:
    std::shared_ptr<const RoamTile> tile =
        testsupport::planarTile(testsupport::hills(97, 97, 60.0), Storage::exact);
    std::shared_ptr<const BoundedForest> forest = forestFor(*tile);
};

TEST_F(HillsFlight, NeverExceedsTheToleranceOnAnyPath)
{
    for (const Path path : measurement::kPaths)
        for (const double tolerancePx : {1.0, 4.0})
        {
            VdpmMesh mesh(tile, forest);
            const BenchmarkFlight flight = BenchmarkFlight::along(path);
            std::uint32_t least = ~0u, most = 0;
            for (int frame = 0; frame < 96; frame += path == Path::turn ? 8 : 1)
            {
                const viewlod::ViewState view = flight.view(tile->tile, frame);
                const RefineResult result = mesh.refine(view, pixels(tolerancePx));
                least = std::min(least, result.triangles);
                most = std::max(most, result.triangles);
                EXPECT_EQ(result.errorBoundPx, tolerancePx);
                if (frame % 6 > 1) continue;
                const auto error = testsupport::surfaceError(*tile, mesh.drawn(), &view);
                ASSERT_LE(error.errorPx, tolerancePx + kRoundingPx) << pathName(path) << " " << frame;
                ASSERT_EQ(error.uncovered, 0u);
                ASSERT_TRUE(mesh.isValid());
            }
            EXPECT_GT(least, 10u);
            EXPECT_LT(most, 2u * 96u * 96u);
        }
}

TEST_F(HillsFlight, AHalvedErrorOfOneSplitIsFound)
{
    const viewlod::ViewState view = BenchmarkFlight{}.view(tile->tile, 0);
    int found = 0;
    for (std::uint32_t w = 0; w < 400; ++w)
    {
        auto damaged = std::make_shared<BoundedForest>(*forest);
        damaged->bounds[w].errorM = 0.0f;
        VdpmMesh mesh(tile, damaged);
        mesh.refine(view, pixels(1.0));
        found += testsupport::surfaceError(*tile, mesh.drawn(), &view).errorPx > 1.0 + kRoundingPx;
    }
    EXPECT_GT(found, 0);
}

TEST_F(HillsFlight, EndsInTheSameMeshWhateverCameBefore)
{
    VdpmMesh travelled(tile, forest);
    for (const Path path : {Path::flight, Path::jump, Path::drive})
        for (int frame = 0; frame < 60; ++frame)
        {
            const viewlod::ViewState view = BenchmarkFlight::along(path).view(tile->tile, frame);
            travelled.refine(view, pixels(1.0 + 0.02 * frame));
            if (frame % 5 != 4) continue;
            VdpmMesh fresh(tile, forest);
            fresh.refine(view, pixels(1.0 + 0.02 * frame));
            ASSERT_EQ(doneSplits(travelled), doneSplits(fresh));
        }
}

TEST_F(HillsFlight, ChecksNothingWhileTheEyeStandsStill)
{
    VdpmMesh mesh(tile, forest);
    const viewlod::ViewState view = BenchmarkFlight{}.view(tile->tile, 3);
    EXPECT_GT(mesh.refine(view, pixels(1.0)).checks, 100u);
    const RefineResult again = mesh.refine(view, pixels(1.0));
    EXPECT_EQ(again.checks + again.splits + again.merges, 0u);
    EXPECT_TRUE(mesh.changes().triangles.empty());
}

TEST_F(HillsFlight, DefersMostChecks)
{
    VdpmMesh mesh(tile, forest);
    std::uint64_t checks = 0, triangles = 0;
    for (int frame = 0; frame < 40; ++frame)
    {
        const RefineResult result = mesh.refine(BenchmarkFlight{0.05}.view(tile->tile, frame), pixels(1.0));
        if (frame == 0) continue;
        checks += result.checks;
        triangles += result.triangles;
    }
    EXPECT_LT(checks, triangles / 4);
}

TEST_F(HillsFlight, NeverExceedsTheCeilingAndFillsIt)
{
    VdpmMesh mesh(tile, forest);
    viewlod::Budget budget = pixels(0.25);
    for (int frame = 0; frame < 80; ++frame)
    {
        budget.maxTriangles = frame < 40 ? 1500 : 600;
        const viewlod::ViewState view =
            BenchmarkFlight::along(frame < 60 ? Path::flight : Path::jump).view(tile->tile, frame);
        const RefineResult result = mesh.refine(view, budget);
        EXPECT_LE(result.triangles, budget.maxTriangles) << frame;
        EXPECT_GE(result.triangles, budget.maxTriangles * 0.85) << frame;
        EXPECT_TRUE(result.ceilingBound);
        EXPECT_LE(testsupport::surfaceError(*tile, mesh.drawn(), &view).errorPx,
                  result.errorBoundPx + kRoundingPx);
        EXPECT_TRUE(mesh.isValid());
    }
    budget.maxTriangles = std::numeric_limits<std::uint32_t>::max();
    const RefineResult free = mesh.refine(BenchmarkFlight{}.view(tile->tile, 80), budget);
    EXPECT_EQ(free.tolerancePx, 0.25);
    EXPECT_FALSE(free.ceilingBound);
}

TEST_F(HillsFlight, StopsWhenTheSliceEndsAndTellsTheBoundThatHolds)
{
    VdpmMesh mesh(tile, forest);
    viewlod::Budget budget = pixels(0.5);
    budget.clock = viewlod::Budget::Clock::modelled;
    budget.maxTimeUs = 12.0;
    int bound = 0, finite = 0;
    for (int frame = 0; frame < 120; ++frame)
    {
        const viewlod::ViewState view =
            BenchmarkFlight::along(frame < 60 ? Path::flight : Path::jump).view(tile->tile, frame);
        const RefineResult result = mesh.refine(view, budget);
        bound += result.sliceBound;
        ASSERT_TRUE(mesh.isValid());
        if (std::isinf(result.errorBoundPx)) continue;
        ++finite;
        ASSERT_LE(testsupport::surfaceError(*tile, mesh.drawn(), &view).errorPx,
                  result.errorBoundPx + kRoundingPx);
    }
    EXPECT_GT(bound, 20);
    EXPECT_GT(finite, 5);
    // It ends in the same mesh as without slices.
    const viewlod::ViewState last = BenchmarkFlight{}.view(tile->tile, 5);
    for (int frame = 0; frame < 4000 && mesh.refine(last, budget).sliceBound; ++frame)
        ASSERT_LT(frame, 3999);
    VdpmMesh whole(tile, forest);
    whole.refine(last, pixels(0.5));
    EXPECT_EQ(doneSplits(mesh), doneSplits(whole));
}

TEST_F(HillsFlight, RefinesOnlyWhatIsInSightAndKeepsTheToleranceThere)
{
    VdpmMesh all(tile, forest), seen(tile, forest);
    for (int frame = 0; frame < 240; frame += 20)
    {
        const viewlod::ViewState view = BenchmarkFlight::along(Path::turn).view(tile->tile, frame);
        viewlod::Sight sight;
        sight.add(view, 0.0);
        seen.setSight(sight);
        const std::uint32_t triangles = all.refine(view, pixels(1.0)).triangles;
        EXPECT_LT(seen.refine(view, pixels(1.0)).triangles, triangles * 3 / 4);
        EXPECT_LE(testsupport::surfaceError(*tile, seen.drawn(), &view).errorPx, 1.0 + kRoundingPx);
        EXPECT_TRUE(seen.isValid());
        VdpmMesh fresh(tile, forest);
        fresh.setSight(sight);
        fresh.refine(view, pixels(1.0));
        EXPECT_EQ(doneSplits(seen), doneSplits(fresh));
    }
}

/// The largest change of a sample's drawn height, in pixels, beyond a distance from the eye.
double largestJumpPx(const RoamTile& tile, const viewlod::ViewState& view, const std::vector<float>& before,
                     const std::vector<float>& after)
{
    double largest = 0.0;
    const auto columns = static_cast<std::size_t>(tile.tile.field().columns);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        glm::dvec3 from = tile.tile.position(static_cast<int>(i % columns), static_cast<int>(i / columns)),
                   to = from;
        from.z = before[i];
        to.z = after[i];
        largest = std::max(largest, testsupport::errorPxOf(view, from, to));
    }
    return largest;
}

TEST_F(HillsFlight, MovesVerticesWithoutJumpsAndKeepsTheToleranceMeanwhile)
{
    constexpr double kTolerancePx = 2.0;
    double jumpPx[2] = {0.0, 0.0};
    for (const bool moves : {false, true})
    {
        VdpmMesh mesh(tile, forest);
        mesh.setMorphing(moves);
        std::vector<float> before;
        int moving = 0;
        for (int frame = 0; frame < 100; ++frame)
        {
            const viewlod::ViewState view = BenchmarkFlight{0.04}.view(tile->tile, frame);
            const RefineResult result = mesh.refine(view, pixels(kTolerancePx));
            const auto error = testsupport::surfaceError(*tile, mesh.drawn(), &view);
            ASSERT_LE(error.errorPx, kTolerancePx + kRoundingPx) << frame;
            ASSERT_EQ(result.errorBoundPx, kTolerancePx);
            ASSERT_EQ(error.uncovered + error.turned, 0u) << frame;
            ASSERT_TRUE(mesh.isValid());
            if (frame > 1)
                jumpPx[moves] = std::max(jumpPx[moves], largestJumpPx(*tile, view, before, error.heightsM));
            before = error.heightsM;
            for (std::uint32_t v = 0; v < forest->forest.vertexCount(); ++v)
                moving += mesh.driver().front().isActive(v) && mesh.driver().weightOf(v) < 1.0f;
        }
        EXPECT_EQ(moving > 100, moves);
        EXPECT_EQ(mesh.driver().jumps(), 0u);
    }
    EXPECT_LT(jumpPx[1], 0.25 * kTolerancePx);
    EXPECT_GT(jumpPx[0], 3.0 * jumpPx[1]); // what vertices that jump do
    std::cout << "largest change of a sample in a frame: " << jumpPx[0] << " px, with morphing " << jumpPx[1]
              << " px\n";
}

TEST_F(HillsFlight, KeepsTheToleranceWhileVerticesMoveOnHardPaths)
{
    for (const Path path : {Path::flight, Path::drive, Path::jump, Path::uturn})
    {
        VdpmMesh mesh(tile, forest);
        mesh.setMorphing(true);
        for (int frame = 0; frame < 40; ++frame)
        {
            const viewlod::ViewState view = BenchmarkFlight::along(path).view(tile->tile, frame);
            const RefineResult result = mesh.refine(view, pixels(2.0));
            const auto error = testsupport::surfaceError(*tile, mesh.drawn(), &view);
            ASSERT_LE(error.errorPx, result.errorBoundPx + kRoundingPx) << pathName(path) << " " << frame;
            ASSERT_EQ(error.uncovered + error.turned, 0u);
            const DrawnMeshReport report = checkDrawnMesh(*tile, mesh.drawn(), &view);
            ASSERT_EQ(report.tJunctions + report.cracks, 0u) << pathName(path) << " " << frame;
            ASSERT_NEAR(report.maxErrorPx, error.errorPx, kRoundingPx) << "two ways of finding it";
            ASSERT_EQ(result.errorBoundPx, 2.0);
            ASSERT_TRUE(mesh.isValid());
        }
    }
}

TEST_F(HillsFlight, MovingVerticesEndInTheMeshOfTheEye)
{
    VdpmMesh mesh(tile, forest), fresh(tile, forest);
    mesh.setMorphing(true);
    const BenchmarkFlight flight;
    for (int frame = 0; frame < 40; ++frame)
        mesh.refine(flight.view(tile->tile, frame), pixels(2.0));
    const viewlod::ViewState last = flight.view(tile->tile, 40);
    for (int frame = 0; frame < 1000; ++frame)
        mesh.refine(last, pixels(2.0));
    EXPECT_TRUE(mesh.changes().vertices.empty());
    fresh.refine(last, pixels(1.5)); // the share of the tolerance at which vertices begin to move
    EXPECT_EQ(doneSplits(mesh), doneSplits(fresh));
}

TEST_F(HillsFlight, TooSmallErrorsAreFoundWhileVerticesMove)
{
    auto careless = std::make_shared<BoundedForest>(*forest);
    for (SplitBound& bound : careless->bounds)
        bound.errorM *= 0.5f;
    VdpmMesh mesh(tile, careless);
    mesh.setMorphing(true);
    double worst = 0.0, worstOfCheck = 0.0;
    for (int frame = 0; frame < 20; ++frame)
    {
        const viewlod::ViewState view = BenchmarkFlight{}.view(tile->tile, frame);
        mesh.refine(view, pixels(2.0));
        worst = std::max(worst, testsupport::surfaceError(*tile, mesh.drawn(), &view).errorPx);
        worstOfCheck = std::max(worstOfCheck, checkDrawnMesh(*tile, mesh.drawn(), &view).maxErrorPx);
    }
    EXPECT_GT(worst, 2.0 + kRoundingPx);
    EXPECT_GT(worstOfCheck, 2.0 + kRoundingPx);
}

TEST_F(HillsFlight, ASpikeAddsTrianglesOnlyAroundIt)
{
    HeightField field = testsupport::hills(97, 97, 60.0);
    const viewlod::ViewState view = BenchmarkFlight{}.view(tile->tile, 0);
    VdpmMesh plain(tile, forest);
    const std::uint32_t before = plain.refine(view, pixels(2.0)).triangles;
    field.heightsM[50 * 97 + 50] += 400.0f;
    const auto spiked = testsupport::planarTile(field, Storage::exact);
    VdpmMesh mesh(spiked, forestFor(*spiked));
    EXPECT_LT(mesh.refine(view, pixels(2.0)).triangles, before + 200);
}

/// Parts of the crops on which methods are compared: every frame of the flight, all samples.
class CropFlight : public testing::TestWithParam<measurement::RasterCrop>
{
};

TEST_P(CropFlight, KeepsItsToleranceInEveryFrameWithFewerTrianglesThanRoam)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    measurement::RasterCrop part = GetParam();
    part.side = 257;
    const auto tile = testsupport::planarTile(part.of(*imported), Storage::exact);
    VdpmMesh mesh(tile, forestFor(*tile));
    RoamMesh roam(tile);
    const Path path = part.cellM > 10.0 ? Path::flight : Path::drive;
    std::uint64_t triangles = 0, ofRoam = 0;
    for (int frame = 0; frame < BenchmarkFlight::kFrames; ++frame)
    {
        const viewlod::ViewState view = BenchmarkFlight::along(path).view(tile->tile, frame);
        triangles += mesh.refine(view, pixels(2.0)).triangles;
        ofRoam += roam.refine(view, pixels(2.0)).triangles;
        if (frame % 3 != 0) continue;
        ASSERT_LE(testsupport::surfaceError(*tile, mesh.drawn(), &view).errorPx, 2.0 + kRoundingPx) << frame;
    }
    EXPECT_LT(triangles, 0.7 * ofRoam);
    RecordProperty("shareOfRoam", std::to_string(static_cast<double>(triangles) / ofRoam));
    std::cout << "share of ROAM's triangles " << static_cast<double>(triangles) / ofRoam << '\n';
}

INSTANTIATE_TEST_SUITE_P(Crops, CropFlight,
                         testing::Values(measurement::kWhiteMountains, measurement::kAconcagua,
                                         measurement::kGreenRiver),
                         [](const auto& crop)
                         { return std::filesystem::path(crop.param.file).stem().string().substr(0, 6); });

} // namespace

} // namespace osgTerrainROAM::core
