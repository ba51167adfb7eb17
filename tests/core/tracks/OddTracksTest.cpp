// SPDX-License-Identifier: Apache-2.0
// Track files as other programs write them: every one tells the same two places.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

constexpr double kOddStartS = 1618648760.0; ///< 2021-04-17T08:39:20Z

struct OddTrack
{
    const char* name;
    foundation::Result<TrackReading> (*parse)(std::string_view, const std::string&);
    std::string text;
    double startS = kOddStartS;
    std::size_t problems = 0;
};

class OddTracks : public testing::TestWithParam<OddTrack>
{
};

TEST_P(OddTracks, TellTheSameFlight)
{
    const auto reading = GetParam().parse(GetParam().text, "f");
    ASSERT_TRUE(reading) << reading.error().message();
    ASSERT_EQ(reading->tracks.size(), 1u);
    const FlightTrack& track = reading->tracks[0];
    ASSERT_EQ(track.fixes.size(), 2u);
    EXPECT_EQ(reading->problemCount, GetParam().problems);
    EXPECT_EQ(track.hasTimes, GetParam().startS > 0.0);
    EXPECT_NEAR(track.fixes[0].timeS, GetParam().startS, 1e-3);
    EXPECT_NEAR(track.fixes[1].timeS, GetParam().startS + (track.hasTimes ? 1.0 : 0.0), 1e-3);
    EXPECT_NEAR(track.fixes[0].latitudeDeg, 46.5, 1e-9);
    EXPECT_NEAR(track.fixes[0].longitudeDeg, 8.25, 1e-9);
    EXPECT_NEAR(track.fixes[1].latitudeDeg, 46.6, 1e-9);
    EXPECT_NEAR(track.fixes[1].heightM.value_or(-1.0), 304.8, 1e-9);
}

const std::string kWhen1 = "<when>2021-04-17T08:39:20Z</when>", kWhen2 = "<when>2021-04-17T08:39:21Z</when>";
const std::string kPoint2 = "<Placemark><TimeStamp>" + kWhen2 +
                            "</TimeStamp><Point><altitudeMode>absolute</"
                            "altitudeMode><coordinates>8.25,46.6,304.8</coordinates></Point></Placemark>";
const std::string kLine = "<Placemark><LineString><altitudeMode>absolute</"
                          "altitudeMode><coordinates>\n8.25,46.5,300\n 8.25,46.6,304.8\n"
                          "</coordinates></LineString></Placemark>";

INSTANTIATE_TEST_SUITE_P(
    Table, OddTracks,
    testing::Values(
        OddTrack{"kmlWithoutPrefix", parseKml,
                 "<kml><Placemark><Track><altitudeMode>absolute</altitudeMode>" + kWhen1 + kWhen2 +
                     "<coord>8.25 46.5 300</coord><coord>8.25 46.6 304.8</coord></Track></Placemark></kml>"},
        OddTrack{"kmlOfParts", parseKml,
                 "<kml><Placemark><gx:MultiTrack><gx:interpolate>0</"
                 "gx:interpolate><gx:Track><altitudeMode>absolute</altitudeMode>" +
                     kWhen1 +
                     "<gx:coord>8.25 46.5 "
                     "300</gx:coord></gx:Track><gx:Track><altitudeMode>absolute</altitudeMode>" +
                     kWhen2 +
                     "<gx:coord>8.25 46.6 304.8</gx:coord></gx:Track></gx:MultiTrack></Placemark></kml>"},
        OddTrack{"kmlOfPoints", parseKml,
                 "<kml><Document>" + kLine + "<Folder><name>Route</name>" + kPoint2 +
                     "<Placemark><TimeStamp>" + kWhen1 +
                     "</TimeStamp><Point><altitudeMode>absolute</altitudeMode><coordinates>8.25,46.5,300</"
                     "coordinates></Point></Placemark>"
                     "</Folder></Document></kml>"},
        OddTrack{"kmlOfALine", parseKml, "<kml><Document>" + kLine + "</Document></kml>", 0.0},
        OddTrack{
            "gpxFirstPointWithoutTime", parseGpx,
            R"(<gpx><trk><trkseg><trkpt lat="46.4" lon="8.25"/><trkpt lat="46.5" lon="8.25"><time>2021-04-17T08:39:20Z</time></trkpt>
<trkpt lat="46.6" lon="8.25"><ele>304.8</ele><time>2021-04-17T08:39:21Z</time></trkpt></trkseg></trk></gpx>)",
            kOddStartS, 1},
        OddTrack{"gpxFewTimes", parseGpx,
                 R"(<gpx><trk><trkseg><trkpt lat="46.5" lon="8.25"><time>2021-04-17T08:39:20Z</time></trkpt>
<trkpt lat="46.6" lon="8.25"><ele>304.8</ele></trkpt></trkseg></trk></gpx>)",
                 0.0},
        OddTrack{"csvPositionInOneCell", parseTrackTable,
                 "Timestamp,UTC,Callsign,Position,Altitude,Speed,Direction\n"
                 "1618648760,2021-04-17T08:39:20Z,AB1,\"46.5,8.25\",900,0,0\n"
                 "1618648761,2021-04-17T08:39:21Z,AB1,\"46.6,8.25\",1000,0,0\n"},
        OddTrack{"csvFeet", parseTrackTable,
                 "time,lat,lon,alt (ft)\n1618648760,46.5,8.25,900\n1618648761,46.6,8.25,1000\n"},
        OddTrack{"csvMilliseconds", parseTrackTable,
                 "# of a phone\n\ntimestamp,gps_latitude,gps_longitude,gps_altitude\n"
                 "1618648760000,46.5,8.25,300\n1618648761000,46.6,8.25,304.8\n"},
        OddTrack{"csvTimeOfDay", parseTrackTable,
                 "time;latitude;longitude;height\n08:39:20;46.5;8.25;300\n08:39:21;46.6;8.25;304.8\n",
                 8.0 * 3600.0 + 39.0 * 60.0 + 20.0}),
    [](const testing::TestParamInfo<OddTrack>& test) { return test.param.name; });

/// A number of so many bytes, the lowest first.
std::string bytesOf(std::size_t value, int count)
{
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    return bytes;
}

TEST(OddTracks, AKmzIsAZipWithAKmlInIt)
{
    const std::string kml = "<kml>" + kLine + "</kml>", name = "doc.kml";
    const std::string zip = "PK\x03\x04" + bytesOf(20, 2) + bytesOf(0, 4) + bytesOf(0, 4) + bytesOf(0, 4) +
                            bytesOf(kml.size(), 4) + bytesOf(kml.size(), 4) + bytesOf(name.size(), 2) +
                            bytesOf(0, 2) + name + kml;
    const auto file = std::filesystem::path(testing::TempDir()) / "way.kmz";
    std::ofstream(file, std::ios::binary) << zip;
    const auto reading = readTracks(file);
    std::filesystem::remove(file);
    ASSERT_TRUE(reading) << reading.error().message();
    EXPECT_EQ(reading->tracks.at(0).name, "way");
    EXPECT_EQ(reading->tracks.at(0).fixes.size(), 2u);
}

} // namespace
} // namespace simulation
