// SPDX-License-Identifier: Apache-2.0
#include <foundation/SmallLetters.h>
#include <gtest/gtest.h>

namespace foundation
{
namespace
{

TEST(SmallLetters, AreThoseOfAsciiAlone)
{
    EXPECT_EQ(inSmallLetters("ABCXYZ abc [@`{] 09"), "abcxyz abc [@`{] 09");
    EXPECT_EQ(inSmallLetters("Höhe ÄÖÜ"), "höhe ÄÖÜ") << "bytes beyond ASCII stay, whatever the locale is";
    EXPECT_EQ(inSmallLetters(""), "");
}

} // namespace
} // namespace foundation
