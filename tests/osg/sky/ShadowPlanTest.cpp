// SPDX-License-Identifier: Apache-2.0
// The places of shadow maps: round the eye, moved by whole texels.
#include "ShadowPlan.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "Random.h"

namespace
{

using osgSky::ShadowPlan;

const std::array<double, 4> kReachesM{20.0, 90.0, 400.0, 5000.0};
constexpr int kTexels = 1024;

glm::dvec3 anywhere(testsupport::Random& random, double sizeM)
{
    return sizeM * (2.0 * glm::dvec3(random.unit(), random.unit(), random.unit()) - 1.0);
}

/// How far a number is from a whole one.
double fromWhole(double x)
{
    return std::abs(x - std::round(x));
}

} // namespace

TEST(ShadowPlan, MapsHaveTheEyeInTheMiddleAndMoveByWholeTexels)
{
    testsupport::Random random(1);
    for (int i = 0; i < 200; ++i)
    {
        const glm::dvec3 sun = glm::normalize(anywhere(random, 1.0) + glm::dvec3(0.0, 0.0, 1.1));
        const glm::dvec3 eye = anywhere(random, 1e5), later = eye + anywhere(random, 100.0);
        const ShadowPlan before = ShadowPlan::of(eye, sun, kReachesM, kTexels);
        const ShadowPlan after = ShadowPlan::of(later, sun, kReachesM, kTexels);
        EXPECT_EQ(before.lightFromWorld, after.lightFromWorld);
        EXPECT_NEAR(glm::length(before.lightFromWorld * sun - glm::dvec3(0.0, 0.0, 1.0)), 0.0, 1e-12);
        EXPECT_NEAR(glm::determinant(before.lightFromWorld), 1.0, 1e-12);
        for (std::size_t m = 0; m < 4; ++m)
        {
            const double texelM = 2.0 * kReachesM[m] / kTexels;
            const glm::dvec2 offM(before.lightFromWorld * eye - before.maps[m].centre);
            EXPECT_LE(std::max(std::abs(offM.x), std::abs(offM.y)), 0.5 * texelM + 1e-9);
            const glm::dvec2 moved((after.maps[m].centre - before.maps[m].centre) / texelM);
            EXPECT_LT(std::max(fromWhole(moved.x), fromWhole(moved.y)), 1e-5);
        }
    }
}

TEST(ShadowPlan, AMapThatFollowedTheEyeWouldNot)
{
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, 0.2, 0.8));
    const glm::dmat3 axes = ShadowPlan::of({}, sun, kReachesM, kTexels).lightFromWorld;
    const glm::dvec2 moved = glm::dvec2(axes * glm::dvec3(0.013, 0.0, 0.0)) / (2.0 * kReachesM[0] / kTexels);
    EXPECT_GT(std::max(fromWhole(moved.x), fromWhole(moved.y)), 1e-2) << "the mutation";
}

TEST(ShadowPlan, WithCellsAMapStaysUntilTheEyeHasPassedOne)
{
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, 0.2, 0.8));
    constexpr double kCellShare = 0.125;
    std::array<int, 4> moves{};
    ShadowPlan before = ShadowPlan::of({}, sun, kReachesM, kTexels, kCellShare);
    for (int i = 1; i <= 400; ++i)
    {
        const glm::dvec3 eye(0.5 * i, 0.1 * i, 0.0); // 204 m
        const ShadowPlan now = ShadowPlan::of(eye, sun, kReachesM, kTexels, kCellShare);
        for (std::size_t m = 0; m < 4; ++m)
        {
            moves[m] += now.maps[m] == before.maps[m] ? 0 : 1;
            const glm::dvec3 offM = glm::abs(now.lightFromWorld * eye - now.maps[m].centre);
            EXPECT_LE(std::max(offM.x, offM.y), kCellShare * kReachesM[m] + 1e-9); // half a cell
        }
        before = now;
    }
    EXPECT_LT(moves[1], 40); // cells of 22.5 m along three axes
    EXPECT_LE(moves[2], 9);  // 100 m
    EXPECT_LE(moves[3], 3);  // 1250 m
    EXPECT_GT(moves[0], 30) << "of 5 m";
}
