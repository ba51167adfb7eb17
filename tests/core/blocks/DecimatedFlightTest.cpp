// SPDX-License-Identifier: Apache-2.0
// Regular decimation over real data: frames of the benchmark paths are checked by brute force.
#include "DecimatedFlight.h"

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RealData.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;
using measurement::Path;

struct Case
{
    measurement::RasterCrop square;
    Path path;
    bool morphs;
};

constexpr int kFramesBetweenChecks =
    17; ///< odd: the path that jumps is met at both ends; 1: every frame, in 10 minutes

/// The part of a square that a suite has time for.
measurement::RasterCrop partOf(measurement::RasterCrop square)
{
    square.side = 257;
    return square;
}

class DecimatedFlight : public testing::TestWithParam<Case>
{
};

TEST_P(DecimatedFlight, IsSound)
{
    const Case& flown = GetParam();
    OSGTRAINER_REAL_DATA_OR_SKIP(file, flown.square.file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    const auto tile = testsupport::planarTile(partOf(flown.square).of(*imported));
    const PreparedDecimation prepared(tile);
    const auto mesh = prepared.newMesh();
    mesh->setMorphing(flown.morphs);
    for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += kFramesBetweenChecks)
    {
        const auto view = BenchmarkFlight::along(flown.path).view(tile->tile, frame);
        const RefineResult result = mesh->refine(view, {.errorTolerancePx = 2.0});
        ASSERT_EQ(result.tolerancePx, 2.0);
        ASSERT_TRUE(testsupport::isSound(*mesh, view, 2.0)) << frame;
    }
}

std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const auto& square :
         {measurement::kWhiteMountains, measurement::kAconcagua, measurement::kGreenRiver})
        for (const Path path : {Path::flight, Path::drive, Path::jump})
            for (const bool morphs : {false, true})
                all.push_back({square, path, morphs});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Crops, DecimatedFlight, testing::ValuesIn(cases()),
                         [](const auto& given)
                         {
                             const Case& c = given.param;
                             return std::filesystem::path(c.square.file).stem().string().substr(0, 6) + "_" +
                                    std::string(pathName(c.path)) + (c.morphs ? "_morphing" : "");
                         });

} // namespace
