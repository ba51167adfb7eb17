// SPDX-License-Identifier: Apache-2.0
// Processor time of steps. Times differ between machines and from minute to minute; ratios of the least of
// many runs hardly do.
#include <algorithm>
#include <ctime>
#include <limits>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ScannedMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// Plays all steps down and up once and returns the processor time of this thread, s.
double playOnce(ProgressiveLevel& level, std::uint32_t steps)
{
    const auto now = []
    {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double begin = now();
    level.moveTo(steps);
    level.moveTo(0);
    return now() - begin;
}

TEST(StepTime, StepsWithFacesInAGoodOrderTakeNoLongerThanPlainOnes)
{
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "times mean something in optimised builds only";
#endif
    constexpr double kMostRatio = 1.1;
    constexpr int kLeastRuns = 15, kMostRuns = 300; // other load only adds to a time: more runs, until the least hold
    const Mesh mesh = testsupport::scannedBlob(48);
    const CollapseSequence sequence = simplify(mesh);
    const auto built = [&](Arrangement arrangement)
    { return buildProgressiveMesh(mesh, sequence, {.arrangement = arrangement}); };
    const ProgressiveMesh windows = built(Arrangement::windows), plain = built(Arrangement::plain),
                          tswap = built(Arrangement::tswap);
    ProgressiveLevel windowLevel(windows), plainLevel(plain), tswapLevel(tswap);
    double windowTime = std::numeric_limits<double>::max(), plainTime = windowTime, tswapTime = windowTime;
    const auto holds = [&] { return windowTime <= kMostRatio * plainTime && tswapTime > kMostRatio * plainTime; };
    for (int run = 0; run < kLeastRuns || (run < kMostRuns && !holds()); ++run)
    {
        windowTime = std::min(windowTime, playOnce(windowLevel, windows.stepCount));
        plainTime = std::min(plainTime, playOnce(plainLevel, plain.stepCount));
        tswapTime = std::min(tswapTime, playOnce(tswapLevel, tswap.stepCount));
    }
    RecordProperty("windowsToPlainPercent", static_cast<int>(100.0 * windowTime / plainTime));
    EXPECT_LE(windowTime, kMostRatio * plainTime);
    EXPECT_GT(tswapTime, kMostRatio * plainTime); // the control: an order whose steps do take longer
}

} // namespace
