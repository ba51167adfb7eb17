// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTraversal/EyeSharing>

namespace
{

using namespace osgTraversal;

TEST(EyeSharing, RoundingIsLessThanTheToleranceAndTheDistanceOfAPairOfEyesIsMore)
{
    constexpr double kPairOfEyesM = 0.063;
    for (const double distanceM : {1.0, 100.0, 20.0e3, 200.0e3})
        for (const double reachM : {1.0, 50.0e3})
        {
            const double tolerance = sameEyeToleranceM(glm::dvec3(0.0, distanceM, 0.0), reachM);
            EXPECT_GT(tolerance, 1e-12 * (distanceM + reachM)) << distanceM << ' ' << reachM;
            EXPECT_LT(tolerance, 0.01 * kPairOfEyesM) << distanceM << ' ' << reachM;
        }
}

TEST(EyeSharing, AGroupIsKeptForThirtyFramesWithoutACamera)
{
    EXPECT_FALSE(isUnused(5, 5 + kUnusedFrames));
    EXPECT_TRUE(isUnused(5, 6 + kUnusedFrames));
    EXPECT_FALSE(isUnused(100, 3)) << "frames may be counted anew";
}

} // namespace
