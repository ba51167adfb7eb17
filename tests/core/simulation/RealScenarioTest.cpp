// SPDX-License-Identifier: Apache-2.0
// Scenarios that others wrote, and what another simulator does with them.
#include <cmath>
#include <fstream>
#include <iterator>

#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include "SimulatedTrack.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/road/ScenarioRoads.h"

#define SKIP_WITHOUT_REAL_DATA()                                                                             \
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested"

namespace simulation
{
namespace
{

constexpr double kPositionToleranceM = 0.05;
constexpr double kHeadingToleranceDeg = 0.1;
constexpr int kStepsPerSecond = 100;

struct Deviation
{
    double positionM = 0.0;
    double headingDeg = 0.0;
    std::size_t rows = 0;
};

/// Plays a scenario beside a track and takes the largest deviations over the rows from `fromS` to `toS`.
Deviation deviation(const Scenario& scenario, const SimulatedTrack& track, int entity, double fromS,
                    double toS)
{
    PlayerOptions options;
    options.clock = FixedClock(kStepsPerSecond);
    foundation::Result<std::unique_ptr<ScenarioPlayer>> player = ScenarioPlayer::create(scenario, options);
    EXPECT_TRUE(player) << player.error().message();
    Deviation worst;
    if (!player) return worst;
    const auto& x = track.column(entity, "World_Position_X");
    const auto& y = track.column(entity, "World_Position_Y");
    const auto& heading = track.column(entity, "World_Heading_Angle");
    for (std::size_t row = 0; row < track.timeS.size(); ++row)
    {
        const double time = track.timeS[row];
        while ((*player)->timeS() < time - 1e-6 && !(*player)->isFinished())
            (*player)->step();
        if (time < fromS || time > toS || std::fabs((*player)->timeS() - time) > 1e-6) continue;
        const EntityState& state = (*player)->entities()[static_cast<std::size_t>(entity - 1)];
        worst.positionM =
            std::max(worst.positionM, std::hypot(state.position.x - x[row], state.position.y - y[row]));
        const double difference = state.headingDeg - foundation::degreesOf(heading[row]);
        worst.headingDeg = std::max(worst.headingDeg, std::fabs(std::remainder(difference, 360.0)));
        ++worst.rows;
    }
    return worst;
}

std::vector<std::filesystem::path> scenarioFiles()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*realData() / "openscenario"))
        if (entry.path().extension() == ".xosc") files.push_back(entry.path());
    return files;
}

TEST(RealScenario, EveryFileIsReadTolerantlyOrRefusedByName)
{
    SKIP_WITHOUT_REAL_DATA();
    std::size_t scenarios = 0;
    std::size_t catalogues = 0;
    for (const std::filesystem::path& file : scenarioFiles())
    {
        const auto parsed = readScenario(file, {.tolerant = true, .parameters = {}});
        if (!parsed)
        {
            ++catalogues;
            EXPECT_NE(parsed.error().what.find("no Storyboard"), std::string::npos)
                << parsed.error().message();
            continue;
        }
        ++scenarios;
        for (const Problem& problem : parsed->problems)
            EXPECT_NE(problem.error.place.find(".xosc:"), std::string::npos) << problem.error.message();
        PlayerOptions options;
        auto roads = openRoads(parsed->scenario, file.parent_path());
        ASSERT_TRUE(roads) << file << roads.error().message();
        options.roads = *roads;
        auto player = ScenarioPlayer::create(parsed->scenario, options);
        ASSERT_TRUE(player) << file << player.error().message();
        for (int i = 0; i < 200; ++i)
            (*player)->step();
    }
    EXPECT_EQ(scenarios, 37u);
    EXPECT_EQ(catalogues, 14u);
}

TEST(RealScenario, ProblemsOfRealFilesAreOnlyWhatIsNotSupportedYet)
{
    SKIP_WITHOUT_REAL_DATA();
    for (const std::filesystem::path& file : scenarioFiles())
    {
        const auto parsed = readScenario(file, {.tolerant = true, .parameters = {}});
        if (!parsed) continue;
        for (const Problem& problem : parsed->problems)
            EXPECT_LE(problem.kind, Problem::Kind::unsupported) << problem.error.message();
    }
}

