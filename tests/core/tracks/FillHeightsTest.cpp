// SPDX-License-Identifier: Apache-2.0
// A fix without a height among others is no fix at the sea. Public reports of the kind: FitTrackee 224,
// GPXKit 4, fit2gpx 15, phpGPX 31, gpx-interpolate 20.
#include "simulation/track/FillHeights.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

using Heights = std::vector<std::optional<double>>;

struct HeightCase
{
    const char* name;
    Heights read, filled;
    std::size_t given;
    bool hasTimes = true;
};

class MissingHeights : public testing::TestWithParam<HeightCase>
{
};

TEST_P(MissingHeights, AreThoseOfTheWayBetweenTheOthers)
{
    FlightTrack track;
    track.hasTimes = GetParam().hasTimes;
    constexpr double kTimes[] = {0.0, 10.0, 40.0, 50.0, 60.0}; // uneven
    for (std::size_t i = 0; i < GetParam().read.size(); ++i)
        track.fixes.push_back({kTimes[i], 48.0, 9.0, GetParam().read[i], static_cast<int>(i) + 1});
    EXPECT_EQ(fillHeights(track), GetParam().given);
    Heights filled;
    for (const TrackFix& fix : track.fixes)
        filled.push_back(fix.heightM);
    EXPECT_EQ(filled, GetParam().filled);
}

constexpr std::nullopt_t kNone = std::nullopt;

INSTANTIATE_TEST_SUITE_P(
    Table, MissingHeights,
    testing::Values(HeightCase{"none", {1, 2, 3}, {1, 2, 3}, 0},
                    HeightCase{"all", {kNone, kNone}, {kNone, kNone}, 0},
                    HeightCase{"middle", {500, kNone, 540}, {500, 510, 540}, 1},
                    HeightCase{"middleWithoutTimes", {500, kNone, 540}, {500, 520, 540}, 1, false},
                    HeightCase{"two", {500, kNone, kNone, 550}, {500, 510, 540, 550}, 2},
                    HeightCase{"ends", {kNone, 5, kNone, kNone}, {5, 5, 5, 5}, 3},
                    HeightCase{"byTurns", {0, kNone, 40, kNone, 60}, {0, 10, 40, 50, 60}, 2}),
    [](const auto& each) { return each.param.name; });

TEST(FillHeights, KeepsOutOfAGapBetweenTwoSurfaces)
{
    FlightTrack track;
    track.fixes = {{0.0, 48.0, 9.0, 500.0, 1}, {1.0, 48.0, 9.0, {}, 2}, {2.0, 48.0, 9.0, 3.0, 3}};
    track.fixes[2].datum = HeightDatum::ground;
    EXPECT_EQ(fillHeights(track), 0u);
    EXPECT_FALSE(track.fixes[1].heightM);
}

TEST(FillHeights, IsDoneAndToldByEveryReader)
{
    const auto check = [](const foundation::Result<TrackReading>& reading)
    {
        ASSERT_TRUE(reading) << reading.error().message();
        ASSERT_EQ(reading->tracks.at(0).fixes.size(), 3u);
        EXPECT_DOUBLE_EQ(reading->tracks[0].fixes[1].heightM.value_or(0.0), 510.0);
        ASSERT_FALSE(reading->notes.empty());
        EXPECT_NE(reading->notes.back().what.find("1 of 3 fixes have no height"), std::string::npos);
    };
    check(parseTrackTable("time,lat,lon,alt\n0,48,9,500\n1,48.001,9,\n2,48.002,9,520\n", "a.csv"));
    check(parseTrackTable("time|lat|lon|alt\r0|48|9|500\r1|48.001|9|\r2|48.002|9|520\r", "a.csv"));
    const auto point = [](int second, const char* height)
    {
        return "<trkpt lat='48,00" + std::to_string(second) + "' lon='9'>" + height +
               "<time>2024-01-01T00:00:0" + std::to_string(second) + "Z</time></trkpt>";
    };
    check(parseGpx("<gpx><trk><trkseg>" + point(0, "<ele>500</ele>") + point(1, "<ele/>") +
                       point(2, "<ele>520</ele>") + "</trkseg></trk></gpx>",
                   "a.gpx"));
    const std::string way = "9, 48, 500\n9,48.001 9 ,48.002 , 520";
    check(parseKml("<kml><Placemark><LineString><altitudeMode>absolute</altitudeMode><coordinates>" + way +
                       "</coordinates></LineString></Placemark></kml>",
                   "a.kml"));
}

TEST(ParseGpx, WaypointsAloneAreToldAsSuch)
{
    const auto reading = parseGpx("<gpx><wpt lat='48' lon='9'/></gpx>", "a.gpx");
    ASSERT_FALSE(reading);
    EXPECT_NE(reading.error().message().find("it has waypoints, and no track or route"), std::string::npos);
}

} // namespace
} // namespace simulation
