// SPDX-License-Identifier: Apache-2.0
#include "foundation/Fnv1a.h"

#include <gtest/gtest.h>

namespace foundation
{
namespace
{

std::uint64_t hashOf(std::string_view bytes, std::uint64_t seed = 0)
{
    Fnv1a hash(seed);
    hash.add(bytes);
    return hash.value();
}

/// Values of the authors' own test vectors (draft-eastlake-fnv, appendix C).
TEST(Fnv1a, IsThePublishedHash)
{
    EXPECT_EQ(hashOf(""), 0xcbf29ce484222325u);
    EXPECT_EQ(hashOf("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a, IsWrittenWithAllItsDigits)
{
    Fnv1a hash;
    hash.add("a");
    EXPECT_EQ(hash.text(), "af63dc4c8601ec8c");
}

TEST(Fnv1a, TakesANumberByItsBytesTheLowestFirst)
{
    Fnv1a number;
    number.addNumber(0x6261, 2);
    EXPECT_EQ(number.value(), hashOf("ab"));
}

TEST(Fnv1a, IsAnotherWithAnotherSeed)
{
    EXPECT_NE(hashOf("a", 1), hashOf("a"));
    EXPECT_EQ(hashOf("", 5), 0xcbf29ce484222325u ^ 5u);
}

} // namespace
} // namespace foundation
