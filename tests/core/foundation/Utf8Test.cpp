// SPDX-License-Identifier: Apache-2.0
#include <foundation/Utf8.h>
#include <gtest/gtest.h>

namespace
{

/// A text in code units of `bytes` bytes.
std::string wide(std::u32string_view text, std::size_t bytes, bool isBigEndian)
{
    std::string result;
    for (const char32_t letter : text)
        for (std::size_t i = 0; i < bytes; ++i)
            result += static_cast<char>(letter >> (8 * (isBigEndian ? bytes - 1 - i : i)) & 0xFFU);
    return result;
}

TEST(Utf8, WideTextsAreConvertedWithAndWithoutAMark)
{
    const std::u32string text = U"<a name=\"K\u00f6ln \u20ac\"/>\r\n";
    const std::string expected = "<a name=\"K\xC3\xB6ln \xE2\x82\xAC\"/>\r\n";
    for (const std::size_t bytes : {2U, 4U})
        for (const bool isBigEndian : {false, true})
            for (const std::u32string& mark : {std::u32string(), std::u32string(U"\ufeff")})
            {
                const std::string bytesOfIt = wide(mark + text, bytes, isBigEndian);
                const auto encoding = foundation::wideEncodingOf(bytesOfIt);
                ASSERT_TRUE(encoding) << bytes << isBigEndian;
                EXPECT_EQ(foundation::toUtf8(bytesOfIt, *encoding), expected) << *encoding;
            }
}

TEST(Utf8, LongTextsAreConvertedWhole)
{
    const std::u32string text = U"<" + std::u32string(100'000, U'\u20ac');
    const auto converted = foundation::toUtf8(wide(text, 2, false), "UTF-16LE");
    ASSERT_TRUE(converted);
    EXPECT_EQ(converted->size(), 1U + 3U * 100'000U);
}

TEST(Utf8, PlainTextsAreNotWide)
{
    for (const char* const text : {"<?xml version=\"1.0\"?>", "\xEF\xBB\xBF<a/>", "", "<"})
        EXPECT_FALSE(foundation::wideEncodingOf(text)) << text;
}

TEST(Utf8, BrokenOnesAreRefused)
{
    EXPECT_FALSE(foundation::toUtf8(std::string("\xFF\xFE<", 3), "UTF-16"));          // half a unit
    EXPECT_FALSE(foundation::toUtf8(wide(U"<a", 2, false) + "\x3C\xD8", "UTF-16LE")); // half a pair
    EXPECT_FALSE(foundation::toUtf8(wide(U"<\x110000", 4, true), "UTF-32BE"));        // beyond Unicode
    EXPECT_FALSE(foundation::toUtf8("<a/>", "no such encoding"));
}

TEST(Utf8, StrayBytesAreTakenAsWindows1252AndCounted)
{
    const std::string text = "a \xC3\xB6 b\n\xF6 \x80 \xE2\x82\xAC\xC3";
    const auto read = foundation::Utf8Text::of(text, {}, "f");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->in(text), "a \xC3\xB6 b\n\xC3\xB6 \xE2\x82\xAC \xE2\x82\xAC\xC3\x83");
    EXPECT_EQ(read->strayBytes(), 3u);
    EXPECT_EQ(read->strayLine(), 2);
    const std::string sound = "\xEF\xBB\xBF\xF0\x9F\x9A\x97";
    EXPECT_EQ(foundation::Utf8Text::of(sound, "ISO-8859-1", "f")->in(sound), "\xF0\x9F\x9A\x97");
    // No surrogates, nothing longer than it must be, nothing beyond Unicode.
    for (const std::string bad : {"\xED\xA0\x80", "\xC0\xAF", "\xE0\x80\xAF", "\xF4\x90\x80\x80", "\xFF"})
        EXPECT_EQ(foundation::utf8Length(bad, 0), 0u);
}

TEST(Utf8, WhatCallsItselfAsciiIsReadAsUtf8)
{
    const std::string text = "na\xC3\xAFve";
    for (const char* encoding : {"US-ASCII", "ascii", "UTF-8"})
    {
        const auto read = foundation::Utf8Text::of(text, encoding, "t.xml");
        ASSERT_TRUE(read) << encoding;
        EXPECT_EQ(read->in(text), text) << encoding;
        EXPECT_EQ(read->strayBytes(), 0u);
    }
    const std::string latin = "na\xEFve";
    const auto read = foundation::Utf8Text::of(latin, "US-ASCII", "t.xml");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->in(latin), text);
    EXPECT_EQ(read->strayBytes(), 1u);
}

TEST(Utf8, ABeginningCutsNoCharacter)
{
    EXPECT_EQ(foundation::utf8Beginning("a\xE2\x82\xAC", 3), "a");
    EXPECT_EQ(foundation::utf8Beginning("a\xE2\x82\xAC", 4), "a\xE2\x82\xAC");
}

TEST(Utf8, TheEncodingOfXmlIsThatOfItsDeclaration)
{
    EXPECT_EQ(foundation::xmlEncodingOf("<?xml version=\"1.0\" encoding='ISO-8859-15' ?><a/>"),
              "ISO-8859-15");
    EXPECT_EQ(foundation::xmlEncodingOf("<?xml version=\"1.0\"?><a encoding=\"x\"/>"), "");
    EXPECT_EQ(foundation::xmlEncodingOf("<?xml encoding=\"UTF-8//IGNORE\"?>"), "");
    EXPECT_EQ(foundation::xmlEncodingOf(""), "");
}

} // namespace
