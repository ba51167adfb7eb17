// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <random>

#include <foundation/Random.h>
#include <gtest/gtest.h>

using foundation::SplitMix64;

/// The first numbers of the authors' reference implementation for the seed 1234567.
TEST(SplitMix64, GivesTheNumbersOfTheReference)
{
    SplitMix64 bits(1234567);
    for (const std::uint64_t expected :
         {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL, 4593380528125082431ULL,
          16408922859458223821ULL})
        EXPECT_EQ(bits(), expected);
}

TEST(SplitMix64, FeedsTheStandardsDistributions)
{
    static_assert(std::uniform_random_bit_generator<SplitMix64>);
    SplitMix64 bits(1);
    double sum = 0.0;
    for (int i = 0; i < 10000; ++i)
        sum += std::uniform_real_distribution(0.0, 1.0)(bits);
    EXPECT_NEAR(sum / 10000.0, 0.5, 0.02);
}

TEST(MixedBits, AnotherBitChangesHalfOfTheAnswer)
{
    EXPECT_EQ(foundation::mixedBits(0), 0U);
    int changed = 0;
    for (std::uint64_t number = 1; number <= 1000; ++number)
        for (int bit = 0; bit < 64; ++bit)
            changed += std::popcount(foundation::mixedBits(number) ^
                                     foundation::mixedBits(number ^ (std::uint64_t{1} << bit)));
    EXPECT_NEAR(changed / 64000.0, 32.0, 0.2);
}
