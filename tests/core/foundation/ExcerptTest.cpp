// SPDX-License-Identifier: Apache-2.0
#include <foundation/Excerpt.h>
#include <gtest/gtest.h>

using foundation::excerpt;

TEST(Excerpt, LeavesShortTextsAsTheyAre)
{
    EXPECT_EQ(excerpt(""), "");
    EXPECT_EQ(excerpt("unknown key 'height'"), "unknown key 'height'");
    EXPECT_EQ(excerpt("123456", 6), "123456");
}

TEST(Excerpt, ShowsBeginningAndEndOfLongTexts)
{
    EXPECT_EQ(excerpt("aaaaaabbbbbbccc", 9), "aaaaaa … (6 bytes left out) … ccc");
    EXPECT_LT(excerpt(std::string(26000, 'x')).size(), 400U);
}

TEST(Excerpt, CutsNoCharacterInTwo)
{
    std::string umlauts;
    for (int i = 0; i < 20; ++i)
        umlauts += "ä";
    for (std::size_t most = 6; most < 14; ++most)
    {
        const std::string text = excerpt(umlauts, most);
        std::size_t letters = 0;
        for (std::size_t at = text.find("ä"); at != std::string::npos; at = text.find("ä", at + 2))
            ++letters;
        const std::string marks = " … ( bytes left out) … ";
        const std::string left = std::to_string(umlauts.size() - 2 * letters);
        EXPECT_EQ(text.size(), 2 * letters + marks.size() + left.size()) << text;
    }
}
