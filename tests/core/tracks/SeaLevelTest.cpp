// SPDX-License-Identifier: Apache-2.0
// What heights count from, and that they are compared with the ground in the same way.
#include <gtest/gtest.h>

#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackGeoid.h"
#include "simulation/track/TrackMotion.h"
#include "simulation/track/TrackScenario.h"

namespace simulation
{
namespace
{

/// EGM96 of NGA's calculator, to what 15' and bilinear are good for.
TEST(TrackGeoid, IsThatOfEgm96)
{
    EXPECT_NEAR(geoidHeightM(48.735, 8.97), 48.66, 0.05);
    EXPECT_NEAR(geoidHeightM(0.0, 0.0), 17.16, 0.1);
    EXPECT_NEAR(geoidHeightM(5.0, 78.75), -106.5, 1.0); // south of India
    EXPECT_NEAR(geoidHeightM(-8.5, 147.25), geoidHeightM(-8.5, 147.25 - 360.0), 1e-6);
}

double firstHeight(std::vector<FlightTrack> tracks)
{
    EXPECT_FALSE(countFromEllipsoid(tracks));
    EXPECT_FALSE(countFromEllipsoid(tracks)) << "once is enough";
    return *tracks.at(0).fixes.at(0).heightM;
}

std::vector<FlightTrack> read(foundation::Result<TrackReading> reading)
{
    EXPECT_TRUE(reading) << reading.error().message();
    return reading ? reading->tracks : std::vector<FlightTrack>{};
}

TEST(TrackGeoid, EachFormatCountsFromWhatItsStandardSays)
{
    const double sea = geoidHeightM(48.735, 8.97);
    const auto gpx = [](const std::string& more)
    {
        return read(parseGpx("<gpx><trk><trkseg><trkpt lat='48.735' lon='8.97'><ele>50</ele>" + more +
                                 "</trkpt></trkseg></trk></gpx>",
                             "f"));
    };
    EXPECT_NEAR(firstHeight(gpx("")), 50.0 + sea, 1e-6);
    EXPECT_NEAR(firstHeight(gpx("<geoidheight>47.5</geoidheight>")), 97.5, 1e-9) << "the file's own";
    EXPECT_NEAR(firstHeight(gpx("<geoidheight>4e9</geoidheight>")), 50.0 + sea, 1e-6);
    const auto kml = [](const std::string& mode)
    {
        return read(parseKml("<kml><LineString><altitudeMode>" + mode +
                                 "</altitudeMode><coordinates>8.97,48.735,50 "
                                 "8.98,48.735,50</coordinates></LineString></kml>",
                             "f"));
    };
    EXPECT_NEAR(firstHeight(kml("absolute")), 50.0 + sea, 1e-6);
    EXPECT_NEAR(firstHeight(kml("relativeToGround")), 50.0, 1e-9);
    EXPECT_NEAR(firstHeight(kml("clampToGround")), 0.0, 1e-9);
    EXPECT_NEAR(firstHeight(read(parseAcmi("1,T=8.97|48.735|50", "f"))), 50.0 + sea, 1e-6);
    EXPECT_NEAR(firstHeight(read(parseTrackTable("lat,lon,alt\n48.735,8.97,50\n", "f"))), 50.0 + sea, 1e-6);
    EXPECT_NEAR(firstHeight(read(parseTrackTable("lat,lon,alt HAE\n48.735,8.97,50\n", "f"))), 50.0, 1e-9);
    const std::string fix = "B0839204844100N00858200EA0004000050\n"; // barometer 40 m, satellites 50 m
    EXPECT_NEAR(firstHeight(read(parseIgc(fix, "f"))), 50.0, 1e-9);
    EXPECT_NEAR(firstHeight(read(parseIgc("HFALGALTGPS:GEO\n" + fix, "f"))), 50.0 + sea, 0.01);
    EXPECT_NEAR(firstHeight(read(parseIgc("HFALGALTGPS:ELL\n" + fix, "f"))), 50.0, 1e-9);
    EXPECT_NEAR(firstHeight(read(parseIgc("B0839204844100N00858200EV0004000000\n", "f"))), 40.0 + sea, 0.01);
    auto told = gpx("");
    setDatum(told, HeightDatum::ellipsoid);
    EXPECT_NEAR(firstHeight(told), 50.0, 1e-9);
}

/// 50 m above the sea over ground that is 10 m above it: 40 m above the ground, and no fix is lifted.
TEST(TrackGeoid, AFlightIsAsHighAboveTheGroundAsBothSay)
{
    const Geodetic origin{48.735, 8.97, 0.0};
    const double sea = geoidHeightM(origin.latitudeDeg, origin.longitudeDeg);
    const SceneFrame frame(origin, [sea](double, double, double) { return GroundSample{10.0 + sea}; });
    FlightTrack track{"f", {}, HeightDatum::meanSeaLevel, true};
    for (int i = 0; i < 10; ++i)
        track.fixes.push_back({10.0 * i, 48.735 + 0.001 * i, 8.97, 50.0, i + 1});
    const auto made = scenarioOf({track}, frame, {"dem.tif", "f", 0.0});
    ASSERT_TRUE(made) << made.error().message();
    ASSERT_FALSE(made->notes.empty());
    EXPECT_EQ(made->notes[0],
              "f: 10 fixes, heights above mean sea level, which is 48.7 m above the ellipsoid there");
    const auto& follow =
        std::get<FollowTrajectoryAction>(made->scenario.storyboard.init.privates[0].actions[0]);
    for (const Vertex& vertex : std::get<Polyline>(follow.trajectory.shape).vertices)
        EXPECT_NEAR(*std::get<GeoPosition>(vertex.position).heightM, 50.0 + sea, 0.2);
    EXPECT_TRUE(made->scenario.entities[0].isAirborne()) << "40 m above the ground all the time";
}

TEST(TrackGeoid, WithoutGroundHeightsStayAsTheyWereRecorded)
{
    const double sea = geoidHeightM(48.735, 8.97);
    const SceneFrame frame(Geodetic{48.735, 8.97, sea}, {});
    FlightTrack track{"f", {}, HeightDatum::ground, true};
    track.fixes = {{0.0, 48.735, 8.97, 5.0, 1}, {10.0, 48.736, 8.97, {}, 2}, {20.0, 48.737, 8.97, 7.0, 3}};
    track.fixes[2].datum = HeightDatum::meanSeaLevel;
    const auto made = scenarioOf({track}, frame, {"", "f", 0.0});
    ASSERT_TRUE(made) << made.error().message();
    const auto& follow =
        std::get<FollowTrajectoryAction>(made->scenario.storyboard.init.privates[0].actions[0]);
    const auto& vertices = std::get<Polyline>(follow.trajectory.shape).vertices;
    const auto heightAt = [&](std::size_t i)
    { return *std::get<GeoPosition>(vertices[i].position).heightM - sea; };
    EXPECT_NEAR(heightAt(0), 5.0, 0.01);
    EXPECT_NEAR(heightAt(1), 0.0, 0.01);
    EXPECT_NEAR(heightAt(2), 7.0, 0.01);
}

} // namespace
} // namespace simulation
