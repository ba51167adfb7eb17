// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "simulation/record/CompareMotions.h"

namespace simulation
{
namespace
{

const std::string kHeader =
    "Some words\nIndex [-], TimeStamp [s], #1 Entity_Name [-], #1 Current_Speed [m/s], "
    "#1 World_Position_X [m], #1 World_Position_Y [m], #1 World_Position_Z [m], "
    "#1 World_Heading_Angle [rad], #2 Entity_Name [-],#2 Current_Speed [m/s], \n";

/// Two entities; the second one leaves after the first row. `north`: of the first in the second row.
std::string tableText(const std::string& north)
{
    return kHeader + "0, 0.0, Ego, 10, 1, 2, 3, 0.1, Van, 0, 5, 5, 5, 3.1, \n" + "10, 0.1, Ego, 10, 2, " +
           north + ", 3, 6.28, \n";
}

MotionTable table(const std::string& text)
{
    const foundation::Result<MotionTable> read = parseMotionTable(text, "t.csv");
    EXPECT_TRUE(read) << read.error().message();
    return read ? *read : MotionTable{};
}

TEST(MotionTable, RowsAreReadByTheNamesOfTheFirstEntitysColumns)
{
    const MotionTable read = table(tableText("2"));
    ASSERT_EQ(read.timeS.size(), 2u);
    ASSERT_EQ(read.tracks.size(), 2u);
    EXPECT_EQ(read.tracks[1].entity, "Van");
    EXPECT_EQ(read.tracks[1].samples[0]->position, glm::dvec3(5.0));
    EXPECT_FALSE(read.tracks[1].samples[1]);
    EXPECT_EQ(read.find("Ego")->samples[1]->headingRad, 6.28);
    EXPECT_EQ(read.find("Bus"), nullptr);
}

TEST(MotionTable, MistakesAreOneLineWithTheirPlace)
{
    const auto errorOf = [](const std::string& text)
    {
        const foundation::Result<MotionTable> read = parseMotionTable(text, "t.csv");
        return read ? std::string() : read.error().message();
    };
    EXPECT_EQ(errorOf("no table\n"), "t.csv: no line begins with Index; give a table of --csv_logger");
    EXPECT_EQ(errorOf(tableText("far")), "t.csv:4: \"far\" is not a finite number; correct the cell");
    EXPECT_EQ(errorOf("Index, Time, #1 Entity_Name\n"),
              "t.csv:1: there is no column Current_Speed; give a table of --csv_logger");
    EXPECT_EQ(errorOf(kHeader + "0, 1, Ego, 1, 1\n"), "t.csv:3: the row ends early; complete it");
    EXPECT_EQ(errorOf(tableText("2") + "11, 0.05, Ego, 10, 2, 2, 3, 0, \n"),
              "t.csv:5: the time falls; sort the rows");
}

TEST(CompareMotions, FindsTheLargestDifferenceAndWhen)
{
    const MotionTable reference = table(tableText("2"));
    const auto same = compareMotions(reference, reference);
    ASSERT_EQ(same.size(), 2u);
    EXPECT_EQ(same[0].positionM.largest, 0.0);
    EXPECT_TRUE(isWithin(same[0], {0.0, 0.0}));

    const auto moved = compareMotions(table(tableText("2.06")), reference);
    EXPECT_NEAR(moved[0].positionM.largest, 0.06, 1e-12);
    EXPECT_EQ(moved[0].positionM.largestAtS, 0.1);
    EXPECT_NEAR(moved[0].positionM.rms, 0.06 / std::sqrt(2.0), 1e-12);
    EXPECT_FALSE(isWithin(moved[0], {}));
    EXPECT_TRUE(isWithin(moved[1], {}));
}

TEST(CompareMotions, ARowThatIsMissingIsADifference)
{
    const MotionTable reference = table(tableText("2"));
    const MotionTable shorter = table(kHeader + "0, 0.0, Ego, 10, 1, 2, 3, 0.1, \n");
    const auto found = compareMotions(shorter, reference);
    EXPECT_EQ(found[0].unmatchedRows, 1u);
    EXPECT_EQ(found[1].unmatchedRows, 1u);
    EXPECT_FALSE(isWithin(found[0], {}));
    EXPECT_NE(differencesText(found, compareEvents(shorter, reference), {}, {}).find("\"within\": false"),
              std::string::npos);
}

/// Rows of a tenth of a second: a lane from each digit of `lanes`, a speed from each number, a collision
/// where `touches` has an x.
std::string eventTable(const std::string& lanes, const std::vector<double>& speeds,
                       const std::string& touches)
{
    std::string text =
        "Index, Time, #1 Entity_Name, #1 Current_Speed, #1 World_Position_X, #1 World_Position_Y, "
        "#1 World_Position_Z, #1 World_Heading_Angle, #1 lane_id, #1 collision_ids, \n";
    for (std::size_t i = 0; i < lanes.size(); ++i)
        text += std::to_string(i) + ", " + std::to_string(0.1 * static_cast<double>(i)) + ", Ego, " +
                std::to_string(speeds[i]) + ", 0, 0, 0, 0, " + lanes[i] + ", " +
                (touches[i] == 'x' ? "1 " : "") + ", \n";
    return text;
}

TEST(CompareEvents, MatchesLaneChangesCollisionsAndKinks)
{
    // From 1 m/s² to −2 m/s² at 0.4 s; the lane changes at 0.5 s, the collision begins at 0.6 s.
    const std::vector<double> speeds{10.0, 10.1, 10.2, 10.3, 10.4, 10.2, 10.0, 9.8, 9.6};
    const MotionTable reference = table(eventTable("111112222", speeds, "      xx "));
    const auto same = compareEvents(reference, reference).front();
    EXPECT_EQ(same.laneChanges.count, 1u);
    EXPECT_EQ(same.collisions.count, 1u);
    EXPECT_EQ(same.speedKinks.count, 1u);
    EXPECT_TRUE(isWithin(same, 0.0));
    const std::vector<double> later{10.0, 10.1, 10.2, 10.3, 10.4, 10.5, 10.3, 10.1, 9.9};
    const auto moved = compareEvents(table(eventTable("111111122", later, "    xx   ")), reference).front();
    EXPECT_NEAR(moved.laneChanges.largestS, 0.2, 1e-9);
    EXPECT_NEAR(moved.collisions.largestS, 0.2, 1e-9);
    EXPECT_NEAR(moved.speedKinks.largestS, 0.1, 1e-9);
    EXPECT_FALSE(isWithin(moved, 0.1 + 1e-6));
    const auto other = compareEvents(table(eventTable("111113333", speeds, "         ")), reference).front();
    EXPECT_EQ(other.laneChanges.unmatched, 2u) << "to another lane: one missing, one too many";
    EXPECT_EQ(other.collisions.unmatched, 1u);
}

} // namespace
} // namespace simulation
