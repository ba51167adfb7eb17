// SPDX-License-Identifier: Apache-2.0
// Six of esmini's storyboards: the instants at which their events begin and end, worked out by hand from the
// files, against the log of the storyboard. The working stands beside each. Triggers are looked at every 0.01
// s; what begins at t moves with the step after it, and an event ends in the step after the last of its
// actions, so a chain of events may be later by a step for each link.
#include <cmath>

#include <gtest/gtest.h>

#include "SimulatedTrack.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

struct Instant
{
    const char* element; ///< the end of its path
    bool isEnd;
    double timeS;
    double toleranceS = 0.015;
};

struct WorkedScenario
{
    const char* name;
    std::vector<Instant> instants;
    double endS;
    double endToleranceS = 0.035;
};

class HandWorked : public testing::TestWithParam<WorkedScenario>
{
};

std::unique_ptr<ScenarioPlayer> playedOut(const std::string& name,
                                          const std::map<std::string, std::string>& parameters)
{
    const auto file = *realData() / "openscenario" / "esmini" / "xosc" / (name + ".xosc");
    auto parsed = readScenario(file, {.tolerant = true, .parameters = parameters});
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return nullptr;
    PlayerOptions options;
    options.clock = FixedClock::forStep(0.01);
    auto roads = RoadScene::open(file.parent_path() / parsed->scenario.roadNetwork.logicFile);
    EXPECT_TRUE(roads) << roads.error().message();
    if (!roads) return nullptr;
    options.roads = *roads;
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return nullptr;
    while (!(*player)->isFinished() && (*player)->timeS() < 100.0)
        (*player)->step();
    return std::move(*player);
}

double timeOf(const ScenarioPlayer& player, const Instant& instant)
{
    const auto wanted =
        instant.isEnd ? StoryboardElementState::endTransition : StoryboardElementState::startTransition;
    for (const StoryboardLogEntry& entry : player.log())
        if (entry.transition == wanted && entry.path.ends_with(std::string("::") + instant.element))
            return entry.timeS;
    return -1.0;
}

TEST_P(HandWorked, EventsComeWhenTheFileSaysSo)
{
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    const auto player = playedOut(GetParam().name, {});
    ASSERT_TRUE(player);
    for (const Instant& instant : GetParam().instants)
    {
        const double timeS = timeOf(*player, instant);
        if (std::getenv("OSGTRAINER_PRINT_DIFFERENCES"))
            std::printf("| `%s` | %s %s | %.3f | %.2f |\n", GetParam().name, instant.element,
                        instant.isEnd ? "ends" : "begins", instant.timeS, timeS);
        EXPECT_NEAR(timeS, instant.timeS, instant.toleranceS) << instant.element;
    }
    EXPECT_NEAR(player->timeS(), GetParam().endS, GetParam().endToleranceS) << "the stop trigger";
}

