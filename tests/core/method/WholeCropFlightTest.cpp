// SPDX-License-Identifier: Apache-2.0
// Checks every method by brute force along the three paths over the three whole squares on which terrain engines are compared. It takes
// an hour, so it is run by hand: method_test --gtest_also_run_disabled_tests --gtest_filter='*WholeCropFlight*'. The variable
// OSGTRAINER_FRAMES_BETWEEN leaves out frames: 24 means every 24th.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/method/PrepareTerrain.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>

#include "RealData.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;
using measurement::Path;

constexpr double kFlownTolerancePx = 2.0;

int framesBetween()
{
    const char* text = std::getenv("OSGTRAINER_FRAMES_BETWEEN");
    return std::max(1, text ? std::atoi(text) : 1);
}

class WholeCropFlight : public testing::TestWithParam<measurement::RasterCrop>
{
};

TEST_P(WholeCropFlight, DISABLED_IsSoundByEveryMethod)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    const auto tile = testsupport::planarTile(GetParam().of(*imported));
    for (const MethodTraits& traits : kMethods)
    {
        const auto prepared = prepareTerrain(tile, {.method = traits.method});
        ASSERT_TRUE(prepared);
        const auto mesh = (*prepared)->newMesh();
        for (const Path path : {Path::flight, Path::drive, Path::jump})
        {
            DrawnMeshReport worst;
            double triangles = 0.0, frames = 0.0;
            for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += framesBetween())
            {
                const auto view = BenchmarkFlight::along(path).view(tile->tile, frame);
                mesh->refine(view, {.errorTolerancePx = kFlownTolerancePx});
                const DrawnMesh drawn = mesh->drawn();
                const DrawnMeshReport report = checkDrawnMesh(*tile, drawn, &view);
                worst.tJunctions += report.tJunctions;
                worst.cracks += report.cracks;
                worst.maxErrorPx = std::max(worst.maxErrorPx, report.maxErrorPx);
                triangles += static_cast<double>(drawn.triangles.size());
                frames += 1.0;
            }
            EXPECT_EQ(worst.tJunctions + worst.cracks, 0u) << traits.name << ' ' << pathName(path);
            EXPECT_LE(worst.maxErrorPx, kFlownTolerancePx) << traits.name << ' ' << pathName(path);
            std::cout << GetParam().file << ' ' << traits.name << ' ' << pathName(path) << ": " << frames
                      << " frames, " << worst.tJunctions << " T-junctions, " << worst.cracks << " cracks, "
                      << worst.maxErrorPx << " px, " << triangles / frames << " triangles" << std::endl;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Crops, WholeCropFlight,
                         testing::Values(measurement::kWhiteMountains, measurement::kAconcagua,
                                         measurement::kGreenRiver),
                         [](const auto& given)
                         { return std::filesystem::path(given.param.file).stem().string().substr(0, 6); });

} // namespace
