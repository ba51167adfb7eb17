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

} // namespace
