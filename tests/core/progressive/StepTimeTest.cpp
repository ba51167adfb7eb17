// SPDX-License-Identifier: Apache-2.0
// Processor time of steps. Times differ between machines and from minute to minute; ratios of the least of
// many runs hardly do.
#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ScannedMeshes.h"
#include "TableForm.h"

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

/// Returns the least processor time of each mesh in turns, s, from the finest level to the coarsest and back.
/// Other load only adds to a time: beyond 15 runs as many more as it takes until the least ones hold, 300 at
/// most.
std::vector<double> leastTimesOf(const std::vector<const ProgressiveMesh*>& meshes,
                                 const std::function<bool(const std::vector<double>&)>& holds)
{
    constexpr int kLeastRuns = 15, kMostRuns = 300;
    std::vector<ProgressiveLevel> levels;
    for (const ProgressiveMesh* mesh : meshes)
        levels.emplace_back(*mesh);
    std::vector<double> times(meshes.size(), std::numeric_limits<double>::max());
    for (int run = 0; run < kLeastRuns || (run < kMostRuns && !holds(times)); ++run)
        for (std::size_t i = 0; i < meshes.size(); ++i)
            times[i] = std::min(times[i], playOnce(levels[i], meshes[i]->stepCount));
    return times;
}

TEST(StepTime, StepsWithFacesInAGoodOrderTakeNoLongerThanPlainOnes)
{
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "times mean something in optimised builds only";
#endif
    constexpr double kMostRatio = 1.1;
    const Mesh mesh = testsupport::scannedBlob(48);
    const CollapseSequence sequence = simplify(mesh);
    const auto built = [&](const ArrangementSettings& settings)
    { return buildProgressiveMesh(mesh, sequence, settings); };
    const ProgressiveMesh windows = built({}), plain = built({.arrangement = Arrangement::plain}),
                          often = built({.arrangement = Arrangement::tswap, .tswapStep = 0.02f});
    const std::vector<double> times =
        leastTimesOf({&windows, &plain, &often}, [](const auto& least)
                     { return least[0] <= kMostRatio * least[1] && least[2] > kMostRatio * least[1]; });
    RecordProperty("windowsToPlainPercent", static_cast<int>(100.0 * times[0] / times[1]));
    EXPECT_LE(times[0], kMostRatio * times[1]);
    EXPECT_GT(times[2], kMostRatio * times[1]); // the control: an order whose steps do take longer
}

TEST(StepTime, CyclesTakeLessThanTables)
{
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "times mean something in optimised builds only";
#endif
    const Mesh mesh = testsupport::scannedBlob(48);
    const ProgressiveMesh cycles =
        buildProgressiveMesh(mesh, simplify(mesh), {.arrangement = Arrangement::tswap, .tswapStep = 0.05f});
    const ProgressiveMesh tables = testsupport::TableForm(cycles).tables();
    constexpr double kMostRatio = 0.85; // a half, where nothing else runs
    const std::vector<double> times =
        leastTimesOf({&cycles, &tables}, [](const auto& least) { return least[0] < kMostRatio * least[1]; });
    RecordProperty("cyclesToTablesPercent", static_cast<int>(100.0 * times[0] / times[1]));
    EXPECT_LT(times[0], kMostRatio * times[1]);
}

} // namespace
