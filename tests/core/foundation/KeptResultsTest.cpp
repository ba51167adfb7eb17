// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <fstream>

#include <foundation/KeptResults.h>
#include <gtest/gtest.h>

namespace foundation
{
namespace
{

namespace fs = std::filesystem;

ContentMark markOfText(std::string_view text)
{
    return ContentMark().add(text);
}

class KeptResultsTest : public testing::Test
{
protected:
    void SetUp() override
    {
        _folder = fs::path(testing::TempDir()) /
                  ("kept_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(_folder);
    }
    void TearDown() override { fs::remove_all(_folder); }

    fs::path onlyFile() const
    {
        EXPECT_EQ(std::distance(fs::directory_iterator(_folder), {}), 1);
        return fs::directory_iterator(_folder)->path();
    }
    static std::string textOf(const fs::path& file)
    {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    static void write(const fs::path& file, const std::string& text)
    {
        std::ofstream(file, std::ios::binary) << text;
    }

    fs::path _folder;
};

TEST_F(KeptResultsTest, FindsWhatWasKept)
{
    const KeptResults kept(_folder);
    EXPECT_FALSE(kept.find("sum", markOfText("1 2")));
    const std::string bytes("3\0\n4", 4);
    kept.keep("sum", markOfText("1 2"), bytes);
    EXPECT_EQ(kept.find("sum", markOfText("1 2")), bytes);
    EXPECT_EQ(KeptResults(_folder).find("sum", markOfText("1 2")), bytes);
}

TEST_F(KeptResultsTest, FindsNothingOfOtherInputsNamesOrPrograms)
{
    const KeptResults kept(_folder, markOfText("program"));
    kept.keep("sum", markOfText("1 2"), "3");
    EXPECT_TRUE(kept.find("sum", markOfText("1 2")));
    EXPECT_FALSE(kept.find("sum", markOfText("1 3")));
    EXPECT_FALSE(kept.find("product", markOfText("1 2")));
    EXPECT_FALSE(KeptResults(_folder, markOfText("another program")).find("sum", markOfText("1 2")));
}

TEST_F(KeptResultsTest, KeepsNothingWithoutAFolderOrAProgram)
{
    KeptResults().keep("sum", markOfText("1 2"), "3");
    EXPECT_FALSE(KeptResults().find("sum", markOfText("1 2")));
    const KeptResults nameless(_folder, std::nullopt);
    nameless.keep("sum", markOfText("1 2"), "3");
    EXPECT_FALSE(nameless.find("sum", markOfText("1 2")));
    EXPECT_FALSE(fs::exists(_folder));
}

TEST_F(KeptResultsTest, EveryDamagedByteAndEveryCutIsNoResult)
{
    const KeptResults kept(_folder);
    kept.keep("sum", markOfText("1 2"), "the sum is 3");
    const fs::path file = onlyFile();
    const std::string whole = textOf(file);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        write(file, damaged);
        EXPECT_FALSE(kept.find("sum", markOfText("1 2"))) << i;
        write(file, whole.substr(0, i));
        EXPECT_FALSE(kept.find("sum", markOfText("1 2"))) << i;
    }
    write(file, whole + "x");
    EXPECT_FALSE(kept.find("sum", markOfText("1 2")));
    kept.keep("sum", markOfText("1 2"), "the sum is 3");
    EXPECT_EQ(kept.find("sum", markOfText("1 2")), "the sum is 3");
    EXPECT_EQ(textOf(onlyFile()), whole);
}

TEST_F(KeptResultsTest, DamageIsToldOnceWithTheFileAndMadeGood)
{
    static std::vector<std::string> told;
    told.clear();
    const KeptResults kept(_folder, markOfText("program"), 4000,
                           [](const std::string& line) { told.push_back(line); });
    const auto sum = [&](const char* wanted)
    {
        const auto read = [&](std::string_view bytes)
        { return bytes == wanted ? std::optional(std::string(bytes)) : std::nullopt; };
        return kept.findOrMake(
            "sum", markOfText("1 2"), read, [&] { return std::string(wanted); },
            [](const std::string& text) { return text; });
    };
    EXPECT_EQ(sum("3"), "3"); // nothing is there yet
    EXPECT_EQ(sum("3"), "3");
    EXPECT_TRUE(told.empty());
    write(onlyFile(), textOf(onlyFile()) + "x");
    EXPECT_EQ(sum("3"), "3");
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told.front().find(onlyFile().string()), std::string::npos) << told.front();
    EXPECT_EQ(sum("3"), "3");
    EXPECT_EQ(told.size(), 1U);
    EXPECT_EQ(sum("three"), "three"); // undamaged, but its reader does not take it
    EXPECT_EQ(told.size(), 2U);
}

TEST_F(KeptResultsTest, WhatIsTooLargeIsNotWrittenOut)
{
    const KeptResults kept(_folder, markOfText("program"), 400);
    std::vector<std::uintmax_t> limits;
    const auto ask = [&](std::size_t size)
    {
        const auto read = [](std::string_view bytes) { return std::optional(std::string(bytes)); };
        const auto write = [&](const std::string& text, std::uintmax_t mostBytes)
        {
            limits.push_back(mostBytes);
            return text.size() > mostBytes ? std::nullopt : std::optional(text);
        };
        return kept
            .findOrMake(
                "word", markOfText(std::to_string(size)), read, [&] { return std::string(size, 'x'); }, write)
            .size();
    };
    EXPECT_EQ(ask(101), 101U);
    EXPECT_FALSE(fs::exists(_folder));
    EXPECT_EQ(ask(100), 100U);
    EXPECT_EQ(ask(100), 100U); // found
    EXPECT_EQ(limits, (std::vector<std::uintmax_t>{100, 100}));
    EXPECT_EQ(fs::file_size(onlyFile()), 100U + 18U + 33U);
}

TEST_F(KeptResultsTest, WhatCannotBeWrittenIsNotKept)
{
    write(_folder, "a file where the folder would be");
    const KeptResults kept(_folder);
    kept.keep("sum", markOfText("1 2"), "3");
    EXPECT_FALSE(kept.find("sum", markOfText("1 2")));
}

TEST_F(KeptResultsTest, RemovesWhatWasNotAskedForTheLongestTime)
{
    const KeptResults kept(_folder, markOfText("program"), 4000);
    const std::string bytes(900, 'x');
    const auto now = fs::file_time_type::clock::now();
    int age = 10;
    for (const char* name : {"first", "second", "third", "fourth"})
    {
        kept.keep(name, markOfText(""), bytes);
        for (const auto& entry : fs::directory_iterator(_folder))
            if (entry.path().filename().string().starts_with(name))
                fs::last_write_time(entry.path(), now - std::chrono::hours(age--));
    }
    EXPECT_TRUE(kept.find("first", markOfText(""))); // which makes the second the oldest
    kept.keep("fifth", markOfText(""), bytes);
    EXPECT_TRUE(kept.find("first", markOfText("")));
    EXPECT_FALSE(kept.find("second", markOfText("")));
    EXPECT_TRUE(kept.find("third", markOfText("")));
    kept.keep("too large", markOfText(""), std::string(1100, 'x'));
    EXPECT_FALSE(kept.find("too large", markOfText("")));
}

TEST(ContentMark, TellsContentsAndTheirBordersApart)
{
    EXPECT_EQ(markOfText("abcdefghij"), markOfText("abcdefghij"));
    EXPECT_NE(markOfText("abcdefghij"), markOfText("abcdefghik"));
    EXPECT_NE(markOfText("abcdefgh"), markOfText(std::string_view("abcdefgh\0", 9)));
    EXPECT_NE(ContentMark().add("ab").add("c"), ContentMark().add("a").add("bc"));
    EXPECT_NE(ContentMark().add("a").add("b"), ContentMark().add("b").add("a"));
    EXPECT_EQ(ContentMark().text().size(), 32U);
}

TEST(ProgramMark, IsThatOfTheRunningProgramEachTime)
{
    const auto mark = ProgramMark::ofThis();
    ASSERT_TRUE(mark);
    EXPECT_EQ(mark, ProgramMark::ofThis());
    EXPECT_NE(*mark, ContentMark());
}

} // namespace
} // namespace foundation
