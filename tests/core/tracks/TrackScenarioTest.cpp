// SPDX-License-Identifier: Apache-2.0
// Recordings as scenarios: round trip, clearance, objects that come and go, attitudes.
#include "simulation/track/TrackScenario.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <zlib.h>

#include "RealData.h"
#include "TestFolder.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackClearance.h"
#include "simulation/track/TrackMotion.h"
#include "simulation/track/TrackTrajectory.h"
#include "simulation/writer/WriteScenario.h"

namespace simulation
{
namespace
{

const Geodetic kOrigin{46.0, 8.0, 0.0};

SceneFrame flatScene(double heightM)
{
    return {kOrigin, [heightM](double, double, double) { return GroundSample{heightM}; }};
}

FlightTrack flight(const std::string& name, double beginS, double heightM)
{
    FlightTrack track{name, {}, HeightDatum::ellipsoid, true};
    track.kind = TrackKind::aircraft;
    for (int i = 0; i < 20; ++i)
        track.fixes.push_back(
            {beginS + i, 46.0 + 0.0005 * i, 8.0 + 0.0001 * i * i, heightM + 3.0 * i, i + 1});
    return track;
}

TrackScenario made(std::vector<FlightTrack> tracks, const SceneFrame& frame, double startS = 0.0)
{
    auto scenario = scenarioOf(std::move(tracks), frame, {"dem.tif", "test", startS});
    EXPECT_TRUE(scenario) << scenario.error().message();
    return scenario ? std::move(*scenario) : TrackScenario{};
}

std::unique_ptr<ScenarioPlayer> playerOf(Scenario scenario, GroundProvider ground = {},
                                         int stepsPerSecond = 10)
{
    PlayerOptions options;
    options.origin = kOrigin;
    options.ground = std::move(ground);
    options.clock = FixedClock(stepsPerSecond);
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

/// The largest differences between the fixes of a track and where the text of its scenario puts them when it
/// is played.
struct RoundTrip
{
    double worstDeg = 0.0, worstM = 0.0;
};

RoundTrip roundTrip(const FlightTrack& track, double shiftS = 0.0)
{
    const TrackScenario scenario = made({track}, flatScene(0.0));
    const auto text = scenarioText(scenario.scenario);
    EXPECT_TRUE(text) << text.error().message();
    auto read = parseScenario(*text, "text");
    EXPECT_TRUE(read) << read.error().message();
    const auto player = playerOf(std::move(read->scenario));
    const LocalFrame frame(kOrigin);
    RoundTrip worst;
    for (const TrackFix& fix : track.fixes)
    {
        while (player->timeS() < fix.timeS - track.fixes.front().timeS + shiftS - 1e-6 &&
               !player->isFinished())
            player->step();
        const Geodetic at = frame.geodeticFromLocal(player->entities()[0].position);
        worst.worstDeg = std::max({worst.worstDeg, std::fabs(at.latitudeDeg - fix.latitudeDeg),
                                   std::fabs(at.longitudeDeg - fix.longitudeDeg)});
        worst.worstM = std::max(worst.worstM, std::fabs(at.heightM - *fix.heightM));
    }
    return worst;
}

TEST(TrackScenario, GoesThroughEveryFixAtItsTimeAfterWritingReadingAndPlaying)
{
    const FlightTrack track = flight("f", 100.0, 900.0);
    EXPECT_LT(roundTrip(track).worstDeg, 1e-7);
    EXPECT_LT(roundTrip(track).worstM, 0.01);
    EXPECT_GT(roundTrip(track, 0.1).worstDeg, 1e-6) << "a track that is late must be found";
}

TEST(TrackScenario, BeginsWhereItIsAskedTo)
{
    const TrackScenario scenario = made({flight("f", 100.0, 900.0)}, flatScene(0.0), 5.0);
    EXPECT_NEAR(scenario.durationS, 14.0, 1e-9);
    const auto player = playerOf(scenario.scenario);
    const Geodetic at = LocalFrame(kOrigin).geodeticFromLocal(player->entities()[0].position);
    EXPECT_NEAR(at.latitudeDeg, 46.0025, 1e-7);
    EXPECT_FALSE(scenarioOf({flight("f", 100.0, 900.0)}, flatScene(0.0), {"dem.tif", "test", 50.0}));
}

TEST(TrackScenario, ObjectsComeAndGoWhenTheyWereRecorded)
{
    FlightTrack missile = flight("missile", 105.0, 900.0);
    missile.fixes.resize(5);
    missile.endS = 110.0;
    missile.kind = TrackKind::thing;
    const TrackScenario scenario = made({missile, flight("f", 100.0, 900.0)}, flatScene(0.0));
    ASSERT_EQ(scenario.scenario.entities.size(), 2u);
    EXPECT_EQ(scenario.scenario.entities[0].name, "f") << "what flies stands first";
    const auto player = playerOf(scenario.scenario);
    const auto presentAt = [&](double timeS)
    {
        while (player->timeS() < timeS - 1e-6 && !player->isFinished())
            player->step();
        return player->entities()[1].isPresent;
    };
    EXPECT_FALSE(presentAt(4.0));
    EXPECT_TRUE(presentAt(6.0));
    EXPECT_FALSE(presentAt(11.0));
}

TEST(TrackScenario, SaysWhereARecordingIsThatIsNotOverTheTerrain)
{
    const SceneFrame nowhere(kOrigin, [](double, double, double) { return std::optional<GroundSample>(); });
    const auto refused = scenarioOf({flight("f", 0.0, 900.0)}, nowhere, {"dem.tif", "test", 0.0});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message().find("46.0000"), std::string::npos) << refused.error().message();
}

/// A ridge between two fixes that are 55 m apart, 30 m above the line between them.
GroundProvider ridge()
{
    return [](double, double north, double)
    { return GroundSample{500.0 + 445.0 * std::exp(-std::pow((north - 250.0) / 20.0, 2.0))}; };
}

double deepest(const FollowTrajectoryAction& action)
{
    Scenario scenario;
    Vehicle vehicle;
    vehicle.name = vehicle.category = "aircraft";
    scenario.entities.push_back({{}, "Ego", vehicle});
    scenario.storyboard.init.privates.push_back({{}, "Ego", {action}});
    const auto player = playerOf(std::move(scenario), ridge(), 100);
    double deepest = 0.0;
    for (int i = 0; i < 1900 && !player->isFinished(); ++i, player->step())
    {
        const glm::dvec3& at = player->entities()[0].position;
        deepest = std::max(deepest, ridge()(at.x, at.y, at.z)->heightM - at.z);
    }
    return deepest;
}

TEST(TrackClearance, TheCurveBetweenFixesStaysAboveTheGround)
{
    FlightTrack track = flight("f", 0.0, 900.0);
    const SceneFrame scene(kOrigin, ridge());
    fitToGround(track, groundHeightOf(scene));
    auto action = trajectoryOf(track);
    ASSERT_TRUE(action);
    EXPECT_GT(deepest(*action), 10.0) << "without it the curve is below the ridge";
    const TrackClearance done = keepAboveGround(*action, scene);
    EXPECT_GT(done.addedVertices, 0u);
    EXPECT_GT(done.deepestM, 10.0);
    EXPECT_LT(deepest(*action), 4.0)
        << "the ridge's sides are walls; on real ground see the table of flights";
}

TEST(TrackMotion, TellsFlyingDrivingAndWalkingApart)
{
    const auto ground = [](double, double) { return std::optional(0.0); };
    FlightTrack track = flight("f", 0.0, 900.0);
    track.kind = TrackKind::unknown;
    EXPECT_EQ(kindByMotion(track, ground), TrackKind::aircraft);
    for (TrackFix& fix : track.fixes)
        fix.heightM = 1.0;
    EXPECT_EQ(kindByMotion(track, ground), TrackKind::vehicle);
    for (TrackFix& fix : track.fixes)
        fix.timeS *= 240.0;
    EXPECT_EQ(kindByMotion(track, ground), TrackKind::person);
}

TEST(TrackTrajectory, AWayOverALongGapIsStraight)
{
    FlightTrack track = flight("f", 0.0, 900.0);
    track.fixes.push_back({619.0, 46.0095, 8.2, 957.0, 21});
    track.fixes.push_back({620.0, 46.0090, 8.2, 957.0, 22});
    const auto action = trajectoryOf(track);
    ASSERT_TRUE(action);
    const auto& vertices = std::get<Polyline>(action->trajectory.shape).vertices;
    EXPECT_GE(vertices.size(), 22u + 40u);
    for (const Vertex& vertex : vertices)
    {
        if (*vertex.timeS <= 19.0 || *vertex.timeS >= 619.0) continue;
        const double share = (*vertex.timeS - 19.0) / 600.0;
        EXPECT_NEAR(std::get<GeoPosition>(vertex.position).longitudeDeg, 8.0361 + share * 0.1639, 1e-9);
    }
}

TEST(Acmi, TellsKindAttitudeAndEndOfObjects)
{
    const auto reading =
        parseAcmi("#0\n1,T=8|46|900|10|5|90,Type=Air+Rotorcraft,Name=h\n2,T=8|46|0||||1|1|150,Type=Sea+"
                  "Watercraft\n3,T=8|46|1|5|6,Type=Navaid+Static\n#1\n1,T=|46.1|||6|\n#2\n-1\n",
                  "a.acmi");
    ASSERT_TRUE(reading) << reading.error().message();
    ASSERT_EQ(reading->tracks.size(), 3u);
    const FlightTrack& helicopter = reading->tracks[0];
    EXPECT_EQ(helicopter.kind, TrackKind::helicopter);
    EXPECT_EQ(helicopter.endS, 2.0);
    ASSERT_EQ(helicopter.fixes.size(), 2u);
    EXPECT_EQ(helicopter.fixes[1].attitude->rollDeg, 10.0);
    EXPECT_EQ(helicopter.fixes[1].attitude->pitchDeg, 6.0);
    EXPECT_EQ(reading->tracks[1].fixes[0].attitude->yawDeg, 150.0) << "the heading on the map, without a yaw";
    EXPECT_EQ(reading->tracks[1].kind, TrackKind::ship);
    EXPECT_EQ(reading->tracks[2].kind, TrackKind::mark);
    EXPECT_FALSE(reading->tracks[2].fixes[0].attitude) << "five parts are no attitude";

    const auto action = trajectoryOf(helicopter);
    ASSERT_TRUE(action);
    const Orientation pose =
        std::get<GeoPosition>(std::get<Polyline>(action->trajectory.shape).vertices[0].position).orientation;
    EXPECT_NEAR(*pose.headingRad, 0.0, 1e-12) << "east";
    EXPECT_LT(*pose.pitchRad, 0.0) << "nose up is negative";
    EXPECT_GT(*pose.rollRad, 0.0);
}

TEST(ReadTrack, ReadsWhatGzipHasCompressedAndNumbersTracksOfOneName)
{
    const testsupport::TestFolder folder("tracks");
    const std::string text = "#0\n1,T=8|46|0,Name=a\n2,T=8|46|0,Name=a\n3,T=8|46|0\n";
    const std::filesystem::path file = folder / "two.acmi.gz";
    gzFile out = gzopen(file.c_str(), "wb");
    gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
    gzclose(out);
    EXPECT_TRUE(isTrackFile(file));
    const auto reading = readTracks(file);
    ASSERT_TRUE(reading) << reading.error().message();
    EXPECT_EQ(reading->tracks[0].name, "a");
    EXPECT_EQ(reading->tracks[1].name, "a 2");
    EXPECT_EQ(reading->tracks[2].name, "3");
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 6);
    EXPECT_FALSE(readTracks(file));
    EXPECT_FALSE(isTrackFile("a.xosc"));
}

} // namespace
} // namespace simulation