INSTANTIATE_TEST_SUITE_P(
    Table, HandWorked,
    testing::Values(
        // Ego at 20 m/s from s = 50 m, the other one at 25 m/s from 30 m, 3.1 m to the left. Ego's front is
        // 1.4 + 2.52 = 3.92 m ahead of its point, the other's back 2.52 − 1.45 = 1.07 m behind: the free gap
        // is 5t − 24.99 m. Above 0.4 s · 20 m/s = 8 m: t > 6.598 s. The change takes 3 s. Above 20 m: t >
        // 8.998 s; the way sideways has cost 0.06 m by then, and the corner of the turned car is 0.04 m
        // nearer: 0.02 s more. From 25 m/s at 5 m/s²: 5 s. Then the acceleration is 0, and the play ends 2 s
        // later.
        WorkedScenario{"cut-in_simple",
                       {{"CutInEvent", false, 6.60},
                        {"CutInAction", true, 9.60, 0.025},
                        {"BrakeEvent", false, 9.02},
                        {"BrakeAction", true, 14.01, 0.03}},
                       16.02},
        // "greater than 2 s" and "greater than 4.3 s" hold a step later. 2 s from 30 to 40 m/s. The teleport
        // and the stop take no time.
        WorkedScenario{"drop-bike",
                       {{"accelerate event", false, 2.01},
                        {"accelerate action", true, 4.01},
                        {"drop of bike", false, 4.31},
                        {"stop moving", true, 4.32}},
                       8.01},
        // "at least 2 s"; the entries of the profile last 0 + 4 + 4 + 2 s. Followed smoothly it takes as
        // long.
        WorkedScenario{"speed-profile",
                       {{"SpeedProfileEvent", false, 2.0},
                        {"SpeedProfileAction2", true, 12.0},
                        {"SpeedProfileEvent1", false, 2.0}},
                       14.01},
        // Ego's point is 50 m before s = 109 m at s = 59 m: 49 m at 13.889 m/s are 3.528 s. Yellow lasts 3 s,
        // red 10 s, pedestrians have green 3 s and red 9 s after red. Braking to a stand over 44 m takes 2 ·
        // 44 / 13.889 = 6.336 s. Ego drives on 0.5 s after green, in 5 s; pedestrians walk 0.5 and 1 s after
        // theirs.
        WorkedScenario{"traffic_lights",
                       {{"StopLightEvent", false, 3.53},
                        {"StopLightEvent2", false, 6.53, 0.025},
                        {"StopLightEvent3", false, 16.53, 0.035},
                        {"PedestrianLightEvent", false, 9.53, 0.035},
                        {"PedestrianLightEvent2", false, 15.53, 0.035},
                        {"StopOnRedEvent", false, 3.53, 0.025},
                        {"StopOnYellowAction", true, 3.53 + 6.336, 0.035},
                        {"DriveOnGreenEvent", false, 17.03, 0.035},
                        {"DriveOnGreenAction", true, 22.03, 0.045},
                        {"WalkOnGreenEvent1", false, 10.03, 0.045},
                        {"WalkOnGreenEvent2", false, 10.53, 0.045}},
                       30.01},
        // After 4 s, 2 s to the left; 1 s later 8 m aside at 3.5 m/s² at most: π · √(8 / (2 · 3.5)) = 3.358
        // s. The parameter is set after 3 s, the truck waits for it, and changes in 2 s.
        WorkedScenario{"lane_change",
                       {{"Lane change Ego event", false, 4.01},
                        {"Lane change Ego action", true, 6.01, 0.025},
                        {"EgoGoOffRoadEvent", false, 7.01, 0.035},
                        {"EgoGoOffRoadAction", true, 7.01 + 3.358, 0.045},
                        {"Dummy parameter event", false, 3.01},
                        {"Lane change Target event", false, 3.01, 0.025},
                        {"Lane change Target action", true, 5.01, 0.035}},
                       17.05,
                       0.05},
        // Lamps after 2 s; 2 s after that the car drives off to 15 m/s, sinusoidally: in 3 s it would need
        // π/2 · 5 m/s², more than its 5 m/s², so it takes π/2 · 3 s = 4.712 s; 1 s later it changes its lane
        // in 2 s, and the indicator goes off 1 s after that. Dusk, night and dawn come at 7, 12 and 16 s.
        WorkedScenario{"light_state",
                       {{"eventStartCar", false, 2.01},
                        {"eventDrive", false, 4.01, 0.035},
                        {"actionDrive", true, 8.72, 0.025},
                        {"eventLaneChangeLeft", false, 9.73, 0.025},
                        {"actionLaneChangeLeft", true, 11.73, 0.025},
                        {"eventLaneChangeLeftComplete", false, 12.73, 0.025},
                        {"duskEvent", false, 7.0},
                        {"nightEvent", false, 12.0},
                        {"dawnEvent", false, 16.0}},
                       40.01}),
    [](const testing::TestParamInfo<WorkedScenario>& test)
    {
        std::string name = test.param.name;
        std::erase_if(name, [](char c) { return c == '-' || c == '_'; });
        return name;
    });

/// The instants are those of the file: another headway moves the cut-in. 5t − 24.99 m > 0.5 s · 20 m/s: t >
/// 6.998 s.
TEST(HandWorked, AnotherHeadwayMovesTheEvent)
{
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    const auto player = playedOut("cut-in_simple", {{"HeadwayTime_LaneChange", "0.5"}});
    ASSERT_TRUE(player);
    EXPECT_NEAR(timeOf(*player, {"CutInEvent", false, 0.0}), 7.0, 0.015);
}

} // namespace
} // namespace simulation
