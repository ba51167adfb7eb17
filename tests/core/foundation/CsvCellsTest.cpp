// SPDX-License-Identifier: Apache-2.0
#include <foundation/CsvCells.h>
#include <gtest/gtest.h>

namespace
{

using foundation::csvCell;
using foundation::takeCsvRecord;
using Cells = std::vector<std::string>;

Cells cellsOf(std::string_view text, char mark = ',')
{
    return takeCsvRecord(text, mark).cells;
}

TEST(CsvCells, MarksAndQuotesBetweenQuotesArePartOfTheCell)
{
    EXPECT_EQ(cellsOf("a, b ,\"c, d\",,\n"), (Cells{"a", "b", "c, d", "", ""}));
    EXPECT_EQ(cellsOf("\"say \"\"hi\"\"\", \"\" ,\"\"\"\""), (Cells{"say \"hi\"", "", "\""}));
    EXPECT_EQ(cellsOf("1;\"2;3\";4,5\r\n", ';'), (Cells{"1", "2;3", "4,5"}));
    EXPECT_EQ(cellsOf("a\t\tb", '\t'), (Cells{"a", "", "b"}));
    EXPECT_EQ(cellsOf("5\" gun, b"), (Cells{"5\" gun", "b"}));
    EXPECT_EQ(cellsOf(""), (Cells{""}));
}

TEST(CsvCells, ARecordMayHaveEndsOfLinesInQuotesAndTellsThem)
{
    std::string_view text = "\"a\nb\",c\nd,e\n";
    const auto first = takeCsvRecord(text, ',');
    EXPECT_EQ(first.cells, (Cells{"a\nb", "c"}));
    EXPECT_EQ(first.lines, 2);
    EXPECT_EQ(cellsOf(text), (Cells{"d", "e"}));
}

TEST(CsvCells, AReturnAloneEndsALineAndOneBeforeAnotherEndIsABlank)
{
    std::string_view text = "a,b\rc,d\r\ne,f\r\r\ng\r";
    for (const Cells& cells : {Cells{"a", "b"}, Cells{"c", "d"}, Cells{"e", "f"}, Cells{"g"}})
        EXPECT_EQ(takeCsvRecord(text, ',').cells, cells);
    EXPECT_TRUE(text.empty());
}

TEST(CsvCells, AQuoteThatIsNeverClosedTakesNoOtherLine)
{
    std::string_view text = "\"a,b\nc,d\n";
    EXPECT_EQ(takeCsvRecord(text, ',').cells, (Cells{"\"a", "b"}));
    EXPECT_EQ(cellsOf(text), (Cells{"c", "d"}));
}

TEST(CsvCells, WhatIsWrittenIsReadAgain)
{
    for (const char* const text :
         {"plain", "red, small", "say \"hi\"", " blanks ", "two\nlines", "", "Straße €"})
        EXPECT_EQ(cellsOf("x," + csvCell(text) + ",y"), (Cells{"x", text, "y"})) << text;
    EXPECT_EQ(csvCell("plain name"), "plain name");
}

} // namespace
