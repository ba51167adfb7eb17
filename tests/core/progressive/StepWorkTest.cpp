// SPDX-License-Identifier: Apache-2.0
// The work of steps, counted: what a step rewrites of the index buffer, and what it reads to do so. A
// processor's time for it differs between machines and hours; `progressive_bench` measures that.
#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ScannedMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// What a step takes on average, from the finest level to the coarsest and back.
struct StepWork
{
    double facesMoved;   ///< to other slots
    double facesChanged; ///< in their corners, with those that vanish or come back
    double bytesRead;    ///< of what is kept of all steps
};

StepWork workOf(const Mesh& mesh, const CollapseSequence& sequence, const ArrangementSettings& settings)
{
    const ProgressiveMesh progressive = buildProgressiveMesh(mesh, sequence, settings);
    ProgressiveLevel level(progressive);
    level.moveTo(progressive.stepCount);
    level.moveTo(0);
    const StepStatistics& all = level.statistics();
    const auto steps = static_cast<double>(all.steps);
    return {static_cast<double>(all.facesMoved) / steps,
            static_cast<double>(all.facesPatched + all.facesVanished) / steps,
            static_cast<double>(progressive.overheadBytes()) / static_cast<double>(progressive.stepCount)};
}

TEST(StepWork, OfFacesInAGoodOrderIsHardlyMoreThanOfPlainOnes)
{
    const Mesh mesh = testsupport::scannedBlob(48);
    const CollapseSequence sequence = simplify(mesh);
    const StepWork windows = workOf(mesh, sequence, {}),
                   plain = workOf(mesh, sequence, {.arrangement = Arrangement::plain}),
                   often = workOf(mesh, sequence, {.arrangement = Arrangement::tswap, .tswapStep = 0.02f});
    EXPECT_EQ(plain.facesMoved, 0.0);
    EXPECT_LT(windows.facesMoved, 3.0);
    EXPECT_LT(windows.bytesRead, plain.bytesRead);
    EXPECT_DOUBLE_EQ(windows.facesChanged, plain.facesChanged);
    // The control: an order that is made anew at every fiftieth is beyond both limits.
    EXPECT_GT(often.facesMoved, 3.0);
    EXPECT_GT(often.bytesRead, plain.bytesRead);
    RecordProperty("facesMovedPerHundredSteps", static_cast<int>(100.0 * windows.facesMoved));
    RecordProperty("bytesReadPercentOfPlain", static_cast<int>(100.0 * windows.bytesRead / plain.bytesRead));
}

} // namespace
