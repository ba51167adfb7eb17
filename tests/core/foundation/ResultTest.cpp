// SPDX-License-Identifier: Apache-2.0
#include <foundation/Result.h>
#include <gtest/gtest.h>

namespace
{

using foundation::Error;
using foundation::Result;

TEST(Result, HoldsAValueOrTheReasonWhyNot)
{
    const Result<int> good(7);
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 7);
    const Result<int> bad(Error{"dem.tif", "has three bands", "give a single-band raster"});
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().message(), "dem.tif: has three bands; give a single-band raster");
}

TEST(Result, AnErrorWithoutRemedyEndsAfterWhatWasFound)
{
    EXPECT_EQ((Error{"x", "is broken", ""}.message()), "x: is broken");
}

} // namespace
