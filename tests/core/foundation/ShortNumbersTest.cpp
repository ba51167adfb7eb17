// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>
#include <utility>

#include <foundation/ShortNumbers.h>
#include <gtest/gtest.h>

namespace foundation
{
namespace
{

TEST(ShortNumbers, ComeBackInAsFewBytesAsTheyNeed)
{
    const std::pair<std::uint32_t, std::size_t> sizes[] = {
        {0, 1},         {127, 1},     {128, 2},     {16383, 2},
        {16384, 3},     {2097151, 3}, {2097152, 4}, {(1U << 28U) - 1, 4},
        {1U << 28U, 5}, {~0U, 5}};
    std::string all;
    for (const auto& [number, size] : sizes)
    {
        std::string bytes;
        appendShort(bytes, number);
        EXPECT_EQ(bytes.size(), size) << number;
        all += bytes;
    }
    ShortTaker taker(all);
    for (const auto& [number, size] : sizes)
    {
        std::uint32_t taken = 0;
        ASSERT_TRUE(taker.take(taken));
        EXPECT_EQ(taken, number);
    }
    EXPECT_TRUE(taker.isEmpty());
}

TEST(ShortNumbers, CutOrEndlessOnesAreNone)
{
    std::string bytes;
    appendShort(bytes, 1U << 28U);
    std::uint32_t number = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(ShortTaker(std::string_view(bytes).substr(0, size)).take(number)) << size;
    EXPECT_TRUE(ShortTaker(bytes).take(number));
    EXPECT_FALSE(ShortTaker(std::string(9, '\x80')).take(number));
}

TEST(ShortNumbers, FoldDifferencesOnBothSidesOfNothing)
{
    const std::pair<std::int32_t, std::uint32_t> folds[] = {{0, 0}, {-1, 1}, {1, 2}, {-2, 3}, {2, 4}};
    for (const auto& [difference, folded] : folds)
        EXPECT_EQ(foldedDifference(static_cast<std::uint32_t>(difference)), folded) << difference;
    for (const std::uint32_t any : {0U, 1U, 77U, 0x7fffffffU, 0x80000000U, ~0U})
        EXPECT_EQ(unfoldedDifference(foldedDifference(any)), any);
}

} // namespace
} // namespace foundation
