// SPDX-License-Identifier: Apache-2.0
// Recorded tracks of every kind, worked by hand, and what is said of damaged ones.
#include "simulation/track/ReadTrack.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "RealData.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/track/TrackHeights.h"
#include "simulation/track/TrackTrajectory.h"

namespace simulation
{
namespace
{

/// 46°37.701' N, 8°01.851' E on 17 April 2021; the second fix a second later, 2 m higher.
const std::string kIgc = "AXSX001\r\nHFDTE170421\r\n"
                         "B0839204637701N00801851EA0185801900\r\nB0839214637702N00801851EA0186001902\r\n";

void expectFirst(const foundation::Result<TrackReading>& reading, double timeS, double heightM)
{
    ASSERT_TRUE(reading) << reading.error().message();
    ASSERT_EQ(reading->tracks.size(), 1u);
    const TrackFix& fix = reading->tracks[0].fixes.front();
    EXPECT_NEAR(fix.latitudeDeg, 46.0 + 37.701 / 60.0, 1e-9);
    EXPECT_NEAR(fix.longitudeDeg, 8.0 + 1.851 / 60.0, 1e-9);
    EXPECT_NEAR(fix.timeS, timeS, 1e-6);
    EXPECT_NEAR(fix.heightM.value_or(-1.0), heightM, 1e-9);
    EXPECT_EQ(reading->tracks[0].fixes.size(), 2u);
    EXPECT_EQ(reading->problemCount, 0u);
}

constexpr double kStartS = 1618648760.0; ///< 2021-04-17T08:39:20Z

TEST(ReadTrack, EachFormatTellsTheSameFlight)
{
    expectFirst(parseIgc(kIgc, "a.igc"), kStartS, 1900.0);
    expectFirst(
        parseGpx(R"(<gpx><trk><name>f</name><trkseg><trkpt lat="46.62835" lon="8.03085"><ele>1900</ele>
<time>2021-04-17T08:39:20Z</time></trkpt><trkpt lat="46.62836" lon="8.03085"><ele>1902</ele><time>2021-04-17T10:39:21+02:00</time></trkpt>
</trkseg></trk></gpx>)",
                 "a.gpx"),
        kStartS, 1900.0);
    expectFirst(parseKml(R"(<kml xmlns:gx="g"><Placemark><gx:Track><altitudeMode>absolute</altitudeMode>
<when>2021-04-17T08:39:20Z</when><when>2021-04-17T08:39:21Z</when><gx:coord>8.03085 46.62835 1900</gx:coord>
<gx:coord>8.03085 46.62836 1902</gx:coord></gx:Track></Placemark></kml>)",
                         "a.kml"),
                kStartS, 1900.0);
    expectFirst(
        parseAcmi("\xEF\xBB\xBF"
                  "FileType=text/acmi/tacview\nFileVersion=2.2\n0,ReferenceTime=2021-04-17T08:39:00Z\n"
                  "0,ReferenceLongitude=8,Title=a\\, b\n0,ReferenceLatitude=46\n#20\n"
                  "1,T=0.03085|0.62835|1900,Name=f\n#21\n1,T=|0.62836|1902\n-1\n",
                  "a.acmi"),
        kStartS, 1900.0);
    expectFirst(
        parseTrackTable(
            "Time (s);Latitude;Longitude;Altitude_m\n5;46.62835;8.03085;1900\n6;46.62836;8.03085;1902\n",
            "a.csv"),
        5.0, 1900.0);
}

TEST(ReadTrack, HeightsOfTheSatellitesCountFromWhatTheFileSays)
{
    EXPECT_EQ(parseIgc(kIgc, "a")->tracks[0].datum, HeightDatum::ellipsoid);
    EXPECT_EQ(parseIgc("HFALG:GEO\n" + kIgc, "a")->tracks[0].datum, HeightDatum::meanSeaLevel);
    // Without satellites' heights it is the barometer's.
    const auto reading = parseIgc("HFDTE170421\nB0839204637701N00801851EV0185800000\n", "a");
    EXPECT_EQ(reading->tracks[0].datum, HeightDatum::pressure);
    EXPECT_EQ(reading->tracks[0].fixes[0].heightM, 1858.0);
    // A fix without one has the barometer's, moved by the last difference: 1860 + 44.
    const auto gap = parseIgc(kIgc + "B0839224637702N00801851EV0186000000\n", "a");
    EXPECT_EQ(gap->tracks[0].fixes.at(2).heightM, 1902.0);
}

