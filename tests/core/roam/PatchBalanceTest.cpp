// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/PatchBalance.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kExponents[] = {0, 2, 4, 6};

/// A machine that takes 1 ms for 10 000 adapted leaves and for so many drawn triangles.
double modelledMs(int exponent, double trianglesPerMs)
{
    const double triangles = 60000.0 * (1.0 + 0.4 * exponent);
    const double leaves = triangles / (1 << exponent);
    return leaves / 10000.0 + triangles / trianglesPerMs;
}

} // namespace

TEST(PatchBalance, GivesAFastCardLargePatchesAndASlowOneNone)
{
    const auto exponentFor = [](double trianglesPerMs) {
        return measurePatchBalance(kExponents, 8, [=](int k) { return modelledMs(k, trianglesPerMs); })
            .exponent;
    };
    EXPECT_EQ(exponentFor(5000.0), 0);
    EXPECT_EQ(exponentFor(20000.0), 2);
    EXPECT_EQ(exponentFor(1e9), 6);
}

TEST(PatchBalance, IsNotMisledByOutliersOrFirstFrames)
{
    testsupport::Random random(3);
    std::map<int, int> asked;
    const auto balance =
        measurePatchBalance(kExponents, 40,
                            [&](int k)
                            {
                                const bool isFirst = asked[k]++ % 5 == 0;
                                const double outlier = random.below(5) == 0 ? 50.0 : 0.0;
                                return modelledMs(k, 20000.0) + outlier + (isFirst ? 100.0 : 0.0);
                            });
    EXPECT_EQ(balance.exponent, 2);
    ASSERT_EQ(balance.rows.size(), 4u);
    EXPECT_NEAR(balance.rows[1].medianMs, modelledMs(2, 20000.0), 1e-9);
}

TEST(PatchBalance, PrefersTheSmallerOfEqualOnes)
{
    EXPECT_EQ(measurePatchBalance(kExponents, 4, [](int k) { return 10.0 - 0.02 * k; }).exponent, 0);
}
