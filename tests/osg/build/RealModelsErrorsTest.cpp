// SPDX-License-Identifier: Apache-2.0
// Real models are drawn as coarse as their measured errors allow.
#include <filesystem>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/MeasureLevels.h>
#include <osgPMObjects/core/simplify/SimplificationError.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "RealData.h"
#include "compare/objects/ChosenLevel.h"
#include "pmtool/Models.h"

namespace
{

using namespace osgPMObjects::core;

class RealModelErrors : public testing::TestWithParam<const char*>
{
};

/// The largest distance of a level from the original, by other samples than those of the ladder.
double distanceOf(const SimplificationMeter& meter, const ProgressiveMesh& progressive, double diagonal,
                  std::uint32_t steps)
{
    return 0.01 * meter.measure(meshAfter(progressive, steps)).maxPercent * diagonal;
}

TEST_P(RealModelErrors, DrawAtMostAThirdMoreThanTheToleranceNeeds)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const auto model = pmtool::readClean(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    const Mesh& mesh = model->read.imported.mesh;
    ProgressiveMesh progressive =
        buildProgressiveMesh(mesh, simplify(mesh), {.arrangement = Arrangement::plain});
    measureLevels(progressive);
    const LevelTable table = LevelTable::of(progressive);
    ASSERT_TRUE(isLevelTable(table));
    const Mesh original = meshAfter(progressive, 0);
    const SimplificationMeter meter(original, 20'000);
    const double diagonal = extentOfFaces(original).diagonal();
    for (const double acrossPx : {30.0, 300.0})
    {
        const pmtool::ChosenLevel chosen = pmtool::levelShownAt(table, 0.5 * diagonal, acrossPx);
        EXPECT_LE(distanceOf(meter, progressive, diagonal, chosen.steps), 1.05 * chosen.tolerance)
            << acrossPx;
        int looked = 0;
        for (const std::uint32_t steps : ladderSteps(table.faces, 1.06))
        {
            constexpr int kMostLooked = 8; // the finest of the levels that would be too much coarser
            if (1.3 * table.faces[steps] >= chosen.faces || looked++ >= kMostLooked) continue;
            EXPECT_GT(distanceOf(meter, progressive, diagonal, steps), chosen.tolerance)
                << acrossPx << " px: " << table.faces[steps] << " triangles instead of " << chosen.faces;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Models, RealModelErrors,
                         testing::Values("vehicle/110Bus.ac", "vehicle/hoskosh-ti-1500.ac",
                                         "vehicle/ICE3firstcar.ac", "character/pirate.obj",
                                         "character/spider.obj"));

TEST(RealModelEstimates, DrawSeveralTimesWhatMeasuredErrorsDraw)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "models/character/pirate.obj");
    const auto model = pmtool::readClean(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    const Mesh& mesh = model->read.imported.mesh;
    ProgressiveMesh progressive = buildProgressiveMesh(mesh, simplify(mesh));
    measureLevels(progressive);
    const LevelTable measured = LevelTable::of(progressive);
    LevelTable estimated = measured; // the mutation
    estimated.measured = {};
    const double radius = 0.5 * extentOfFaces(mesh).diagonal();
    EXPECT_GT(pmtool::levelShownAt(estimated, radius, 30.0).faces,
              1.3 * pmtool::levelShownAt(measured, radius, 30.0).faces);
    EXPECT_GT(pmtool::levelShownAt(estimated, radius, 300.0).faces,
              1.3 * pmtool::levelShownAt(measured, radius, 300.0).faces);
}

} // namespace