TEST(ReadTrack, AFlightGoesOnPastMidnight)
{
    const auto reading = parseIgc(
        "HFDTE170421\nB2359594637701N00801851EA0185801900\nB0000014637701N00801851EA0185801900\n", "a");
    ASSERT_TRUE(reading);
    ASSERT_EQ(reading->tracks[0].fixes.size(), 2u);
    EXPECT_NEAR(reading->tracks[0].fixes[1].timeS - reading->tracks[0].fixes[0].timeS, 2.0, 1e-9);
}

struct TrackFault
{
    const char* name;
    foundation::Result<TrackReading> (*parse)(std::string_view, const std::string&);
    std::string text;
    int line;
    const char* says;
};

class TrackError : public testing::TestWithParam<TrackFault>
{
};

/// Said as a problem where something is left, else as the error of the file; with the line in both.
TEST_P(TrackError, IsSaidWithItsLine)
{
    const TrackFault& fault = GetParam();
    const auto reading = fault.parse(fault.text, "f");
    if (!reading)
    {
        EXPECT_NE(reading.error().message().find("f:" + std::to_string(fault.line)), std::string::npos)
            << reading.error().message();
        EXPECT_NE(reading.error().message().find(fault.says), std::string::npos) << reading.error().message();
        return;
    }
    ASSERT_EQ(reading->problems.size(), 1u);
    EXPECT_EQ(reading->problems[0].line, fault.line);
    EXPECT_NE(reading->problems[0].what.find(fault.says), std::string::npos) << reading->problems[0].what;
}

INSTANTIATE_TEST_SUITE_P(
    Table, TrackError,
    testing::Values(
        TrackFault{"igcShort", parseIgc, kIgc + "B110001\n", 5, "7 characters, but it has 35"},
        TrackFault{"igcHeight", parseIgc, kIgc + "B0839224637701N00801851EA01858019a0\n", 5,
                   "height cannot be read"},
        TrackFault{"igcHemisphere", parseIgc, kIgc + "B0839224637701X00801851EA0185801900\n", 5,
                   "position cannot be read"},
        TrackFault{"igcTime", parseIgc, kIgc + "B0839214637701N00801851EA0185801900\n", 5,
                   "not later than that of line 4"},
        TrackFault{"igcDate", parseIgc, "HFDTE999999\n" + kIgc, 1, "the date is none"},
        TrackFault{"gpxCut", parseGpx, "<gpx>\n<trk>", 2, "not well-formed"},
        TrackFault{"gpxNoPosition", parseGpx, "<gpx><trk><trkseg>\n<trkpt lat=\"x\"/></trkseg></trk></gpx>",
                   2, "without lat and lon"},
        TrackFault{"gpxRange", parseGpx, "<gpx><rte>\n<rtept lat=\"91\" lon=\"0\"/></rte></gpx>", 2,
                   "not within 90"},
        TrackFault{"kmlCount", parseKml,
                   "<kml><gx:Track><when>2021-04-17T08:39:20Z</when><gx:coord>8 46 0</gx:coord>\n<gx:coord>8 "
                   "46 0</gx:coord></gx:Track></kml>",
                   2, "without a when"},
        TrackFault{"acmiNumber", parseAcmi, "#0\n1,T=8|46|0\n#x\n", 3, "a time that is no number"},
        TrackFault{"acmiEmpty", parseAcmi, "#0\n1,T=8||\n", 2, "nothing has told yet"},
        TrackFault{"csvHeader", parseTrackTable, "a,b\n1,2\n", 1, "names no columns"},
        TrackFault{"csvNumber", parseTrackTable, "t,lat,lon\n0,1,2\n1,x,2\n", 3,
                   "latitude or longitude is no number"}),
    [](const testing::TestParamInfo<TrackFault>& test) { return test.param.name; });

TEST(ReadTrack, SaysWhyAFileIsNone)
{
    EXPECT_FALSE(readTracks("/nowhere.igc"));
    EXPECT_FALSE(parseIgc("RANDOM GARBAGE\n", "f"));
    EXPECT_NE(parseIgc("", "f").error().message().find("holds no position"), std::string::npos);
}