TEST(RealScenario, WorldPositionTrajectoryPlaysAsRecorded)
{
    SKIP_WITHOUT_REAL_DATA();
    const std::filesystem::path folder = *realData() / "openscenario" / "esmini";
    const auto parsed = readScenario(folder / "xosc" / "lane-change_trajectory_wp.xosc");
    ASSERT_TRUE(parsed) << parsed.error().message();
    const SimulatedTrack track =
        readSimulatedTrack(folder / "tracks" / "lane-change_trajectory_wp.10hz.csv.gz");
    const Deviation worst = deviation(parsed->scenario, track, 1, 0.0, 100.0);
    EXPECT_EQ(worst.rows, 81u);
    EXPECT_LT(worst.positionM, kPositionToleranceM);
    EXPECT_LT(worst.headingDeg, kHeadingToleranceDeg);
    RecordProperty("positionM", std::to_string(worst.positionM));
    RecordProperty("headingDeg", std::to_string(worst.headingDeg));
}

TEST(RealScenario, ComparisonNoticesATenthOfAMetreOrASmoothedPath)
{
    SKIP_WITHOUT_REAL_DATA();
    const std::filesystem::path folder = *realData() / "openscenario" / "esmini";
    const auto parsed = readScenario(folder / "xosc" / "lane-change_trajectory_wp.xosc");
    ASSERT_TRUE(parsed);
    const SimulatedTrack track =
        readSimulatedTrack(folder / "tracks" / "lane-change_trajectory_wp.10hz.csv.gz");
    Scenario moved = parsed->scenario;
    auto& follow = std::get<FollowTrajectoryAction>(moved.storyboard.init.privates.front().actions.back());
    auto& vertices = std::get<Polyline>(follow.trajectory.shape).vertices;
    std::get<WorldPosition>(vertices[12].position).yM += 0.1;
    EXPECT_GT(deviation(moved, track, 1, 0.0, 100.0).positionM, kPositionToleranceM);
    std::get<WorldPosition>(vertices[12].position).yM -= 0.1;
    follow.mode = FollowingMode::follow;
    EXPECT_GT(deviation(moved, track, 1, 0.0, 100.0).headingDeg, kHeadingToleranceDeg);
}

/// The polyline that the recorded entity 2 of trajectory-test ran from 1.99 s to 7.99 s: its corners lie
/// where the recorded straight motions meet, a hundredth of a second before a row. (The scenario itself
/// places its vertices on a road.)
std::vector<glm::dvec2> recordedCorners(const SimulatedTrack& track)
{
    const auto rowAt = [&](double time)
    { return static_cast<std::size_t>(std::lround((time - track.timeS.front()) * 10.0)); };
    const auto place = [&](double time, double shiftS)
    {
        const std::size_t row = rowAt(time);
        return glm::dvec2(track.column(2, "World_Position_X")[row] + shiftS * track.column(2, "Vel_X")[row],
                          track.column(2, "World_Position_Y")[row] + shiftS * track.column(2, "Vel_Y")[row]);
    };
    return {place(2.0, -0.01), place(4.0, -0.01), place(6.0, -0.01), place(7.9, 0.09)};
}

Scenario cornerScenario(const std::vector<glm::dvec2>& corners)
{
    Polyline polyline;
    for (std::size_t i = 0; i < corners.size(); ++i)
        polyline.vertices.push_back(
            {{}, 1.99 + 2.0 * static_cast<double>(i), WorldPosition{{}, corners[i].x, corners[i].y, {}, {}}});
    FollowTrajectoryAction follow;
    follow.timing = Timing{Timing::Domain::absolute, 1.0, 0.0};
    follow.trajectory.shape = polyline;
    Scenario scenario;
    for (const char* name : {"Ego", "Target"})
    {
        MiscObject object;
        object.box.lengthM = 4.0;
        scenario.entities.push_back({{}, name, object});
    }
    scenario.storyboard.init.privates.push_back({{}, "Target", {follow}});
    return scenario;
}

TEST(RealScenario, TimedPolylineWithoutHeadingsPlaysAsRecorded)
{
    SKIP_WITHOUT_REAL_DATA();
    const SimulatedTrack track = readSimulatedTrack(*realData() / "openscenario" / "esmini" / "tracks" /
                                                    "trajectory-test.10hz.csv.gz");
    std::vector<glm::dvec2> corners = recordedCorners(track);
    const Deviation worst = deviation(cornerScenario(corners), track, 2, 1.999, 7.95);
    EXPECT_EQ(worst.rows, 60u);
    EXPECT_LT(worst.positionM, kPositionToleranceM);
    EXPECT_LT(worst.headingDeg, kHeadingToleranceDeg);
    corners[1].y += 0.1;
    EXPECT_GT(deviation(cornerScenario(corners), track, 2, 1.999, 7.95).positionM, kPositionToleranceM);
}

} // namespace
} // namespace simulation
