// SPDX-License-Identifier: Apache-2.0
// Trajectories that are recorded tracks of a file beside the scenario.
#include "simulation/track/LayRecordings.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "../simulation/ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/track/TrackGeoid.h"
#include "simulation/writer/WriteScenario.h"

namespace simulation
{
namespace
{

const std::string kTable =
    "time,latitude,longitude,altitude\n100,46,8,500\n110,46.001,8,500\n130,46.001,8.002,520\n";

/// A folder with a table of a flight: at 46° N, 8° E; 0.001° north in 10 s, then 0.002° east and 20 m up in
/// 20 s.
class Recordings : public testing::Test
{
protected:
    Recordings() : folder(std::filesystem::path(testing::TempDir()) / "recordings_test")
    {
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "flight.csv") << kTable;
    }
    ~Recordings() override { std::filesystem::remove_all(folder); }

    /// An aircraft that follows a file's track.
    static std::string aircraftOn(const std::string& file, const std::string& track,
                                  const std::string& timing = kTiming,
                                  const std::string& category = "aircraft")
    {
        std::string aircraft = kCar;
        aircraft.replace(aircraft.find("\"car\">"), 6, "\"" + category + "\">");
        ScenarioText text;
        text.entities = "<ScenarioObject name=\"Ego\">" + aircraft + "</ScenarioObject>";
        std::string follow = followTrajectory("", timing);
        const std::size_t begin = follow.find("<Trajectory "), end = follow.find("</TrajectoryRef>");
        follow.replace(begin, end - begin,
                       "<CatalogReference catalogName=\"" + file + "\" entryName=\"" + track + "\"/>");
        text.privates = speedAction(20.0) + follow;
        text.stop = stopAt(1000.0);
        return text.text();
    }

    /// The scenario with its recordings laid, or the message.
    foundation::Result<Scenario> laid(const std::string& text, const SceneFrame* frame = nullptr) const
    {
        std::ofstream(folder / "test.xosc") << text;
        auto read = readScenario(folder / "test.xosc");
        if (!read) return read.error();
        const auto notes = layRecordings(read->scenario, {folder / "test.xosc", frame});
        if (!notes) return notes.error();
        return std::move(read->scenario);
    }

    std::filesystem::path folder;
};

EntityState stateAt(Scenario scenario, double timeS, const GroundProvider& ground = {})
{
    PlayerOptions options;
    options.origin = Geodetic{46.0, 8.0, 0.0};
    options.ground = ground;
    options.clock = FixedClock(10);
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return {};
    while ((*player)->timeS() < timeS - 1e-9)
        (*player)->step();
    return (*player)->entities()[0];
}

TEST_F(Recordings, AreFollowedByTheirTimesFromTheirStart)
{
    const auto scenario = laid(aircraftOn("flight.csv", ""));
    ASSERT_TRUE(scenario) << scenario.error().message();
    // A degree of latitude is 111.14 km there, one of longitude 77.47 km; 0.001 degrees in 10 s.
    const EntityState half = stateAt(*scenario, 5.0);
    EXPECT_NEAR(half.position.y, 55.6, 0.2);
    EXPECT_NEAR(half.position.x, 0.0, 0.01);
    EXPECT_NEAR(half.speedMps, 11.1, 0.1);
    const EntityState later = stateAt(*scenario, 20.0);
    EXPECT_NEAR(later.position.x, 77.5, 0.3);
    EXPECT_NEAR(later.position.z, 510.0 + geoidHeightM(46.0, 8.0), 0.1);
}

TEST_F(Recordings, WithoutTimeReferenceAreFollowedAtTheSpeedOfTheEntity)
{
    const auto scenario = laid(aircraftOn("flight.csv", "flight", "<None/>"));
    ASSERT_TRUE(scenario) << scenario.error().message();
    EXPECT_NEAR(stateAt(*scenario, 5.0).position.y, 100.0, 0.5);
}

TEST_F(Recordings, OfOneOnTheGroundAreLeftToIt)
{
    const auto scenario = laid(aircraftOn("flight.csv", "", kTiming, "car"));
    ASSERT_TRUE(scenario) << scenario.error().message();
    const GroundProvider ground = [](double, double) { return GroundSample{33.0}; };
    EXPECT_NEAR(stateAt(*scenario, 5.0, ground).position.z, 33.0, 0.01);
}

TEST_F(Recordings, StayAboveTheGroundOfAFrame)
{
    const double seaM = geoidHeightM(46.0, 8.0);
    const GroundProvider ground = [seaM](double, double) { return GroundSample{505.0 + seaM}; };
    const SceneFrame frame(Geodetic{46.0, 8.0, 0.0}, ground);
    const auto scenario = laid(aircraftOn("flight.csv", ""), &frame);
    ASSERT_TRUE(scenario) << scenario.error().message();
    EXPECT_NEAR(stateAt(*scenario, 5.0, ground).position.z, 505.0 + seaM, 0.1);
    EXPECT_GT(stateAt(*scenario, 25.0, ground).position.z, 510.0 + seaM);
}

TEST_F(Recordings, AreWrittenByTheirNames)
{
    const auto scenario = laid(aircraftOn("flight.csv", "flight"));
    ASSERT_TRUE(scenario);
    const auto text = simulation::scenarioText(*scenario);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("catalogName=\"flight.csv\" entryName=\"flight\""), std::string::npos) << *text;
}

TEST_F(Recordings, TellWhatIsWrongWithTheLineOfTheScenario)
{
    std::ofstream(folder / "untimed.csv") << "latitude,longitude\n46,8\n46.001,8\n";
    std::ofstream(folder / "broken.gpx") << "<gpx><trk>";
    struct Case
    {
        std::string file, track, message;
    };
    for (const Case& one : {Case{"none.igc", "", "no such file"},
                            Case{"flight.csv", "other", "write as entryName one of: flight"},
                            Case{"broken.gpx", "", "broken.gpx"},
                            Case{"untimed.csv", "", "has no times; write <None/> as its TimeReference"}})
    {
        const auto scenario = laid(aircraftOn(one.file, one.track));
        ASSERT_FALSE(scenario) << one.file;
        const std::string message = scenario.error().message();
        EXPECT_NE(message.find(one.message), std::string::npos) << message;
        EXPECT_NE(message.find("test.xosc:"), std::string::npos) << message;
    }
}

} // namespace
} // namespace simulation