/// Stands for ten seconds, flies a minute, stands again: 40 m above a flat ground by its heights.
FlightTrack hop(double heightM)
{
    FlightTrack track{"hop", {}, HeightDatum::pressure, true};
    for (int i = 0; i <= 200; ++i)
    {
        const double way = std::clamp(i - 70, 0, 60) * 30.0;
        const double climb = i > 70 && i < 130 ? 50.0 : 0.0;
        track.fixes.push_back({static_cast<double>(i), 46.0 + way / 111e3, 8.0, heightM + climb, i + 1});
    }
    return track;
}

TEST(TrackHeights, OffsetIsThatOfTheFixesAtRest)
{
    FlightTrack track = hop(540.0);
    const TrackHeights done = fitToGround(track, [](double, double) { return 500.0; });
    EXPECT_NEAR(done.offsetM, -40.0, 1e-9);
    EXPECT_GT(done.restingFixes, 50u);
    EXPECT_EQ(done.raisedFixes, 0u);
    EXPECT_NEAR(*track.fixes[100].heightM, 550.0, 1e-9);
    EXPECT_NE(done.message().find("-40.0 m added"), std::string::npos) << done.message();
    EXPECT_NE(done.message().find("the standard pressure"), std::string::npos);
}

TEST(TrackHeights, NothingStaysBelowTheGround)
{
    FlightTrack track = hop(540.0);
    // A hill of 600 m in the middle of the flight, 50 m above what it flies at.
    const auto hill = [](double latitude, double)
    { return latitude > 46.005 && latitude < 46.006 ? 600.0 : 500.0; };
    const TrackHeights done = fitToGround(track, hill, 1.5);
    EXPECT_GT(done.raisedFixes, 0u);
    EXPECT_NEAR(done.deepestM, 50.0, 1e-9);
    for (const TrackFix& fix : track.fixes)
        EXPECT_GE(*fix.heightM, hill(fix.latitudeDeg, 0.0) + 1.5 - 1e-9);
    // A fix without height lies on the ground.
    FlightTrack flat{"flat", {{0, 46, 8, {}, 1}, {1, 46, 8, {}, 2}}, HeightDatum::meanSeaLevel, true};
    fitToGround(flat, [](double, double) { return 500.0; });
    EXPECT_EQ(flat.fixes[0].heightM, 500.0);
}

TEST(TrackTrajectory, IsFlownThroughEachFixAtItsTime)
{
    const auto reading = parseIgc(kIgc + "B0839304637800N00801900EA0190001950\n", "a");
    ASSERT_TRUE(reading);
    const auto action = trajectoryOf(reading->tracks[0]);
    ASSERT_TRUE(action);
    Scenario scenario;
    Vehicle vehicle;
    vehicle.name = "glider";
    vehicle.category = "aircraft";
    scenario.entities.push_back({{}, "Ego", vehicle});
    scenario.storyboard.init.privates.push_back({{}, "Ego", {*action}});
    PlayerOptions options;
    options.origin = Geodetic{46.6, 8.0, 0.0};
    options.clock = FixedClock(10);
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    ASSERT_TRUE(player) << player.error().message();
    for (int i = 0; i < 10; ++i)
        (*player)->step();
    const LocalFrame frame(Geodetic{46.6, 8.0, 0.0});
    const glm::dvec3 wanted = frame.localFromGeodetic({46.0 + 37.702 / 60.0, 8.0 + 1.851 / 60.0, 1902.0});
    EXPECT_LT(glm::distance((*player)->entities()[0].position, wanted), 0.01);
    EXPECT_FALSE(trajectoryOf({"one", {{0, 46, 8, {}, 1}}, HeightDatum::pressure, true}));
}

TEST(ReadTrack, RecordingsOfOthersAreReadOrRefusedWithAReason)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "tracks");
    std::size_t read = 0, refused = 0, fixes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || extension == ".txt" || extension == ".gz" || extension == ".md" ||
            extension.empty())
            continue;
        const auto reading = readTracks(entry.path());
        if (!reading)
        {
            ++refused;
            EXPECT_NE(reading.error().message().find(entry.path().filename().string()), std::string::npos);
            continue;
        }
        ++read;
        for (const FlightTrack& track : reading->tracks)
            fixes += track.fixes.size();
    }
    EXPECT_EQ(read, 31u);
    EXPECT_EQ(refused, 55u);
    EXPECT_GT(fixes, 10000u);
}

} // namespace
} // namespace simulation
