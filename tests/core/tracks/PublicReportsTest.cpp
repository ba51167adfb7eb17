// SPDX-License-Identifier: Apache-2.0
// Inputs after public bug reports of other programs that read recordings; each names its project and number.
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

using Reader = foundation::Result<TrackReading> (*)(std::string_view, const std::string&);

struct Report
{
    const char* name;
    Reader read;
    std::string text;
    std::size_t fixes = 0, problems = 0, notes = 0;
    bool hasTimes = true;
    double lastS = 0.0;   ///< of the last fix, from the first
    double heightM = 0.0; ///< of the last fix
    HeightDatum datum = HeightDatum::meanSeaLevel;
};

class PublicReports : public testing::TestWithParam<Report>
{
};

TEST_P(PublicReports, AreRead)
{
    const auto reading = GetParam().read(GetParam().text, "t.file");
    ASSERT_TRUE(reading) << reading.error().message();
    ASSERT_EQ(reading->tracks.size(), 1u);
    const FlightTrack& track = reading->tracks[0];
    ASSERT_EQ(track.fixes.size(), GetParam().fixes);
    EXPECT_EQ(reading->problemCount, GetParam().problems);
    EXPECT_EQ(reading->notes.size(), GetParam().notes);
    EXPECT_EQ(track.hasTimes, GetParam().hasTimes);
    EXPECT_NEAR(track.fixes.back().timeS - track.fixes.front().timeS, GetParam().lastS, 1e-3);
    EXPECT_NEAR(track.fixes.back().heightM.value_or(-1.0), GetParam().heightM, 1e-6);
    EXPECT_EQ(track.fixes.back().datum.value_or(track.datum), GetParam().datum);
}

/// A segment of points; each is what stands within its `trkpt`.
std::string gpx(const std::vector<std::string>& points)
{
    std::string text = "<?xml version=\"1.0\"?><gpx version=\"1.1\"><trk><trkseg>";
    for (std::size_t i = 0; i < points.size(); ++i)
        text += "<trkpt lat=\"49.000" + std::to_string(i) + "\" lon=\"16.3\">" + points[i] + "</trkpt>";
    return text + "</trkseg></trk></gpx>";
}

std::string timed(const std::string& time, const std::string& height = "200")
{
    return "<ele>" + height + "</ele><time>" + time + "</time>";
}

/// Three fixes 1500 m high; `before` stands before the track, `within` in it.
std::string kml(const std::string& before, const std::string& within)
{
    std::string text = "<kml xmlns:gx=\"g\"><Document><Placemark>" + before + "<gx:Track>" + within;
    for (const char* second : {"0", "1", "2"})
        text += std::string("<when>2024-01-01T10:00:0") + second + "Z</when><gx:coord>8.00" + second +
                " 46 1500</gx:coord>";
    return text + "</gx:Track></Placemark></Document></kml>";
}

std::string mode(const std::string& word)
{
    return "<altitudeMode>" + word + "</altitudeMode>";
}

/// A Track without times.
std::string untimedKml()
{
    std::string text = "<kml xmlns:gx=\"g\"><Placemark><gx:Track>" + mode("absolute");
    for (const char* second : {"0", "1", "2"})
        text += std::string("<gx:coord>8.00") + second + " 46 1500</gx:coord>";
    return text + "</gx:Track></Placemark></kml>";
}

/// A line with a TimeSpan behind it and one place twice, as map timelines export it.
std::string spanKml(const std::string& begin, const std::string& end)
{
    return "<kml><Document><Placemark>" + begin + mode("absolute") +
           "<coordinates>10.76,59.93,7 10.76,59.93,7 10.759,59.929,7 10.758,59.928,7</coordinates>" + end +
           "<TimeSpan><begin>2019-05-01T10:00:22.000Z</begin><end>2019-05-01T10:42:33.726Z</end></TimeSpan>"
           "</Placemark></Document></kml>";
}

std::string igc(const std::string& fixes, const std::string& date = "HFDTE060626")
{
    return "AXXX001\n" + date + "\n" + fixes;
}

/// B records of some seconds, 1600 m high by pressure.
std::string records(int count, char validity, const std::string& height = "01650", int from = 0)
{
    std::string text;
    for (int second = from; second < from + count; ++second)
    {
        char line[64];
        std::snprintf(line, sizeof line, "B1000%02d46%05dN00815000E%c01600%s\n", second, 42000 + 20 * second,
                      validity, height.c_str());
        text += line;
    }
    return text;
}

/// B records before the receiver knows where it is.
std::string zeroRecords(int count, char validity)
{
    std::string text;
    for (int second = 0; second < count; ++second)
        text += "B00000" + std::to_string(second) + "0000000N00000000E" + validity + "0000000000\n";
    return text;
}

/// A B record with a clock 34 minutes ahead.
std::string wildRecord()
{
    return "B1034004642100N00815000EA0160001650\n";
}

