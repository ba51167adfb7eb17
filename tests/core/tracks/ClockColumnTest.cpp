// SPDX-License-Identifier: Apache-2.0
// Times as 101530 in tables are clocks where something says so; else they are seconds, which is told.
#include "simulation/track/ClockColumn.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

constexpr double kDayS = 86'400.0, kApril17S = 1'618'617'600.0; ///< 2021-04-17

/// A table of three fixes by the names of its columns before the place, and their cells.
foundation::Result<TrackReading> readTable(const std::string& names, const std::vector<std::string>& cells)
{
    std::string text = names + ",latitude,longitude,height\n";
    for (std::size_t i = 0; i < cells.size(); ++i)
        text += cells[i] + ",46.5" + std::to_string(i) + ",8.25,300\n";
    return parseTrackTable(text, "f.csv");
}

struct ClockTable
{
    const char* names;
    std::vector<std::string> cells;
    std::vector<double> timesS;
    const char* note = ""; ///< a part of the only one
};

class ClockTables : public testing::TestWithParam<ClockTable>
{
};

TEST_P(ClockTables, GiveTimesAndTellDoubts)
{
    const auto reading = readTable(GetParam().names, GetParam().cells);
    ASSERT_TRUE(reading) << reading.error().message();
    const auto& fixes = reading->tracks.at(0).fixes;
    ASSERT_EQ(fixes.size(), GetParam().timesS.size());
    for (std::size_t i = 0; i < fixes.size(); ++i)
        EXPECT_NEAR(fixes[i].timeS, GetParam().timesS[i], 1e-6) << i;
    const std::string note = GetParam().note;
    ASSERT_EQ(reading->notes.size(), note.empty() ? 0U : 1U);
    for (const TrackProblem& told : reading->notes)
        EXPECT_NE(told.what.find(note), std::string::npos) << told.what;
}

INSTANTIATE_TEST_SUITE_P(
    Table, ClockTables,
    testing::Values(
        // NMEA's digits, and a minute that ends between them
        ClockTable{"utc_time", {"101559.20", "101600.20", "101601.20"}, {36959.2, 36960.2, 36961.2}},
        // a day that ends
        ClockTable{"UTC", {"235958", "235959", "000000"}, {86398.0, 86399.0, kDayS}},
        // Columbus: a column of dates; and a date of digits alone
        ClockTable{"DATE,TIME",
                   {"20210417,235958", "20210417,235959", "20210418,000001"},
                   {kApril17S + 86398.0, kApril17S + 86399.0, kApril17S + kDayS + 1.0}},
        ClockTable{"date,time",
                   {"17.04.2021,101530", "17.04.2021,101531", "17.04.2021,101532"},
                   {kApril17S + 36930.0, kApril17S + 36931.0, kApril17S + 36932.0}},
        // a number that begins with 0 is no count of seconds
        ClockTable{"time", {"081530", "081531", "081600"}, {29730.0, 29731.0, 29760.0}},
        // zeros that a spreadsheet took off, below a name that says all
        ClockTable{"time (hhmmss)", {"95958", "95959", "100000"}, {35998.0, 35999.0, 36000.0}},
        ClockTable{"hhmmss", {"1", "59", "101"}, {1.0, 59.0, 61.0}},
        // a date that does not say which number is the year
        ClockTable{"date,time",
                   {"170421,101530", "170421,101531", "170421,101532"},
                   {36930.0, 36931.0, 36932.0},
                   "170421"},
        // seconds, though they look like clocks
        ClockTable{"time", {"101530", "101531", "101532"}, {101530.0, 101531.0, 101532.0}, "hhmmss"},
        // seconds, for a minute has no 60th to 99th
        ClockTable{"utc", {"101559", "101560", "101561"}, {101559.0, 101560.0, 101561.0}},
        ClockTable{"utc", {"0", "1", "2"}, {0.0, 1.0, 2.0}},
        ClockTable{"time_utc",
                   {"1618648760", "1618648761", "1618648762"},
                   {1618648760.0, 1618648761.0, 1618648762.0}},
        ClockTable{"utc_ms", {"101530", "101531", "101532"}, {101.530, 101.531, 101.532}}));

TEST(ClockColumn, DigitsOfAClockAreSecondsOfTheDay)
{
    EXPECT_EQ(secondsOfClockDigits("235960"), 86'400.0); // a second that is added
    EXPECT_NEAR(secondsOfClockDigits(" 000000,5 ").value_or(-1.0), 0.5, 1e-12);
    EXPECT_EQ(secondsOfClockDigits("101530."), 36'930.0);
    for (const char* none :
         {"", "240000", "236000", "235961", "1234567", "-10000", "1e5", "10:15", "101530.2.1", "101530.2Z"})
        EXPECT_FALSE(secondsOfClockDigits(none)) << none;
}

} // namespace
} // namespace simulation
