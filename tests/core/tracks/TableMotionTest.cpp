// SPDX-License-Identifier: Apache-2.0
// Columns of speed and attitude in tables of positions.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "simulation/scenario/Trajectory.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackTrajectory.h"

namespace simulation
{
namespace
{

constexpr double kDegreesPerMetre = 1.0 / 111'194.9;

/// Six places 20 m apart, eastwards on the equator: `heads` names further columns, whose cells are `cells`.
/// `stepS`: 0 leaves the times out.
std::string eastwards(const std::string& heads, const std::string& cells, double stepS)
{
    std::string text = std::string(stepS > 0.0 ? "time," : "") + "lat,lon,alt," + heads + "\n";
    for (int i = 0; i < 6; ++i)
    {
        char row[120];
        if (stepS > 0.0) text += std::to_string(stepS * i) + ",";
        std::snprintf(row, sizeof row, "0,%.9f,100,", 20.0 * i * kDegreesPerMetre);
        text += row + cells + "\n";
    }
    return text;
}

TrackReading readTable(const std::string& text)
{
    auto reading = parseTrackTable(text, "t.csv");
    EXPECT_TRUE(reading) << reading.error().message();
    return reading ? *reading : TrackReading{};
}

struct SpeedColumn
{
    const char *name, *head, *cell;
    double mps;
};

class TableSpeeds : public testing::TestWithParam<SpeedColumn>
{
};

TEST_P(TableSpeeds, GiveAWayWithoutTimesItsTimes)
{
    const TrackReading reading = readTable(eastwards(GetParam().head, GetParam().cell, 0.0));
    ASSERT_EQ(reading.tracks.size(), 1u);
    const FlightTrack& track = reading.tracks[0];
    ASSERT_EQ(track.hasTimes, GetParam().mps > 0.0);
    EXPECT_EQ(reading.notes.size(), track.hasTimes ? 1u : 0u);
    if (!track.hasTimes) return;
    EXPECT_NEAR(track.fixes[5].timeS, 100.0 / GetParam().mps, 1e-3 * track.fixes[5].timeS);
}

INSTANTIATE_TEST_SUITE_P(
    Units, TableSpeeds,
    testing::Values(
        SpeedColumn{"bare", "speed", "10", 10.0}, SpeedColumn{"metres", "speed (m/s)", "10", 10.0},
        SpeedColumn{"kilometres", "Speed (km/h)", "36", 10.0}, SpeedColumn{"kmh", "speed_kmh", "36", 10.0},
        SpeedColumn{"mph", "speed(mph)", "22.369363", 10.0},
        SpeedColumn{"knots", "Ground Speed [kt]", "19.438445", 10.0},
        SpeedColumn{"feet", "velocity ft/s", "32.8084", 10.0},
        SpeedColumn{"centimetres", "gps_speed_cm/s", "1000", 10.0},
        SpeedColumn{"unitInTheCell", "speed", "36 km/h", 10.0},
        SpeedColumn{"German", "Geschwindigkeit", "10", 10.0}, SpeedColumn{"letter", "v", "10", 10.0},
        SpeedColumn{"wind", "wind speed", "10", 0.0}, SpeedColumn{"vertical", "vertical_speed", "10", 0.0},
        SpeedColumn{"most", "max_speed", "10", 0.0}, SpeedColumn{"air", "airspeed", "10", 0.0},
        SpeedColumn{"standing", "speed", "0", 0.0}, SpeedColumn{"noNumber", "speed", "fast", 0.0}),
    [](const auto& of) { return of.param.name; });

TEST(TableSpeeds, AnotherUnitThanTheWayHasIsTold)
{
    const auto notes = [](const char* head, const char* cell)
    { return readTable(eastwards(head, cell, 2.0)).notes; };
    EXPECT_TRUE(notes("speed (m/s)", "10").empty());
    EXPECT_TRUE(notes("speed", "36").empty()) << "km/h, which the name may mean";
    EXPECT_TRUE(notes("speed (kt)", "19").empty());
    ASSERT_EQ(notes("speed (m/s)", "36").size(), 1u);
    EXPECT_NE(notes("speed (m/s)", "36")[0].what.find("0.278 times"), std::string::npos);
    EXPECT_EQ(notes("speed", "90000").size(), 1u) << "no unit has such a speed: the times may be wrong";
}

struct AngleColumns
{
    const char *name, *heads, *cells;
    double yawDeg; ///< below -900: no attitude
    double pitchDeg = 0.0, rollDeg = 0.0;
    std::size_t notes = 0;
};

class TableAngles : public testing::TestWithParam<AngleColumns>
{
};

TEST_P(TableAngles, AreReadWhereTheyAreThoseOfABody)
{
    const TrackReading reading = readTable(eastwards(GetParam().heads, GetParam().cells, 2.0));
    ASSERT_EQ(reading.tracks.size(), 1u);
    EXPECT_EQ(reading.notes.size(), GetParam().notes);
    for (const TrackFix& fix : reading.tracks[0].fixes)
    {
        ASSERT_EQ(fix.attitude.has_value(), GetParam().yawDeg > -900.0);
        if (!fix.attitude) continue;
        EXPECT_NEAR(fix.attitude->yawDeg, GetParam().yawDeg, 1e-6);
        EXPECT_NEAR(fix.attitude->pitchDeg.value_or(0.0), GetParam().pitchDeg, 1e-6);
        EXPECT_NEAR(fix.attitude->rollDeg.value_or(0.0), GetParam().rollDeg, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Table, TableAngles,
    testing::Values(
        AngleColumns{"yaw", "yaw", "80", 80.0},
        AngleColumns{"all", "heading,pitch,roll", "85,5,-20", 85.0, 5.0, -20.0},
        AngleColumns{"ofDrones", "OSD.yaw [360],OSD.pitch,OSD.roll", "95,-3,2", 95.0, -3.0, 2.0},
        AngleColumns{"degrees", "pitch(degrees),roll(degrees),compass_heading(degrees)", "1,2,91", 91.0, 1.0,
                     2.0, 1},
        AngleColumns{"radians", "yaw_rad,pitch_rad,roll_rad", "1.5707963267948966,0.1,0.2", 90.0, 5.729577951,
                     11.459155903},
        AngleColumns{"radiansUnsaid", "yaw,pitch", "1.6,0.1", 91.673247221, 5.729577951, 0.0, 1},
        AngleColumns{"trueBeforeMagnetic", "hding__mag,hding_true,bank", "70,88,9", 88.0, 0.0, 9.0},
        AngleColumns{"course", "course", "90", -1000.0},
        AngleColumns{"headingAlone", "heading", "91", -1000.0},
        AngleColumns{"headingElsewhere", "heading", "0", -1000.0, 0.0, 0.0, 1},
        AngleColumns{"yawElsewhere", "yaw,pitch,roll", "200,0,0", -1000.0, 0.0, 0.0, 1},
        AngleColumns{"gimbal", "gimbal_heading(degrees),gimbal_pitch(degrees)", "90,-45", -1000.0},
        AngleColumns{"rates", "yaw_rate,pitch_rate", "90,1", -1000.0},
        AngleColumns{"empty", "yaw,pitch", ",", -1000.0}),
    [](const auto& of) { return of.param.name; });

TEST(TableAngles, SingleCellsThatAreEmptyHaveTheOneBefore)
{
    std::string text = "time,lat,lon,yaw,roll\n";
    for (const char* cells : {",3", "90,4", "91,", "x,6", "93,7", "94,8"})
    {
        const double i = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
        text += std::to_string(i) + ",0," + std::to_string(i * 1e-3) + "," + cells + "\n";
    }
    const TrackReading reading = readTable(text);
    ASSERT_EQ(reading.tracks.size(), 1u);
    const auto& fixes = reading.tracks[0].fixes;
    const double yaws[] = {90, 90, 91, 91, 93, 94}, rolls[] = {4, 4, 4, 4, 7, 8};
    for (std::size_t i = 0; i < 6; ++i)
    {
        ASSERT_TRUE(fixes[i].attitude && fixes[i].attitude->rollDeg) << i;
        EXPECT_EQ(fixes[i].attitude->yawDeg, yaws[i]) << i;
        EXPECT_EQ(*fixes[i].attitude->rollDeg, rolls[i]) << i;
    }
    EXPECT_EQ(reading.notes.size(), 2u);
}

TEST(TableAngles, TurnTheBodyAndLeaveTheRestToTheWay)
{
    const TrackReading reading = readTable(eastwards("yaw", "80", 2.0));
    const auto follow = trajectoryOf(reading.tracks.at(0));
    ASSERT_TRUE(follow);
    const auto& line = std::get<Polyline>(follow->trajectory.shape);
    const Orientation& pose = std::get<GeoPosition>(line.vertices.at(0).position).orientation;
    EXPECT_NEAR(pose.headingRad.value_or(9.0), 10.0 / 57.29577951308232, 1e-9);
    EXPECT_FALSE(pose.pitchRad);
    EXPECT_FALSE(pose.rollRad) << "an aircraft banks by its way";
    // The control: a direction of the way turns nothing.
    const auto other = trajectoryOf(readTable(eastwards("course", "80", 2.0)).tracks.at(0));
    ASSERT_TRUE(other);
    const auto& plain = std::get<Polyline>(other->trajectory.shape);
    EXPECT_FALSE(std::get<GeoPosition>(plain.vertices.at(0).position).orientation.headingRad);
}

} // namespace
} // namespace simulation
