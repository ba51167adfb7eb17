// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/Expression.h"

#include <cmath>

#include <gtest/gtest.h>

namespace simulation
{
namespace
{

std::optional<std::string> parameters(std::string_view name)
{
    if (name == "speed") return "50";
    if (name == "on") return "true";
    if (name == "word") return "hello";
    return std::nullopt;
}

struct Case
{
    const char* text;
    double value;
};

class ExpressionValue : public testing::TestWithParam<Case>
{
};

TEST_P(ExpressionValue, IsWhatArithmeticSays)
{
    const auto value = evaluateExpression(GetParam().text, parameters);
    ASSERT_TRUE(value) << value.error().what;
    EXPECT_DOUBLE_EQ(*value, GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(Expression, ExpressionValue,
                         testing::Values(Case{"1", 1.0}, Case{"1 + 2 * 3", 7.0}, Case{"(1 + 2) * 3", 9.0},
                                         Case{"10 - 4 - 3", 3.0}, Case{"2 * 3 % 4", 2.0},
                                         Case{"-2 - -3", 1.0}, Case{"1e3 / 4", 250.0}, Case{".5", 0.5},
                                         Case{"$speed/3.6", 50.0 / 3.6}, Case{"pow(2, 10)", 1024.0},
                                         Case{"sqrt(16) + abs(-1)", 5.0}, Case{"round(2.5)", 3.0},
                                         Case{"floor(-0.5)", -1.0}, Case{"ceil(0.2)", 1.0},
                                         Case{"min(1, max(2, 3))", 1.0}, Case{"sign(-9)", -1.0},
                                         Case{"2 * pi", 6.283185307179586}, Case{"cos(pi)", -1.0},
                                         Case{"log(exp(2))", 2.0}, Case{"not true or true and $on", 1.0},
                                         Case{"not (1 and 0)", 1.0}, Case{"false or false", 0.0}));

class ExpressionFault : public testing::TestWithParam<Case>
{
};

TEST_P(ExpressionFault, IsNamedWithItsPlace)
{
    const auto value = evaluateExpression(GetParam().text, parameters);
    ASSERT_FALSE(value);
    EXPECT_NE(value.error().what.find("at character"), std::string::npos) << value.error().what;
}

INSTANTIATE_TEST_SUITE_P(Expression, ExpressionFault,
                         testing::Values(Case{"", 0}, Case{"1 +", 0}, Case{"(1", 0}, Case{"1)", 0},
                                         Case{"1 2", 0}, Case{"$missing", 0}, Case{"$word + 1", 0},
                                         Case{"1 / 0", 0}, Case{"5 % (1 - 1)", 0}, Case{"sqrt(-1)", 0},
                                         Case{"1e308 * 10", 0}, Case{"pow(2)", 0}, Case{"sine(1)", 0},
                                         Case{"1 ; 2", 0}, Case{"1e999", 0}));

TEST(Expression, DeepNestingIsRefused)
{
    const std::string deep = std::string(100'000, '(') + "1" + std::string(100'000, ')');
    EXPECT_FALSE(evaluateExpression(deep, parameters));
    EXPECT_FALSE(evaluateExpression(std::string(100'000, '-') + "1", parameters));
}

TEST(Number, OnlyFiniteNumbersAreRead)
{
    EXPECT_EQ(parseNumber(" +1.5e2 "), 150.0);
    for (const char* text :
         {"", " ", "1x", "nan", "NaN", "inf", "-INF", "1e999", "1,5", "0x10", "+-1", "--1"})
        EXPECT_FALSE(parseNumber(text)) << text;
}

TEST(Number, WrittenTextReadsBackToTheSameBits)
{
    for (const double value : {0.0, -0.1, 1.0 / 3.0, 1e-300, 12345678.9, std::nextafter(46.5, 47.0)})
        EXPECT_EQ(parseNumber(formatNumber(value)), value);
}

} // namespace
} // namespace simulation
