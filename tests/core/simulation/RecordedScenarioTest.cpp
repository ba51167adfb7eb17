// SPDX-License-Identifier: Apache-2.0
// Every storyboard of esmini that is stored with its track, played headless and compared with it, row by row.
#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "SimulatedTrack.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/EntityDistance.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/record/CompareMotions.h"

namespace simulation
{
namespace
{

constexpr double kLongestS = 60.1; ///< of the tracks

/// A storyboard, and the entities that still differ from its track (docs/measurements/scenarios.md says why);
/// "*": all.
struct RecordedScenario
{
    const char* name;
    std::vector<std::string> differing;
    std::vector<std::string> otherEvents{}; ///< entities with an event that is elsewhere, or missing
};

void note(MotionTable& table, const ScenarioPlayer& player)
{
    table.timeS.push_back(player.timeS());
    const std::vector<EntityState>& states = player.entities();
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        if (table.tracks.size() <= i) table.tracks.push_back({states[i].name, {}});
        table.tracks[i].samples.push_back(MotionSample{
            states[i].position, glm::radians(states[i].headingDeg), states[i].speedMps,
            states[i].laneUnder ? states[i].laneUnder->lane : 0, !states[i].collidesWith.empty()});
    }
}

/// What the player does with a storyboard, at every tenth step of a hundredth of a second.
MotionTable played(const std::filesystem::path& file)
{
    MotionTable table;
    auto parsed = readScenario(file, {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return table;
    PlayerOptions options;
    options.clock = FixedClock::forStep(0.01);
    auto roads = RoadScene::open(file.parent_path() / parsed->scenario.roadNetwork.logicFile);
    EXPECT_TRUE(roads) << roads.error().message();
    if (!roads) return table;
    options.roads = *roads;
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return table;
    note(table, **player);
    for (int step = 1; !(*player)->isFinished() && (*player)->timeS() < kLongestS; ++step)
    {
        (*player)->step();
        if (step % 10 == 0) note(table, **player);
    }
    return table;
}

std::filesystem::path folder()
{
    return *realData() / "openscenario" / "esmini";
}

MotionTable recorded(const std::string& name)
{
    auto table = readMotionTable(folder() / "tracks" / (name + ".10hz.csv.gz"));
    EXPECT_TRUE(table) << table.error().message();
    return table ? std::move(*table) : MotionTable{};
}

/// The tracks name no collisions: they are found from where the boxes of the scenario were.
void findCollisions(MotionTable& reference, const std::filesystem::path& file)
{
    auto parsed = readScenario(file, {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    for (std::size_t row = 0; row < reference.timeS.size(); ++row)
    {
        std::vector<EntityState> states(reference.tracks.size());
        std::vector<MeasuredBody> bodies;
        for (std::size_t i = 0; i < states.size(); ++i)
        {
            const int entity = parsed->scenario.entityIndex(reference.tracks[i].entity);
            const auto& sample = reference.tracks[i].samples[row];
            if (entity < 0 || !sample) continue;
            states[i].position = sample->position;
            states[i].headingDeg = glm::degrees(sample->headingRad);
            bodies.push_back({&states[i], parsed->scenario.entities[static_cast<std::size_t>(entity)].box()});
        }
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t j = 0; j < bodies.size(); ++j)
                if (i != j && overlap(bodies[i], bodies[j]))
                    reference.tracks[static_cast<std::size_t>(bodies[i].state - states.data())]
                        .samples[row]
                        ->collides = true;
    }
}

class Recorded : public testing::TestWithParam<RecordedScenario>
{
};

TEST_P(Recorded, StoryboardMovesItsEntitiesAsEsminiDoes)
{
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    const RecordedScenario& scenario = GetParam();
    MotionTable reference = recorded(scenario.name);
    const MotionTable table = played(folder() / "xosc" / (std::string(scenario.name) + ".xosc"));
    const bool prints = std::getenv("OSGTRAINER_PRINT_DIFFERENCES") != nullptr;
    for (const MotionDifference& difference : compareMotions(table, reference))
    {
        if (prints)
            std::printf("| `%s` | %s | %zu | %.4f | %.2f | %.4f | %.2f | %zu |\n", scenario.name,
                        difference.entity.c_str(), difference.rows, difference.positionM.largest,
                        difference.positionM.largestAtS, difference.headingDeg.largest,
                        difference.headingDeg.largestAtS, difference.unmatchedRows);
        const bool isKnown =
            std::any_of(scenario.differing.begin(), scenario.differing.end(),
                        [&](const std::string& name) { return name == "*" || name == difference.entity; });
        EXPECT_NE(isWithin(difference, {}), isKnown)
            << difference.entity << ": " << difference.positionM.largest << " m at "
            << difference.positionM.largestAtS << " s, " << difference.headingDeg.largest << " degrees at "
            << difference.headingDeg.largestAtS << " s, " << difference.unmatchedRows << " rows missing";
    }
}

TEST_P(Recorded, LaneChangesCollisionsAndKinksOfSpeedComeWithinATenthOfASecond)
{
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    const RecordedScenario& scenario = GetParam();
    const auto file = folder() / "xosc" / (std::string(scenario.name) + ".xosc");
    MotionTable reference = recorded(scenario.name);
    findCollisions(reference, file);
    const MotionTable table = played(file);
    const bool prints = std::getenv("OSGTRAINER_PRINT_DIFFERENCES") != nullptr;
    for (const EventDifference& events : compareEvents(table, reference))
    {
        if (prints)
            std::printf("| `%s` | %s | %zu | %zu | %.1f | %zu | %zu | %.1f | %zu | %zu | %.1f |\n",
                        scenario.name, events.entity.c_str(), events.laneChanges.count,
                        events.laneChanges.unmatched, events.laneChanges.largestS, events.collisions.count,
                        events.collisions.unmatched, events.collisions.largestS, events.speedKinks.count,
                        events.speedKinks.unmatched, events.speedKinks.largestS);
        const bool isKnown = std::find(scenario.otherEvents.begin(), scenario.otherEvents.end(),
                                       events.entity) != scenario.otherEvents.end();
        EXPECT_NE(isWithin(events, 0.1 + 1e-6), isKnown) << events.entity;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Esmini, Recorded,
    testing::Values(RecordedScenario{"acc-test", {}}, RecordedScenario{"cut-in", {}},
                    RecordedScenario{"cut-in_cr", {}, {"Truck"}}, RecordedScenario{"cut-in_environment", {}},
                    RecordedScenario{"cut-in_simple", {}}, RecordedScenario{"cut-in_visibility", {}},
                    RecordedScenario{"drop-bike", {}, {"bike"}},
                    RecordedScenario{"lane-change_clothoid_spline_based_trajectory", {"Car"}, {"Car"}},
                    RecordedScenario{"lane-change_trajectory_wp", {}},
                    RecordedScenario{"lane_change", {}, {"Ego"}}, RecordedScenario{"light_state", {}},
                    RecordedScenario{"ltap-od", {}}, RecordedScenario{"pedestrian", {}},
                    RecordedScenario{"pedestrian_collision", {}}, RecordedScenario{"speed-profile", {}},
                    RecordedScenario{"straight_500m", {}}, RecordedScenario{"synchronize", {}},
                    RecordedScenario{"traffic_lights", {}},
                    RecordedScenario{"trailers",
                                     {},
                                     {"Ego+", "Semi_truck_with_extra_trailer+",
                                      "Semi_truck_with_extra_trailer++", "Semi_trailer"}},
                    RecordedScenario{"trajectory-test", {}, {"Target"}}, RecordedScenario{"tunnels", {}},
                    RecordedScenario{"velodrome", {}}),
    [](const testing::TestParamInfo<RecordedScenario>& test)
    {
        std::string name = test.param.name;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == '-' || c == '_'; }, 'X');
        return name;
    });

TEST(RecordedScenario, AShiftOfSixCentimetresIsNoticed)
{
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    MotionTable reference = recorded("straight_500m");
    const MotionTable table = played(folder() / "xosc" / "straight_500m.xosc");
    EXPECT_TRUE(isWithin(compareMotions(table, reference).front(), {}));
    for (auto& sample : reference.tracks.front().samples)
        sample->position.y += 0.06;
    EXPECT_FALSE(isWithin(compareMotions(table, reference).front(), {}));
}

} // namespace
} // namespace simulation
