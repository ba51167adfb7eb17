// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <foundation/PlainBytes.h>
#include <gtest/gtest.h>

namespace foundation
{
namespace
{

TEST(PlainBytes, ComeBackInTheirOrder)
{
    std::string bytes;
    appendValue(bytes, 2.5);
    appendValues(bytes, std::vector<int>{1, -2, 3});
    appendText(bytes, "oak");
    appendText(bytes, "");
    ValueTaker taker(bytes);
    double number = 0.0;
    std::vector<int> numbers;
    std::string text, none = "some";
    ASSERT_TRUE(taker.take(number) && taker.take(numbers) && taker.take(text) && taker.take(none));
    EXPECT_EQ(number, 2.5);
    EXPECT_EQ(numbers, (std::vector<int>{1, -2, 3}));
    EXPECT_EQ(text, "oak");
    EXPECT_EQ(none, "");
    EXPECT_TRUE(taker.isEmpty());
    EXPECT_FALSE(taker.take(number));
}

TEST(PlainBytes, CountsBeyondTheEndTakeNoMemory)
{
    std::string bytes;
    appendValue(bytes, ~std::uint64_t{0} / 2);
    bytes += "12345678";
    std::vector<double> numbers;
    std::string text;
    std::uint64_t count = 0;
    EXPECT_FALSE(ValueTaker(bytes).take(numbers));
    EXPECT_FALSE(ValueTaker(bytes).take(text));
    EXPECT_FALSE(ValueTaker(bytes).takeCount(count, 1));
    std::string two;
    appendValue(two, std::uint64_t{2});
    two += "12345678";
    EXPECT_TRUE(ValueTaker(two).takeCount(count, 4));
    EXPECT_FALSE(ValueTaker(two).takeCount(count, 5));
}

} // namespace
} // namespace foundation
