// SPDX-License-Identifier: Apache-2.0
#include "view/PictureQuality.h"

#include <gtest/gtest.h>

namespace
{

using trainer::PictureQuality;
using trainer::Quality;

/// Adds so many pictures; returns how often the tolerance changed.
int add(PictureQuality& quality, int pictures, double ms)
{
    int changes = 0;
    for (int i = 0; i < pictures; ++i)
        changes += quality.add(ms) ? 1 : 0;
    return changes;
}

TEST(PictureQuality, GrowsCoarserWhilePicturesAreSlowAndFinerAgain)
{
    PictureQuality quality(1.0);
    EXPECT_EQ(add(quality, 1, 5000.0), 0); // the first is always slow
    EXPECT_EQ(add(quality, 9, 90.0), 0);
    EXPECT_EQ(add(quality, 1, 90.0), 1);
    EXPECT_EQ(quality.tolerancePx(), 1.5);
    add(quality, 200, 200.0);
    EXPECT_EQ(quality.tolerancePx(), 4.0); // and no coarser
    EXPECT_EQ(add(quality, 100, 60.0), 0) << "between quick and slow it stays";
    add(quality, 200, 10.0);
    EXPECT_EQ(quality.tolerancePx(), 1.0); // and no finer than asked for
}

TEST(PictureQuality, TakesOneSlowPictureForWhatItIs)
{
    PictureQuality quality(2.0);
    add(quality, 1, 0.0);
    for (int i = 0; i < 50; ++i)
    {
        add(quality, 9, 50.0);
        add(quality, 1, 300.0);
    }
    EXPECT_EQ(quality.tolerancePx(), 2.0);
}

TEST(PictureQuality, LeavesOutDetailBeforeTheGroundGetsCoarser)
{
    PictureQuality quality(1.0, true, Quality::high, true);
    add(quality, 1, 0.0);
    add(quality, 5, 200.0);
    EXPECT_EQ(quality.quality(), Quality::medium);
    EXPECT_EQ(quality.tolerancePx(), 1.0);
    add(quality, 6, 200.0);
    EXPECT_EQ(quality.quality(), Quality::low);
    add(quality, 6, 200.0);
    EXPECT_EQ(quality.tolerancePx(), 1.5);
    add(quality, 22, 20.0);
    EXPECT_EQ(quality.tolerancePx(), 1.0);
    EXPECT_EQ(quality.quality(), Quality::medium);
    EXPECT_EQ(add(quality, 100, 35.0), 0) << "quick enough for this quality, not for the next";
}

TEST(PictureQuality, DoesNotWaitForTenPicturesWhereThreeAreTooSlow)
{
    PictureQuality quality(1.0, true, Quality::high, true);
    add(quality, 1, 3000.0);
    EXPECT_EQ(add(quality, 2, 400.0), 0);
    EXPECT_EQ(add(quality, 1, 400.0), 1);
    EXPECT_EQ(quality.quality(), Quality::medium);
    EXPECT_EQ(add(quality, 1, 3000.0), 0) << "it compiles shaders";
    EXPECT_EQ(add(quality, 3, 200.0), 0);
    EXPECT_EQ(quality.quality(), Quality::medium);
}

TEST(PictureQuality, BeginsCoarseAndGrowsFinerWherePicturesAreQuick)
{
    PictureQuality quality(1.0, true, Quality::high, true);
    quality.beginCoarse();
    EXPECT_EQ(quality.quality(), Quality::low);
    EXPECT_EQ(quality.tolerancePx(), 4.0);
    EXPECT_EQ(add(quality, 100, 60.0), 0);
    add(quality, 400, 10.0);
    EXPECT_EQ(quality.quality(), Quality::high);
    EXPECT_EQ(quality.tolerancePx(), 1.0);
}

TEST(PictureQuality, KeepsWhatWasAskedFor)
{
    PictureQuality quality(1.0, false, Quality::high, false);
    quality.beginCoarse();
    EXPECT_EQ(add(quality, 200, 500.0) + add(quality, 200, 5.0), 0);
    EXPECT_EQ(quality.quality(), Quality::high);
}

} // namespace
