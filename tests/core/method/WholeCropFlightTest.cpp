// SPDX-License-Identifier: Apache-2.0
// Checks every method by brute force along the three paths over the three whole squares on which terrain
// engines are compared. All frames take half an hour, so they are checked by hand: method_test
// --gtest_also_run_disabled_tests --gtest_filter='*WholeCropFlight*'. The variable OSGTRAINER_FRAMES_BETWEEN
// leaves out frames: 24 means every 24th.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/method/PrepareTerrain.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "RealData.h"
#include "SpoiledMesh.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;
using measurement::Path;
using TilePtr = std::shared_ptr<const RoamTile>;

constexpr double kFlownTolerancePx = 2.0;

/// The mesh that a method draws for an eye.
using DrawnForEye = std::function<DrawnMesh(const viewlod::ViewState&)>;

DrawnForEye drawnBy(Method method, const TilePtr& tile)
{
    auto prepared = prepareTerrain(tile, {.method = method});
    EXPECT_TRUE(prepared);
    return [shared = *prepared, mesh = std::shared_ptr((*prepared)->newMesh())](const auto& view)
    {
        mesh->refine(view, {.errorTolerancePx = kFlownTolerancePx});
        return mesh->drawn();
    };
}

DrawnForEye drawnFromScratch(const TilePtr& tile)
{
    return [bounds = SplitBounds(tile)](const auto& view)
    {
        std::vector<GridTriangle> leaves;
        refineFromScratch(bounds, view, kFlownTolerancePx, leaves);
        return meshOfLeaves(bounds, leaves);
    };
}

/// Plants faults into a sound mesh; each must be found.
void expectFaultsAreFound(const RoamTile& tile, const DrawnMesh& sound, const viewlod::ViewState& view)
{
    const std::uint32_t seen = testsupport::seenVertex(sound, view);
    ASSERT_NE(seen, kNone);
    const auto holed = checkDrawnMesh(tile, testsupport::withoutTrianglesAt(sound, seen), &view);
    EXPECT_GT(holed.tJunctions, 0u);
    EXPECT_GT(holed.cracks, 0u);
    const auto raised = checkDrawnMesh(
        tile, testsupport::withVertexRaised(sound, seen, view, 2.0 * kFlownTolerancePx), &view);
    EXPECT_GT(raised.cracks, 0u);
    EXPECT_GT(raised.maxErrorPx, kFlownTolerancePx);
}

/// Flies a method along a path, and says what was found.
void fly(const RoamTile& tile, const DrawnForEye& drawnFor, Path path, int framesBetween)
{
    DrawnMeshReport worst;
    std::size_t triangles = 0;
    int frames = 0;
    for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += framesBetween)
    {
        const auto view = BenchmarkFlight::along(path).view(tile.tile, frame);
        const DrawnMesh drawn = drawnFor(view);
        const DrawnMeshReport report = checkDrawnMesh(tile, drawn, &view);
        worst.tJunctions += report.tJunctions;
        worst.cracks += report.cracks;
        worst.maxErrorPx = std::max(worst.maxErrorPx, report.maxErrorPx);
        triangles += drawn.triangles.size();
        if (frame == 0) expectFaultsAreFound(tile, drawn, view);
        ++frames;
    }
    EXPECT_EQ(worst.tJunctions + worst.cracks, 0u);
    EXPECT_LE(worst.maxErrorPx, kFlownTolerancePx);
    EXPECT_GT(worst.maxErrorPx, 0.0);
    std::cout << pathName(path) << ": " << frames << " frames, " << worst.tJunctions << " T-junctions, "
              << worst.cracks << " cracks, " << worst.maxErrorPx << " px, "
              << triangles / static_cast<std::size_t>(frames) << " triangles" << std::endl;
}

/// Flies every method, ROAM from scratch among them, along every path over a square.
void flyOver(const measurement::RasterCrop& crop, const std::filesystem::path& file, int framesBetween)
{
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    const TilePtr tile = testsupport::planarTile(crop.of(*imported));
    for (std::size_t i = 0; i <= kMethods.size(); ++i)
    {
        const bool isScratch = i == kMethods.size();
        const std::string name = isScratch ? "scratch" : std::string(kMethods[i].name);
        const DrawnForEye drawnFor = isScratch ? drawnFromScratch(tile) : drawnBy(kMethods[i].method, tile);
        for (const Path path : {Path::flight, Path::drive, Path::jump})
        {
            SCOPED_TRACE(name + " " + std::string(pathName(path)));
            std::cout << crop.file << ' ' << name << ' ';
            fly(*tile, drawnFor, path, framesBetween);
        }
    }
}

TEST(WholeCropFlight, EveryMethodIsSoundOverTheLidarCrop)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, measurement::kGreenRiver.file);
    flyOver(measurement::kGreenRiver, file, 59); // an odd number: jumps are checked at both of their ends
}

class WholeCropFlightInFull : public testing::TestWithParam<measurement::RasterCrop>
{
};

TEST_P(WholeCropFlightInFull, DISABLED_EveryMethodIsSound)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().file);
    const char* between = std::getenv("OSGTRAINER_FRAMES_BETWEEN");
    flyOver(GetParam(), file, std::max(1, between ? std::atoi(between) : 1));
}

INSTANTIATE_TEST_SUITE_P(Crops, WholeCropFlightInFull,
                         testing::Values(measurement::kWhiteMountains, measurement::kAconcagua,
                                         measurement::kGreenRiver),
                         [](const auto& given)
                         { return std::filesystem::path(given.param.file).stem().string().substr(0, 6); });

} // namespace
