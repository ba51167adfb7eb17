// SPDX-License-Identifier: Apache-2.0
// Quantities as people write them into maps. Expected values are worked out by hand from 1 ft = 0.3048 m.
#include <foundation/TagQuantity.h>
#include <gtest/gtest.h>

namespace
{

using foundation::kmhOfTag;
using foundation::metresOfTag;
using foundation::numberOfTag;

struct Case
{
    const char* text;
    double value;
};

TEST(TagQuantity, LengthsAreMetresUnlessAUnitStandsWithThem)
{
    for (const Case& entry : std::initializer_list<Case>{{"22", 22.0},         {" 22 ", 22.0},
                                                         {"22 m", 22.0},       {"22m", 22.0},
                                                         {"22.5", 22.5},       {"22,5", 22.5},
                                                         {"22.5M", 22.5},      {"22 metres", 22.0},
                                                         {"22\u00A0m", 22.0},  {"5 \u043C", 5.0},
                                                         {"+3", 3.0},          {"-3.5", -3.5},
                                                         {".5", 0.5},          {"0.5 km", 500.0},
                                                         {"1,5km", 1500.0},    {"350 cm", 3.5},
                                                         {"250mm", 0.25},      {"1 200 m", 1200.0},
                                                         {"1.234,5", 1234.5},  {"12.500", 12.5},
                                                         {"1,250", 1.25},      {"72 ft", 21.9456},
                                                         {"72ft", 21.9456},    {"72 feet", 21.9456},
                                                         {"72'", 21.9456},     {"72\u2032", 21.9456},
                                                         {"1,250 ft", 381.0},  {"72 ft 2 in", 21.9964},
                                                         {"72'2\"", 21.9964},  {"72' 2\"", 21.9964},
                                                         {"72'-2\"", 21.9964}, {"72\u20192\u201D", 21.9964},
                                                         {"72'2''", 21.9964},  {"72 ft. 2 in.", 21.9964},
                                                         {"72'2", 21.9964},    {"6'", 1.8288},
                                                         {"6\"", 0.1524},      {"6 in", 0.1524},
                                                         {"6'3.5\"", 1.9177},  {"2 mi", 3218.688},
                                                         {"10 yd", 9.144}})
        EXPECT_NEAR(metresOfTag(entry.text).value_or(-1.0), entry.value, 1e-9) << entry.text;
}

TEST(TagQuantity, AboutRangesAndListsHaveOneValue)
{
    for (const Case& entry : std::initializer_list<Case>{{"~22", 22.0},
                                                         {"~ 22 m", 22.0},
                                                         {"ca. 22", 22.0},
                                                         {"ca 22m", 22.0},
                                                         {"c. 20", 20.0},
                                                         {"~.5", 0.5},
                                                         {"approx. 7.5", 7.5},
                                                         {"about 7 m", 7.0},
                                                         {"<5", 5.0},
                                                         {"20-25", 22.5},
                                                         {"20 - 25 m", 22.5},
                                                         {"20\u201325", 22.5},
                                                         {"20..25", 22.5},
                                                         {"20 to 25", 22.5},
                                                         {"3-4 ft", 1.0668},
                                                         {"6'-7'", 1.9812},
                                                         {"20;25", 20.0},
                                                         {"20 m; 25 m", 20.0}})
        EXPECT_NEAR(metresOfTag(entry.text).value_or(-1.0), entry.value, 1e-9) << entry.text;
}

TEST(TagQuantity, WhatSaysSomethingElseIsNone)
{
    for (const char* text : {"",    " ",   "tall",    "m",      "ft",  "22 parsec", "22 m high",  "nan",
                             "inf", "1e3", "0x10",    "20;",    "20-", "5-tall",    "2020-01-01", "1.2.3",
                             "?",   "~",   "default", "22 m 5", "--5", "none",      "6' tall",    "\xFF\xFE"})
        EXPECT_FALSE(metresOfTag(text)) << text;
    EXPECT_FALSE(metresOfTag(std::string(4000, '9')));
    EXPECT_FALSE(metresOfTag(std::string(100000, '~')));
    EXPECT_FALSE(metresOfTag("50 mph"));
    EXPECT_FALSE(kmhOfTag("50 m"));
    EXPECT_FALSE(numberOfTag("3 m"));
}

TEST(TagQuantity, SpeedsAreKilometresAnHourUnlessAUnitStandsWithThem)
{
    for (const Case& entry : std::initializer_list<Case>{{"50", 50.0},
                                                         {"50 km/h", 50.0},
                                                         {"50km/h", 50.0},
                                                         {"50 kmh", 50.0},
                                                         {"50 kph", 50.0},
                                                         {"30 mph", 48.28032},
                                                         {"30mph", 48.28032},
                                                         {"30 MPH", 48.28032},
                                                         {"10 knots", 18.52},
                                                         {"5 kn", 9.26},
                                                         {"50;30", 50.0},
                                                         {"10 m/s", 36.0}})
        EXPECT_NEAR(kmhOfTag(entry.text).value_or(-1.0), entry.value, 1e-9) << entry.text;
}

TEST(TagQuantity, PlainNumbersHaveNoUnit)
{
    EXPECT_EQ(numberOfTag("3"), 3.0);
    EXPECT_EQ(numberOfTag("2.5"), 2.5);
    EXPECT_EQ(numberOfTag("2,5"), 2.5);
    EXPECT_EQ(numberOfTag("2;3"), 2.0);
    EXPECT_EQ(numberOfTag("2-3"), 2.5);
    EXPECT_EQ(numberOfTag("110000"), 110000.0);
    EXPECT_EQ(numberOfTag("110,000"), 110000.0);
    EXPECT_EQ(numberOfTag("380000;110000"), 380000.0);
}

} // namespace
