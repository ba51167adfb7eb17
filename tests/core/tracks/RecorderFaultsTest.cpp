// SPDX-License-Identifier: Apache-2.0
// What recorders do: clocks that are wrong, days that end, gaps, tables of every form, files inside archives.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "simulation/player/ScenarioPlayer.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TimeText.h"
#include "simulation/track/TrackGaps.h"
#include "simulation/track/TrackTimes.h"
#include "simulation/track/TrackTrajectory.h"

namespace simulation
{
namespace
{

using Times = std::vector<double>;

struct Clock
{
    const char* name;
    Times written, kept;
    bool isReversed = false;
};

class Clocks : public testing::TestWithParam<Clock>
{
};

TEST_P(Clocks, OneBadTimeDropsOneFix)
{
    std::vector<TrackFix> fixes;
    for (const double timeS : GetParam().written)
        fixes.push_back({timeS, 46.0, 8.0, {}, static_cast<int>(fixes.size()) + 1});
    const TimeOrder order = orderInTime(fixes, {});
    Times kept;
    for (const TrackFix& fix : fixes)
        kept.push_back(fix.timeS);
    EXPECT_EQ(kept, GetParam().kept);
    EXPECT_EQ(order.dropped.size(), GetParam().written.size() - kept.size());
    EXPECT_EQ(order.isReversed, GetParam().isReversed);
}

INSTANTIATE_TEST_SUITE_P(
    Table, Clocks,
    testing::Values(
        Clock{"sound", {1, 2, 3}, {1, 2, 3}}, Clock{"lateFirst", {900, 1, 2, 3}, {1, 2, 3}},
        Clock{"lateInTheMiddle", {1, 2, 900, 3, 4}, {1, 2, 3, 4}},
        Clock{"earlyInTheMiddle", {101, 102, 3, 104}, {101, 102, 104}},
        Clock{"setBackAtTheEnd", {1, 2, 3, 4, 0}, {1, 2, 3, 4}},
        Clock{"twoLate", {1, 800, 900, 2, 3, 4}, {1, 2, 3, 4}}, Clock{"twice", {1, 2, 2, 2, 3}, {1, 2, 3}},
        Clock{"unsetFirst", {3.2e8, 1.77e9, 1.77e9 + 1, 1.77e9 + 2}, {1.77e9, 1.77e9 + 1, 1.77e9 + 2}},
        Clock{"unsetLast", {1.77e9, 1.77e9 + 1, 1.77e9 + 2, 4e9}, {1.77e9, 1.77e9 + 1, 1.77e9 + 2}},
        Clock{"backwards", {5, 4, 3, 2}, {2, 3, 4, 5}, true},
        Clock{"backwardsWithOneBad", {5, 4, 900, 3, 2}, {2, 3, 4, 5}, true}, Clock{"one", {7}, {7}},
        Clock{"none", {}, {}}),
    [](const testing::TestParamInfo<Clock>& test) { return test.param.name; });

TEST(ClockFaults, WhatIsDroppedNamesTheFixThatContradictsIt)
{
    std::vector<TrackFix> fixes{
        {900, 46, 8, {}, 11}, {1, 46, 8, {}, 12}, {2, 46, 8, {}, 13}, {2, 46, 8, {}, 14}};
    const TimeOrder order = orderInTime(fixes, {});
    ASSERT_EQ(order.dropped.size(), 2u);
    EXPECT_EQ(order.dropped[0].line, 11);
    EXPECT_EQ(order.dropped[0].what, "the time is not earlier than that of line 12, which follows");
    EXPECT_EQ(order.dropped[1].what, "the time is not later than that of line 13");
}

Times withDays(const Times& written)
{
    std::vector<TrackFix> fixes;
    for (const double timeS : written)
        fixes.push_back({timeS, 46.0, 8.0, {}, 1});
    addDays(fixes);
    Times times;
    for (const TrackFix& fix : fixes)
        times.push_back(fix.timeS);
    return times;
}

TEST(Days, EndAtMidnightAndNotAtAWrongTime)
{
    EXPECT_EQ(withDays({86390, 86395, 0, 10}), (Times{86390, 86395, 86400, 86410}));
    EXPECT_EQ(withDays({86390, 1}), (Times{86390, 86401}));
    EXPECT_EQ(withDays({86398, 86399, 1, 2, 86399, 86399.5, 1}),
              (Times{86398, 86399, 86401, 86402, 172799, 172799.5, 172801}));
    EXPECT_EQ(withDays({72000, 0, 72002, 72003}), (Times{72000, 0, 72002, 72003}));
    EXPECT_EQ(withDays({36000, 86399, 36002, 36003}), (Times{36000, 86399, 36002, 36003}));
    EXPECT_EQ(withDays({86399, 36001, 36002}), (Times{86399, 36001, 36002})) << "a late first fix";
}

TEST(TimeText, IsReadAsRecordersWriteIt)
{
    const double at = 1618648760.0; // 2021-04-17T08:39:20Z
    for (const char* const text :
         {"2021-04-17T08:39:20Z", "2021-04-17 08:39:20", "2021-04-17T10:39:20+02:00",
          "2021-04-17T10:39:20+0200", "2021-04-17T10:39:20+02", "2021-04-17T03:39:20-05:00",
          "2021/04/17 08:39:20", "2021-04-17t08:39:20z", "17.04.2021 08:39:20", "04/17/2021 8:39:20 AM",
          "17/04/2021 08:39:20", "2021-04-17 08:39:20 UTC", "2021-04-17 10:39:20 +02:00",
          " 2021-4-17 08:39:20 ", "2021-04-17T08:39:20,000Z"})
        EXPECT_NEAR(unixSeconds(text).value_or(0.0), at, 1e-3) << text;
    EXPECT_NEAR(unixSeconds("2021-04-17T08:39:20.25Z").value_or(0.0), at + 0.25, 1e-3);
    for (const char* const text : {"0000-04-17T08:39:20Z", "2021-13-17T08:39:20Z", "2021-04-17", "08:39:20",
                                   "", "2021-04-17T99:00:00", "2021-02-30 08:00:00", "T", "x"})
        EXPECT_FALSE(unixSeconds(text)) << text;
    EXPECT_EQ(secondsOfDay("11:59:50.5 pm"), 86390.5);
    EXPECT_EQ(secondsOfDay("12:00:00 AM"), 0.0);
    EXPECT_FALSE(secondsOfDay("11:99:50"));
    EXPECT_FALSE(secondsOfDay("11:59:+5"));
}

struct TableForm
{
    const char* name;
    const char* text;
    double secondsLong, firstM, lastLatitudeDeg;
    HeightDatum datum = HeightDatum::meanSeaLevel;
};

class TableForms : public testing::TestWithParam<TableForm>
{
};

TEST_P(TableForms, AreReadInTheirForm)
{
    const auto reading = parseTrackTable(GetParam().text, "f.csv");
    ASSERT_TRUE(reading) << reading.error().message();
    ASSERT_EQ(reading->tracks.size(), 1u);
    EXPECT_EQ(reading->problemCount, 0u) << reading->problems.front().what;
    const auto& fixes = reading->tracks[0].fixes;
    EXPECT_NEAR(fixes.back().timeS - fixes.front().timeS, GetParam().secondsLong, 1e-6);
    EXPECT_NEAR(fixes.front().heightM.value_or(-1.0), GetParam().firstM, 1e-3);
    EXPECT_NEAR(fixes.back().latitudeDeg, GetParam().lastLatitudeDeg, 1e-9);
    EXPECT_EQ(reading->tracks[0].datum, GetParam().datum);
}

INSTANTIATE_TEST_SUITE_P(
    Table, TableForms,
    testing::Values(
        TableForm{"decimalCommas", "time;lat;lon;alt\n0,5;48,25;9,5;500,5\n1;48,5;9,5;510\n", 0.5, 500.5,
                  48.5},
        TableForm{"decimalCommasInQuotes",
                  "time,lat,lon,alt\n\"0,0\",\"48,25\",\"9,5\",\"500,25\"\n2,\"48,5\",\"9,5\",500\n", 2.0,
                  500.25, 48.5},
        TableForm{"groupsOfThree", "time,lat,lon,alt\n0,48.25,9.5,\"1,640\"\n1,48.5,9.5,\"1,640.5\"\n", 1.0,
                  1640.0, 48.5},
        TableForm{"pointsPartGroups", "time;lat;lon;alt\n0;48,25;9,5;1.640,5\n1;48,5;9,5;1.640\n", 1.0,
                  1640.5, 48.5},
        TableForm{"feetInTheCell",
                  "time,lat,lon,alt,name\n0,48.25,9.5,\"1,640.42 ft\",\"a, b\"\n3,48.5,9.5,500 m,c\n", 3.0,
                  500.0, 48.5},
        TableForm{"hemispheres", "time,lat,lon\n0,48.25N,9.5E\n1,S 48.5,9.5\xC2\xB0 W\n", 1.0, -1.0, -48.5},
        TableForm{"separatorOfExcel", "sep=;\ntime;lat;lon\n0;48,25;9,5\n1;48,5;9,5\n", 1.0, -1.0, 48.5},
        TableForm{"milliseconds", "time_ms,lat,lon\n0,48.25,9.5\n2000,48.5,9.5\n", 2.0, -1.0, 48.5},
        TableForm{"millisecondsOfDrones",
                  "time(millisecond),datetime(utc),latitude,longitude,height_above_takeoff(feet),"
                  "height_above_ground_at_drone_location(feet),ground_elevation_at_drone_location(feet),"
                  "altitude_above_seaLevel(feet)\n0,2021-04-17 08:39:20,48.25,9.5,0,0,1000,1640.42\n"
                  "500,2021-04-17 08:39:20,48.5,9.5,0,0,1000,1640.42\n",
                  0.5, 500.0, 48.5},
        TableForm{"microsecondsSince1970",
                  "timestamp,lat,lon\n1618648760000000,48.25,9.5\n1618648760500000,48.5,9.5\n", 0.5, -1.0,
                  48.5},
        TableForm{"nightAndDay", "time,lat,lon\n23:59:59.5,48.25,9.5\n00:00:01,48.5,9.5\n", 1.5, -1.0, 48.5},
        TableForm{"dateOfItsOwn",
                  "date,time,lat,lon\n2021-04-17,23:59:59,48.25,9.5\n2021-04-18,00:00:01,48.5,9.5\n", 2.0,
                  -1.0, 48.5},
        TableForm{"barometerAndGeometry",
                  "time,icao24,lat,lon,baroaltitude,geoaltitude\n0,3c,48.25,9.5,480,530\n"
                  "1,3c,48.5,9.5,480,530\n",
                  1.0, 530.0, 48.5, HeightDatum::ellipsoid},
        TableForm{"barometerAlone",
                  "time,lat,lon,baro_altitude,vertical_rate\n0,48.25,9.5,480,1\n1,48.5,9.5,480,1\n", 1.0,
                  480.0, 48.5, HeightDatum::pressure},
        TableForm{"aboveGround", "time,lat,lon,altitudeAgl\n0,48.25,9.5,30\n1,48.5,9.5,30\n", 1.0, 30.0, 48.5,
                  HeightDatum::ground}),
    [](const testing::TestParamInfo<TableForm>& test) { return test.param.name; });

const std::string kAt = "<when>2021-04-17T08:39:";

std::string multiTrack(const std::string& mode, const std::string& track)
{
    return "<kml xmlns:gx='g'><Placemark><gx:MultiTrack>" + mode + "<gx:Track>" + track +
           "</gx:Track></gx:MultiTrack></Placemark></kml>";
}

TEST(KmlTracks, AMultiTrackPassesItsModeToItsTracks)
{
    const std::string fix = kAt + "20Z</when><gx:coord>8 46 500</gx:coord>";
    const auto datumOf = [&](const std::string& outer, const std::string& inner)
    {
        const auto reading = parseKml(multiTrack(outer, inner + fix), "f");
        EXPECT_TRUE(reading);
        return reading ? reading->tracks[0].fixes[0].datum : std::nullopt;
    };
    const std::string absolute = "<altitudeMode>absolute</altitudeMode>",
                      relative = "<altitudeMode>relativeToGround</altitudeMode>";
    EXPECT_EQ(datumOf(absolute, ""), HeightDatum::meanSeaLevel);
    EXPECT_EQ(datumOf(relative, absolute), HeightDatum::meanSeaLevel);
    EXPECT_EQ(datumOf(absolute, relative), HeightDatum::ground);
    EXPECT_EQ(datumOf("", ""), HeightDatum::ground);
    const auto floor =
        parseKml(multiTrack("<gx:altitudeMode>relativeToSeaFloor</gx:altitudeMode>", fix), "f");
    ASSERT_TRUE(floor);
    EXPECT_EQ(floor->notes.size(), 1u);
    EXPECT_EQ(floor->tracks[0].fixes[0].heightM, 500.0);
}

TEST(KmlTracks, AMissingPartnerMovesNoOther)
{
    const auto reading =
        parseKml(multiTrack("", kAt + "20Z</when>\n" + kAt + "21Z</when><gx:coord>8 46.1 0</gx:coord>" + kAt +
                                    "22Z</when><gx:coord/><gx:coord>9 47 0</gx:coord>" + kAt +
                                    "24Z</when><gx:coord>8 46.4 0</gx:coord>"),
                 "f");
    ASSERT_TRUE(reading) << reading.error().message();
    const auto& fixes = reading->tracks[0].fixes;
    ASSERT_EQ(fixes.size(), 2u);
    EXPECT_NEAR(fixes[0].latitudeDeg, 46.1, 1e-9);
    EXPECT_NEAR(fixes[1].timeS - fixes[0].timeS, 3.0, 1e-9);
    EXPECT_NEAR(fixes[1].latitudeDeg, 46.4, 1e-9);
    EXPECT_EQ(reading->problemCount, 3u);
}

TEST(GpxTracks, SegmentsAreInTheOrderOfTheirTimes)
{
    const auto point = [](const char* second)
    { return "<trkpt lat='46' lon='8'><time>2021-04-17T08:39:" + std::string(second) + "Z</time></trkpt>"; };
    const auto reading = parseGpx("<gpx><trk><trkseg>" + point("30") + point("31") + "</trkseg><trkseg>" +
                                      point("20") + point("21") + point("22") + "</trkseg></trk></gpx>",
                                  "f");
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->tracks[0].fixes.size(), 5u);
    EXPECT_EQ(reading->problemCount, 0u);
}

/// Where a played track is, at every tenth of a second: the worst distance from a height.
double worstFrom(double heightM, const FlightTrack& track)
{
    auto action = trajectoryOf(track);
    EXPECT_TRUE(action);
    Scenario scenario;
    Vehicle vehicle;
    vehicle.name = vehicle.category = "aircraft";
    scenario.entities.push_back({{}, "Ego", vehicle});
    scenario.storyboard.init.privates.push_back({{}, "Ego", {*action}});
    PlayerOptions options;
    options.origin = Geodetic{46.0, 8.0, 0.0};
    options.clock = FixedClock(10);
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    EXPECT_TRUE(player);
    const LocalFrame frame(Geodetic{46.0, 8.0, 0.0});
    double worst = 0.0;
    for (; !(*player)->isFinished() && (*player)->timeS() < track.fixes.back().timeS; (*player)->step())
        worst = std::max(
            worst, std::fabs(frame.geodeticFromLocal((*player)->entities()[0].position).heightM - heightM));
    return worst;
}

FlightTrack unevenTrack(const Times& times, std::size_t noisy, double noiseM)
{
    FlightTrack track{"f", {}, HeightDatum::ellipsoid, true};
    for (const double timeS : times)
        track.fixes.push_back(
            {timeS, 46.0 + 0.0009 * timeS, 8.0, 1000.0, static_cast<int>(track.fixes.size()) + 1});
    *track.fixes[noisy].heightM += noiseM;
    return track;
}

TEST(TrackGaps, NoiseBetweenUnevenFixesStaysAsLargeAsItIs)
{
    EXPECT_LT(worstFrom(1000.0, unevenTrack({0, 10, 20, 20.1, 30, 40}, 3, 0.5)), 0.6);
    EXPECT_LT(worstFrom(1000.0, unevenTrack({0, 1, 1.02, 20, 21, 22}, 2, -1.0)), 1.2);
    EXPECT_LT(worstFrom(1000.0, unevenTrack({0, 0.25, 25, 25.25, 50}, 1, 2.0)), 2.4);
    EXPECT_LT(worstFrom(1000.0, unevenTrack({0, 0.1, 60, 60.1, 120}, 3, 0.5)), 0.6);
    EXPECT_LT(worstFrom(1000.0, unevenTrack({0, 5, 5.5, 6, 29, 29.5}, 2, 1.0)), 1.2);
}

TEST(TrackGaps, EvenFixesAreLeftAlone)
{
    const auto action = trajectoryOf(unevenTrack({0, 1, 2, 3, 4.5, 6}, 2, 1.0));
    ASSERT_TRUE(action);
    EXPECT_EQ(std::get<Polyline>(action->trajectory.shape).vertices.size(), 6u);
}

TEST(TrackGaps, AreTold)
{
    EXPECT_EQ(gapsOf(unevenTrack({0, 1, 2, 300, 301}, 2, 0.0)),
              "no fix for more than 30 s 1 times, for 298 s after line 3; the way is straight there");
    EXPECT_FALSE(gapsOf(unevenTrack({0, 60, 120, 180, 240}, 2, 0.0))) << "that is how it records";
}

} // namespace
} // namespace simulation
