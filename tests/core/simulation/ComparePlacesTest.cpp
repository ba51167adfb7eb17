// SPDX-License-Identifier: Apache-2.0
// Two runs along one way, compared place by place, and the columns that a debrief reads.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include <foundation/CsvCells.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "simulation/record/CompareMotions.h"
#include "simulation/record/MotionLog.h"

namespace simulation
{
namespace
{

/// A run of `rows` rows, a second apart. `at`: the sample of a row.
MotionTable run(int rows, const std::function<MotionSample(double)>& at, const std::string& entity = "Ego")
{
    MotionTable table;
    table.tracks.push_back({entity, {}});
    for (int row = 0; row < rows; ++row)
    {
        table.timeS.push_back(row);
        table.tracks.front().samples.emplace_back(at(row));
    }
    return table;
}

MotionSample sample(const glm::dvec3& position, double speedMps, std::optional<double> rollRad = 0.0)
{
    MotionSample made;
    made.position = position;
    made.speedMps = speedMps;
    made.rollRad = rollRad;
    return made;
}

/// Straight on at 10 m/s, 100 m long.
MotionTable straight()
{
    return run(11, [](double s) { return sample({10.0 * s, 0.0, 5.0}, 10.0); });
}

TEST(ComparePlaces, OfARunWithItselfAreAllTheSame)
{
    const auto same = comparePlaces(straight(), straight());
    ASSERT_EQ(same.size(), 1u);
    EXPECT_DOUBLE_EQ(same[0].wayM, 100.0);
    EXPECT_DOUBLE_EQ(same[0].coveredM, 100.0);
    EXPECT_EQ(same[0].places, 11u);
    EXPECT_EQ(same[0].beyondRows, 0u);
    EXPECT_EQ(same[0].besideM.largest, 0.0);
    EXPECT_EQ(same[0].timeS.largest, 0.0);
}

TEST(ComparePlaces, CountToTheLeftUpwardsAndRightSideDown)
{
    const auto found = comparePlaces(run(11,
                                         [](double s) {
                                             return sample({10.0 * s, 2.0, 5.5}, 10.0, 0.1);
                                         }),
                                     straight());
    EXPECT_DOUBLE_EQ(found[0].besideM.largest, 2.0);
    EXPECT_DOUBLE_EQ(found[0].besideM.rms, 2.0);
    EXPECT_DOUBLE_EQ(found[0].heightM.largest, 0.5);
    ASSERT_TRUE(found[0].bankDeg);
    EXPECT_NEAR(found[0].bankDeg->largest, 18.0 / std::numbers::pi, 1e-9);
    const auto right = comparePlaces(run(11,
                                         [](double s) {
                                             return sample({10.0 * s, -2.0, 5.0}, 10.0);
                                         }),
                                     straight());
    EXPECT_DOUBLE_EQ(right[0].besideM.largest, -2.0);
}

/// By time the two are 50 m apart in the end; by place they differ in time and speed alone.
TEST(ComparePlaces, OfASlowerRunDifferInTimeAndSpeed)
{
    const auto found = comparePlaces(run(11,
                                         [](double s) {
                                             return sample({5.0 * s, 0.0, 5.0}, 5.0);
                                         }),
                                     straight());
    EXPECT_EQ(found[0].besideM.largest, 0.0);
    EXPECT_DOUBLE_EQ(found[0].speedMps.largest, -5.0);
    EXPECT_DOUBLE_EQ(found[0].timeS.largest, 5.0);
    EXPECT_DOUBLE_EQ(found[0].timeS.largestAtM, 50.0);
    EXPECT_DOUBLE_EQ(found[0].coveredM, 50.0);
    EXPECT_DOUBLE_EQ(compareMotions(run(11,
                                        [](double s) {
                                            return sample({5.0 * s, 0.0, 5.0}, 5.0);
                                        }),
                                    straight())[0]
                         .positionM.largest,
                     50.0);
}

TEST(ComparePlaces, BeyondTheEndsAreNotCompared)
{
    const auto found = comparePlaces(run(15,
                                         [](double s) {
                                             return sample({10.0 * s - 20.0, 1.0, 5.0}, 10.0);
                                         }),
                                     straight());
    EXPECT_EQ(found[0].beyondRows, 4u); // two before the begin, two after the end
    EXPECT_EQ(found[0].places, 11u);
    EXPECT_DOUBLE_EQ(found[0].timeS.largest, 2.0);
}

/// Two rounds of a circle of 100 m: each place of the way is near one of the other round, and its end is
/// where it begins.
TEST(ComparePlaces, FollowAWayThatComesBack)
{
    const auto round = [](double radiusM)
    {
        return run(126,
                   [radiusM](double s) {
                       return sample({radiusM * std::cos(0.1 * s), radiusM * std::sin(0.1 * s), 0.0}, 10.0);
                   });
    };
    const auto found = comparePlaces(round(97.0), round(100.0));
    EXPECT_EQ(found[0].beyondRows, 0u);
    EXPECT_NEAR(found[0].coveredM, found[0].wayM, 1.0);
    EXPECT_NEAR(found[0].besideM.largest, 3.0, 0.15); // to the left is inwards
    EXPECT_LT(std::fabs(found[0].timeS.largest), 0.6) << "not a round of 63 s";
}

TEST(ComparePlaces, OfWhatStandsOrIsNotInBothAreLeftOut)
{
    EXPECT_TRUE(comparePlaces(straight(), run(5, [](double) { return sample({1, 2, 3}, 0.0); })).empty());
    EXPECT_TRUE(comparePlaces(run(
                                  5,
                                  [](double s) {
                                      return sample({s, 0, 0}, 1.0);
                                  },
                                  "Van"),
                              straight())
                    .empty());
    // One that waits at the begin is there once.
    const auto waits = comparePlaces(run(21,
                                         [](double s) {
                                             return sample({10.0 * std::max(0.0, s - 10.0), 0.0, 5.0}, 10.0);
                                         }),
                                     straight());
    EXPECT_EQ(waits[0].places, 11u);
    EXPECT_DOUBLE_EQ(waits[0].timeS.largest, 10.0);
}

TEST(ComparePlaces, OfOldTablesLackTheBank)
{
    const auto old = run(11, [](double s) { return sample({10.0 * s, 0.0, 5.0}, 10.0, std::nullopt); });
    EXPECT_FALSE(comparePlaces(old, straight())[0].bankDeg);
    EXPECT_FALSE(comparePlaces(straight(), old)[0].bankDeg);
    const std::string text = differencesText(compareMotions(old, straight()), compareEvents(old, straight()),
                                             comparePlaces(old, straight()), {});
    EXPECT_NE(text.find("\"bank_deg\": null"), std::string::npos) << text;
    EXPECT_NE(text.find("\"beside_m\""), std::string::npos);
}

/// Writes one step of two entities and returns the lines of the table.
std::vector<std::string> logged(const std::vector<EntityState>& states)
{
    const auto file = std::filesystem::temp_directory_path() / ("log-" + std::to_string(getpid()) + ".csv");
    Scenario scenario;
    for (const EntityState& state : states)
    {
        ScenarioObject object;
        object.name = state.name;
        scenario.entities.push_back(object);
    }
    {
        MotionLog log(file, scenario, "test");
        log.add(0.0, states);
        EXPECT_TRUE(log.finish());
    }
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    std::filesystem::remove(file);
    return lines;
}

/// The cell of the row beneath a column.
std::string cellOf(const std::vector<std::string>& lines, const std::string& column)
{
    std::string_view header = lines.at(3), row = lines.at(4);
    const auto names = foundation::takeCsvRecord(header, ',').cells,
               values = foundation::takeCsvRecord(row, ',').cells;
    EXPECT_EQ(names.size(), values.size());
    const auto found = std::find(names.begin(), names.end(), column);
    return found == names.end() ? "no such column"
                                : values.at(static_cast<std::size_t>(found - names.begin()));
}

TEST(MotionLog, TellsBankAirspeedsConditionRoadAndControls)
{
    EntityState aircraft;
    aircraft.name = "ownship";
    aircraft.rollDeg = -180.0 / std::numbers::pi;
    aircraft.readings.emplace();
    aircraft.readings->trueAirspeedMps = 61.5;
    aircraft.readings->calibratedAirspeedMps = 57.25;
    aircraft.readings->condition = "crashed";
    aircraft.readings->controls[0] = -0.5;
    EntityState car;
    car.name = "car";
    car.laneUnder.emplace();
    car.laneUnder->s = 12.0;
    car.laneUnder->lane = -1;
    car.roadUnder = "A7, north";
    car.readings.emplace();
    car.readings->gear = -1;
    const auto lines = logged({aircraft, car});
    EXPECT_EQ(cellOf(lines, "#1 World_Roll_Angle [rad]"), "-1.000000");
    EXPECT_EQ(cellOf(lines, "#1 True_Airspeed [m/s]"), "61.500000");
    EXPECT_EQ(cellOf(lines, "#1 Calibrated_Airspeed [m/s]"), "57.250000");
    EXPECT_EQ(cellOf(lines, "#1 Condition"), "crashed");
    EXPECT_EQ(cellOf(lines, "#1 Input_elevator [-]"), "-0.500000");
    EXPECT_EQ(cellOf(lines, "#1 Input_steering [-]"), "");
    EXPECT_EQ(cellOf(lines, "#1 Engaged_Gear [-]"), "") << "an aircraft has none";
    EXPECT_EQ(cellOf(lines, "#2 Engaged_Gear [-]"), "-1");
    EXPECT_NE(lines.at(4).find("\"A7, north\""), std::string::npos) << lines.at(4);
    std::string text;
    for (const std::string& line : lines)
        text += line + '\n';
    const auto read = parseMotionTable(text, "t.csv");
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->tracks.size(), 2u);
    EXPECT_EQ(read->tracks[0].samples[0]->rollRad, -1.0);
    EXPECT_EQ(read->tracks[1].entity, "car");
    EXPECT_EQ(read->tracks[1].samples[0]->lane, -1);
}

} // namespace
} // namespace simulation
