// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/cover/CoverTable.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testing::HasSubstr;

constexpr const char* kTable = R"(# my classes
40 = crop
111-142 = urban   # a range
-1 = water
7 = dry_grass
)";

std::string messageOf(const std::string& text)
{
    const auto table = parseCoverTable(text, "classes.txt");
    return table ? "" : table.error().message();
}

} // namespace

TEST(CoverTable, HasLinesOfCodesAndRanges)
{
    const auto table = parseCoverTable(kTable, "classes.txt");
    ASSERT_TRUE(table) << table.error().message();
    EXPECT_EQ(table->size(), 35u);
    EXPECT_EQ(table->at(40), GroundKind::crop);
    EXPECT_EQ(table->at(111), GroundKind::urban);
    EXPECT_EQ(table->at(142), GroundKind::urban);
    EXPECT_EQ(table->at(-1), GroundKind::water);
    EXPECT_FALSE(table->contains(143));
}

TEST(CoverTable, ErrorsNameFileAndLine)
{
    EXPECT_THAT(messageOf("1 = crop\n2 = castle\n"),
                HasSubstr("classes.txt:2: unknown kind 'castle'; known kinds: unknown, rock"));
    EXPECT_THAT(messageOf("one = crop\n"), HasSubstr("classes.txt:1: not of the form CODE = KIND"));
    EXPECT_THAT(messageOf("1 crop\n"), HasSubstr("classes.txt:1: not of the form"));
    EXPECT_THAT(messageOf("9-3 = crop\n"), HasSubstr("classes.txt:1: not of the form"));
    EXPECT_THAT(messageOf("1-999999 = crop\n"), HasSubstr("classes.txt:1: not of the form"));
    EXPECT_THAT(messageOf("1-5 = crop\n5 = rock\n"),
                HasSubstr("classes.txt:2: code 5 stands here a second time"));
    EXPECT_THAT(messageOf("# nothing\n"), HasSubstr("names no class"));
    EXPECT_THAT(readCoverTable("/none/classes.txt").error().message(), HasSubstr("give worldcover, corine"));
}

TEST(CoverTable, KnowsTheClassesOfTwoProducts)
{
    EXPECT_EQ(readCoverTable("")->at(10), GroundKind::forest);
    EXPECT_EQ(readCoverTable("worldcover")->at(80), GroundKind::water);
    const auto corine = readCoverTable("corine");
    EXPECT_EQ(corine->size(), 88u);
    EXPECT_EQ(corine->at(1), corine->at(111));
    EXPECT_EQ(corine->at(44), GroundKind::water);
    EXPECT_EQ(corine->at(523), GroundKind::water);
    EXPECT_EQ(corine->at(23), corine->at(311));
}

TEST(CoverTable, ATextDamagedAtRandomIsReadOrRefusedWithItsPlace)
{
    testsupport::Random random(31);
    int refused = 0, read = 0;
    for (int round = 0; round < 20000; ++round)
    {
        std::string text = kTable;
        for (std::uint32_t change = 0; change <= random.below(3); ++change)
        {
            const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
            if (random.below(2))
                text[at] = static_cast<char>(random.below(256));
            else
                text.erase(at, 1 + random.below(6));
            if (text.empty()) text = "x";
        }
        const auto table = parseCoverTable(text, "classes.txt");
        ++(table ? read : refused);
        if (table) continue;
        EXPECT_THAT(table.error().place, testing::StartsWith("classes.txt"));
    }
    EXPECT_GT(refused, 2000);
    EXPECT_GT(read, 2000);
}
