// SPDX-License-Identifier: Apache-2.0
// Simulated time after a wall clock that the test turns by hand.
#include "simulation/clock/RealTimePace.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace
{

using simulation::RealTimePace;

constexpr double kStepS = 1.0 / 120.0;

/// Reads the clock every `frameS` for `durationS`; returns the steps made.
std::int64_t runFrames(RealTimePace& pace, double frameS, double durationS, double fromS = 0.0)
{
    const auto frames = std::llround(durationS / frameS);
    std::int64_t steps = pace.advance(fromS);
    for (std::int64_t i = 1; i <= frames; ++i)
        steps += pace.advance(fromS + static_cast<double>(i) * frameS);
    return steps;
}

TEST(RealTimePace, KeepsRealTimeAtAnyRateOfPictures)
{
    for (const double frameS : {1.0 / 240.0, 1.0 / 60.0, 0.041, 0.5, 0.999})
    {
        RealTimePace pace(kStepS);
        const auto frames = std::llround(300.0 / frameS);
        const std::int64_t steps = runFrames(pace, frameS, 300.0);
        const double wallS = static_cast<double>(frames) * frameS;
        EXPECT_EQ(steps, pace.steps());
        EXPECT_NEAR(pace.timeS() / wallS, 1.0, 1e-9) << frameS;
        EXPECT_NEAR(static_cast<double>(steps) * kStepS, wallS, kStepS) << frameS;
        EXPECT_EQ(pace.cutS(), 0.0);
    }
}

// The control of the test above: a longest gap below the frames loses time, and says how much.
TEST(RealTimePace, CutsALongGapAndSaysSo)
{
    RealTimePace pace(kStepS, 0.25);
    runFrames(pace, 0.5, 10.0);
    EXPECT_NEAR(pace.timeS(), 5.0, 1e-9);
    EXPECT_NEAR(pace.cutS(), 5.0, 1e-9);
    EXPECT_NEAR(pace.wallS(), 10.0, 1e-9);
}

TEST(RealTimePace, ShowsATimeInTheLastStep)
{
    RealTimePace pace(kStepS);
    pace.advance(100.0);
    EXPECT_EQ(pace.advance(100.0 + 0.5 * kStepS), 1);
    EXPECT_NEAR(pace.share(), 0.5, 1e-9);
    EXPECT_EQ(pace.advance(100.0 + 0.75 * kStepS), 0);
    EXPECT_NEAR(pace.share(), 0.75, 1e-9);
    EXPECT_EQ(pace.advance(100.0 + 2.25 * kStepS), 2);
    EXPECT_NEAR(pace.share(), 0.25, 1e-6);
}

TEST(RealTimePace, WaitsInAPauseAndMakesSingleSteps)
{
    RealTimePace pace(kStepS);
    runFrames(pace, 0.02, 1.0);
    pace.setPaused(true);
    const std::int64_t steps = pace.steps();
    EXPECT_EQ(pace.share(), 1.0); // the end of the step that was begun
    EXPECT_EQ(pace.advance(50.0), 0);
    pace.stepOnce();
    pace.stepOnce();
    EXPECT_EQ(pace.advance(60.0), 2);
    EXPECT_EQ(pace.advance(61.0), 0);
    EXPECT_NEAR(pace.timeS(), static_cast<double>(steps + 2) * kStepS, 1e-12);
    pace.setPaused(false);
    EXPECT_EQ(pace.advance(61.0 + kStepS), 1); // the pause is not caught up
    EXPECT_NEAR(pace.wallS(), 1.0 + kStepS, 1e-9);
}

TEST(RealTimePace, GoesSlowerAndFasterWithinItsLimits)
{
    RealTimePace pace(kStepS);
    pace.setRate(0.25);
    runFrames(pace, 0.02, 4.0);
    EXPECT_NEAR(pace.timeS(), 1.0, 1e-9);
    pace.setRate(8.0);
    runFrames(pace, 0.02, 1.0, 4.0);
    EXPECT_NEAR(pace.timeS(), 9.0, 1e-9);
    for (int i = 0; i < 20; ++i)
        pace.faster();
    EXPECT_EQ(pace.rate(), RealTimePace::kFastest);
    for (int i = 0; i < 20; ++i)
        pace.slower();
    EXPECT_EQ(pace.rate(), RealTimePace::kSlowest);
    pace.setRate(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(pace.rate(), RealTimePace::kSlowest);
}

TEST(RealTimePace, TakesAClockThatGoesBackAsNoTime)
{
    RealTimePace pace(kStepS);
    pace.advance(10.0);
    EXPECT_EQ(pace.advance(5.0), 0);
    EXPECT_EQ(pace.advance(std::numeric_limits<double>::infinity()), 0);
    EXPECT_EQ(pace.advance(5.0 + kStepS), 1);
    pace.reset();
    EXPECT_EQ(pace.timeS(), 0.0);
    EXPECT_EQ(pace.share(), 1.0);
}

TEST(RealTimePace, KeepsItsInvariantThroughRandomUse)
{
    std::mt19937 random(1);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    RealTimePace pace(kStepS);
    double wallS = 0.0;
    for (int i = 0; i < 10'000; ++i)
    {
        switch (below(12))
        {
        case 0:
            pace.setPaused(below(2) == 0);
            break;
        case 1:
            pace.stepOnce();
            break;
        case 2:
            pace.setRate(0.1 * below(100));
            break;
        case 3:
            if (below(20) == 0) pace.reset();
            break;
        default:
            wallS += 0.001 * (below(400) - 20);
        }
        const std::int64_t before = pace.steps(), due = pace.advance(wallS);
        ASSERT_GE(due, 0);
        ASSERT_EQ(pace.steps(), before + due);
        ASSERT_LE(pace.timeS(), (static_cast<double>(pace.steps()) + 1e-6) * kStepS);
        ASSERT_GT(pace.timeS() + 1e-6 * kStepS, static_cast<double>(pace.steps() - 1) * kStepS);
    }
}

} // namespace