INSTANTIATE_TEST_SUITE_P(
    Table, PublicReports,
    testing::Values(
        Report{"freemap892", parseGpx,
               gpx({"<time>2024-01-01T10:00:00Z</time>", timed("2024-01-01T10:00:05Z", "217"),
                    "<time>2024-01-01T10:00:10Z</time>"}),
               3, 0, 1, true, 10.0, 217.0},
        Report{"leafletGpx127", parseGpx,
               gpx({"<time>2024-01-01T10:00:00Z</time>", timed("2024-01-01T10:00:05Z")}), 2, 0, 1, true, 5.0,
               200.0},
        Report{"fitTrackee338", parseGpx, gpx({"<ele>7</ele>", "<ele>8</ele>"}), 2, 0, 0, false, 0.0, 8.0},
        Report{"openTracks1236", parseGpx, gpx({timed("null"), timed("null")}), 2, 0, 0, false, 0.0, 200.0},
        Report{"gpxSee237", parseGpx,
               gpx({timed("2024-01-01T10:00:00Z"), "<ele>1</ele>", "<ele>2</ele>", "<ele>3</ele>"}), 4, 0, 0,
               false, 0.0, 3.0},
        Report{"gpxInterpolate4", parseGpx,
               gpx({timed("2024-01-01T10:00:00Z"), timed("2024-01-01T10:00:05Z"), "<ele>9</ele>"}), 2, 1, 0,
               true, 5.0, 200.0},
        Report{"workoutTracker798", parseGpx,
               gpx({timed("2026-04-26T18:22:25.503+02:00"), timed("2026-04-26T18:22:27+02:00"),
                    timed("2026-04-26T16:22:29Z")}),
               3, 0, 0, true, 3.497, 200.0},
        Report{"iridiumToolkit27", parseKml, kml(mode("absolute"), ""), 3, 0, 1, true, 2.0, 1500.0},
        Report{"goproTypo1", parseKml, kml("", mode("absolut")), 3, 0, 1, true, 2.0, 1500.0},
        Report{"exiftool175", parseKml, kml("", mode("clampedToGround")), 3, 0, 1, true, 2.0, 0.0,
               HeightDatum::ground},
        Report{"unknownMode", parseKml, kml("", mode("floating")), 3, 0, 1, true, 2.0, 0.0,
               HeightDatum::ground},
        Report{"gpsBabel55", parseKml, untimedKml(), 3, 0, 0, false, 0.0, 1500.0},
        Report{"gpsBabel482", parseKml, spanKml("<LineString>", "</LineString>"), 3, 0, 1, true, 2531.726,
               7.0},
        Report{"skyDrop170", parseIgc, igc(zeroRecords(5, 'V') + records(10, 'A')), 10, 5, 0, true, 9.0,
               1650.0, HeightDatum::ellipsoid},
        Report{"zeroPlacesOfGpx", parseGpx,
               gpx({timed("2024-01-01T10:00:05Z"), timed("2024-01-01T10:00:06Z")})
                   .insert(gpx({}).find("</trkseg>"),
                           "<trkpt lat=\"0\" lon=\"0\">" + timed("2024-01-01T10:00:00Z") + "</trkpt>"),
               2, 1, 0, true, 1.0, 200.0},
        Report{"skyDrop411", parseIgc, igc(records(10, 'V', "00000")), 10, 0, 0, true, 9.0, 1600.0,
               HeightDatum::pressure},
        Report{"skyDrop156", parseIgc, igc(records(5, 'A') + wildRecord() + records(5, 'A', "01650", 6)), 10,
               1, 0, true, 10.0, 1650.0, HeightDatum::ellipsoid},
        Report{"gpxSee192", parseIgc,
               igc(records(2, 'A') + "HFDTE070626\nB0000004642100N00815000EA0160001650\n"), 3, 0, 0, true,
               50400.0, 1650.0, HeightDatum::ellipsoid},
        Report{"gpxSee192LittleBefore", parseIgc,
               igc(records(2, 'A') + "HFDTE070626\n" + records(2, 'A', "01650", 2)), 4, 0, 0, true, 3.0,
               1650.0, HeightDatum::ellipsoid},
        Report{"leaf317", parseIgc, igc(records(10, 'A'), "HFDTEDATE060626"), 10, 0, 0, true, 9.0, 1650.0,
               HeightDatum::ellipsoid},
        Report{"igcParser361", parseIgc, igc(records(10, 'A', "-0012")), 10, 0, 0, true, 9.0, -12.0,
               HeightDatum::ellipsoid},
        Report{"ownModeFirst", parseKml, kml(mode("relativeToGround"), mode("absolute")), 3, 0, 1, true, 2.0,
               1500.0},
        Report{"sound", parseKml, kml("", mode("absolute")), 3, 0, 0, true, 2.0, 1500.0}),
    [](const auto& of) { return of.param.name; });

} // namespace
} // namespace simulation
