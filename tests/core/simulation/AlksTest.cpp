// SPDX-License-Identifier: Apache-2.0
// The fifteen storyboards of UN R157: positions, gaps and instants at their triggers, against what each file
// says. Nobody plays the ALKS controller here, so Ego keeps its 60 km/h (v = 16.667 m/s) on lane -4 from s =
// 5 m. The cars are 5 m long, their fronts 3.9 m before and their backs 1.1 m behind the reference point; the
// pedestrian's back is at its reference point. Lanes are 3.5 m wide.
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "SimulatedTrack.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/EntityDistance.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

constexpr double kEgoMps = 60.0 / 3.6;
constexpr double kAlksStepS = 0.01;
constexpr double kInstantS = 0.025; ///< two steps, and half a one of rounding

/// A play with what it was like whenever an element of the storyboard changed.
class AlksPlay
{
public:
    explicit AlksPlay(const std::string& name, const std::map<std::string, std::string>& parameters = {})
    {
        const auto file = *realData() / "openscenario/alks/logical_scenarios/concrete_scenarios" /
                          ("alks_scenario_" + name + "_template.xosc");
        auto parsed = readScenario(file, {.tolerant = true, .parameters = parameters});
        EXPECT_TRUE(parsed) << parsed.error().message();
        if (!parsed) return;
        PlayerOptions options;
        options.clock = FixedClock::forStep(kAlksStepS);
        auto roads = RoadScene::open(file.parent_path() / parsed->scenario.roadNetwork.logicFile);
        EXPECT_TRUE(roads) << roads.error().message();
        if (!roads) return;
        options.roads = *roads;
        auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
        EXPECT_TRUE(player) << player.error().message();
        if (!player) return;
        _player = std::move(*player);
        _first = _player->entities();
        _before = _first;
        for (_roads = *roads; !_player->isFinished() && _player->timeS() < 400.0;)
            step();
    }

    bool isThere() const { return _player != nullptr; }
    double endS() const { return _player->timeS(); }
    const std::vector<EntityState>& atFirst() const { return _first; }
    const std::vector<EntityState>& atLast() const { return _player->entities(); }

    /// When an element begins or ends; -1: it never does.
    double begin(const std::string& name) const
    {
        return time(name, StoryboardElementState::startTransition);
    }
    double end(const std::string& name) const { return time(name, StoryboardElementState::endTransition); }

    /// The states when an element began or ended.
    const std::vector<EntityState>& statesAtBegin(const std::string& name) const
    {
        return _states.at(name + "+");
    }
    const std::vector<EntityState>& statesAtEnd(const std::string& name) const
    {
        return _states.at(name + "-");
    }

    /// When the boxes of the first entity and of another overlap first; -1: never.
    double collisionS() const { return _collisionS; }

    /// The free distance along the first one between two entities.
    double gapM(const std::vector<EntityState>& states, std::size_t from, std::size_t to) const
    {
        const auto body = [&](std::size_t index) {
            return MeasuredBody{&states[index], _player->scenario().entities[index].box()};
        };
        return distanceBetween(body(from), body(to),
                               {DistanceFrame::entity, DistanceKind::longitudinal, true}, _roads.get())
            .value_or(-1e9);
    }

    std::vector<EntityState> statesWhen(double timeS) const
    {
        const auto found = _byTime.find(static_cast<long>(std::lround(timeS / kAlksStepS)));
        return found == _byTime.end() ? std::vector<EntityState>() : found->second;
    }

private:
    void step()
    {
        _player->step();
        for (; _seen < _player->log().size(); ++_seen)
        {
            const StoryboardLogEntry& entry = _player->log()[_seen];
            const std::string name = entry.path.substr(
                entry.path.rfind("::") == std::string::npos ? 0 : entry.path.rfind("::") + 2);
            if (entry.transition == StoryboardElementState::startTransition)
                _states.emplace(name + "+", _player->entities());
            if (entry.transition == StoryboardElementState::endTransition)
                _states.emplace(name + "-", _player->entities());
        }
        if (_collisionS < 0.0 && !_player->entities()[0].collidesWith.empty()) _collisionS = _player->timeS();
        const long number = static_cast<long>(std::lround(_player->timeS() / kAlksStepS));
        if (number % 10 == 0) _byTime[number] = _player->entities();
    }

    double time(const std::string& name, StoryboardElementState transition) const
    {
        for (const StoryboardLogEntry& entry : _player->log())
            if (entry.path.ends_with("::" + name) && entry.transition == transition) return entry.timeS;
        return -1.0;
    }

    std::unique_ptr<ScenarioPlayer> _player;
    std::shared_ptr<const RoadScene> _roads;
    std::vector<EntityState> _first, _before;
    std::map<std::string, std::vector<EntityState>> _states;
    std::map<long, std::vector<EntityState>> _byTime;
    std::size_t _seen = 0;
    double _collisionS = -1.0;
};

/// Compares, and prints the row of docs/measurements/scenarios.md.
void expectNear(const char* file, const char* what, double measured, double expected, double tolerance)
{
    if (std::getenv("OSGTRAINER_PRINT_DIFFERENCES"))
        std::printf("| `%s` | %s | %.3f | %.3f |\n", file, what, expected, measured);
    EXPECT_NEAR(measured, expected, tolerance) << file << ": " << what;
}

/// The time of a sinusoidal change sideways whose greatest speed, or acceleration, is given.
double changeS(double metres, double mostMps)
{
    return 0.5 * std::numbers::pi * metres / mostMps;
}
double offsetS(double metres, double mostMps2)
{
    return std::numbers::pi * std::sqrt(0.5 * metres / mostMps2);
}

class Alks : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    }
};

TEST_F(Alks, FreeDrivingGoesFiveKilometres)
{
    const AlksPlay play("4_1_1_free_driving");
    ASSERT_TRUE(play.isThere());
    expectNear("4_1_1", "end, s", play.endS(), 5000.0 / kEgoMps, kInstantS);
    expectNear("4_1_1", "way of Ego on its lane, m", play.atLast()[0].odometerM, 5000.0, 0.5);
    EXPECT_EQ(play.atLast()[0].place->lane, -4);
}

TEST_F(Alks, TheLeadSwervesFourTimes)
{
    const AlksPlay play("4_1_2_swerving_lead_vehicle");
    ASSERT_TRUE(play.isThere());
    const double swerveS = offsetS(1.5, 0.3);
    expectNear("4_1_2", "gap at 0 s (2 s), m", play.gapM(play.atFirst(), 0, 1), 2.0 * kEgoMps, 0.01);
    expectNear("4_1_2", "SwerveEvent begins, s", play.begin("SwerveEvent"), 10.0, kInstantS);
    expectNear("4_1_2", "SwerveAction ends, s", play.end("SwerveAction"), 10.0 + swerveS, kInstantS);
    expectNear("4_1_2", "offset then, m", play.statesAtEnd("SwerveAction")[1].place->laneOffsetM, 1.5, 1e-3);
    expectNear("4_1_2", "SwerveEvent2 begins (5 s later), s", play.begin("SwerveEvent2"), 15.0 + swerveS,
               2 * kInstantS);
    expectNear("4_1_2", "SwerveAction3 ends, s", play.end("SwerveAction3"), 15.0 + 3.0 * swerveS,
               3 * kInstantS);
    expectNear("4_1_2", "offset then, m", play.statesAtEnd("SwerveAction3")[1].place->laneOffsetM, -1.5,
               1e-3);
    expectNear("4_1_2", "SwerveAction4 ends, s", play.end("SwerveAction4"), 20.0 + 4.0 * swerveS,
               4 * kInstantS);
    expectNear("4_1_2", "end, s", play.endS(), 50.0, kInstantS);
}

TEST_F(Alks, TheSideVehicleStaysBeside)
{
    const AlksPlay play("4_1_3_side_vehicle");
    ASSERT_TRUE(play.isThere());
    expectNear("4_1_3", "t of the truck from that of Ego, m",
               play.atFirst()[1].place->t - play.atFirst()[0].place->t, 3.0, 1e-6);
    expectNear("4_1_3", "the same at the end, m", play.atLast()[1].place->t - play.atLast()[0].place->t, 3.0,
               1e-6);
    expectNear("4_1_3", "end, s", play.endS(), 300.0, kInstantS);
}

TEST_F(Alks, BlockingTargetsAreReachedWhenTheFrontIsAtThem)
{
    // 5 m + v·t + 3.9 m = 500 m: after 29.466 s. The file ends 10 s after Ego's reference point would be
    // there.
    for (const char* const name : {"4_2_1_fully_blocking_target", "4_2_4_multiple_blocking_targets"})
    {
        const AlksPlay play(name);
        ASSERT_TRUE(play.isThere());
        expectNear(name, "collision, s", play.collisionS(), (500.0 - 8.9) / kEgoMps, kInstantS);
        expectNear(name, "end, s", play.endS(), 500.0 / kEgoMps + 10.0, kInstantS);
    }
}

TEST_F(Alks, PartlyBlockingTargetsLeaveAGap)
{
    // 1.5 m and 5.25 m to the right: the pedestrian is 0.5 m wide, Ego 2 m: 0.25 m and 4 m stay free.
    for (const auto& [name, offset] : {std::pair("4_2_2_partially_blocking_target", -1.5),
                                       std::pair("4_6_1_forward_detection_range", -5.25)})
    {
        const AlksPlay play(name);
        ASSERT_TRUE(play.isThere());
        expectNear(name, "t of the pedestrian from that of Ego, m",
                   play.atFirst()[1].place->t - play.atFirst()[0].place->t, offset, 1e-6);
        EXPECT_LT(play.collisionS(), 0.0) << name;
        expectNear(name, "end, s", play.endS(), 40.0, kInstantS);
    }
}

TEST_F(Alks, ThePedestrianIsInTheLanesMiddleWhenEgoComes)
{
    const AlksPlay play("4_2_3_crossing_pedestrian");
    ASSERT_TRUE(play.isThere());
    // 5 m at 5 km/h take 3.6 s; the time headway between the boxes falls below it when 60 m are left. The
    // pedestrian, turned across the road, is 0.25 m thick on Ego's side: 5 m + v·t + 3.9 m + 60 m = 499.75 m.
    expectNear("4_2_3", "CrossEvent begins, s", play.begin("CrossEvent"), (499.75 - 68.9) / kEgoMps,
               2 * kInstantS);
    expectNear("4_2_3", "free headway then, m", play.gapM(play.statesAtBegin("CrossEvent"), 0, 1), 60.0, 0.3);
    const double inMiddleS = play.begin("CrossEvent") + 3.6;
    const auto states = play.statesWhen(0.1 * std::round(10.0 * inMiddleS));
    ASSERT_EQ(states.size(), 2u);
    expectNear("4_2_3", "offset of the pedestrian when Ego's front is there, m",
               states[1].place->t - states[0].place->t, 0.0, 0.1);
    expectNear("4_2_3", "CrossAction ends, s", play.end("CrossAction"), play.begin("CrossEvent") + 7.2,
               kInstantS);
}

TEST_F(Alks, TheLeadChangesItsSpeedTwice)
{
    const AlksPlay play("4_3_1_follow_lead_vehicle_comfortable");
    ASSERT_TRUE(play.isThere());
    const double gap = 1.6 * kEgoMps;
    expectNear("4_3_1", "gap at 0 s (1.6 s), m", play.gapM(play.atFirst(), 0, 1), gap, 0.01);
    expectNear("4_3_1", "VaryingSpeedAction ends (5 m/s at 1 m/s²), s", play.end("VaryingSpeedAction"), 15.0,
               kInstantS);
    expectNear("4_3_1", "speed of the lead then, m/s", play.statesAtEnd("VaryingSpeedAction")[1].speedMps,
               kEgoMps + 5.0, 1e-6);
    expectNear("4_3_1", "VaryingSpeedEvent2 begins, s", play.begin("VaryingSpeedEvent2"), 25.0,
               2 * kInstantS);
    // 12.5 m while it speeds up, 5 m/s in 10 s.
    expectNear("4_3_1", "gap then, m", play.gapM(play.statesAtBegin("VaryingSpeedEvent2"), 0, 1), gap + 62.5,
               0.3);
    expectNear("4_3_1", "VaryingSpeedAction2 ends (10 m/s), s", play.end("VaryingSpeedAction2"), 35.0,
               3 * kInstantS);
    expectNear("4_3_1", "end (20 s later), s", play.endS(), 55.0, 4 * kInstantS);
}

TEST_F(Alks, TheLeadBrakesToAStand)
{
    const AlksPlay play("4_3_2_follow_lead_vehicle_emergency_brake");
    ASSERT_TRUE(play.isThere());
    const double brakingS = kEgoMps / 9.81, gap = 2.0 * kEgoMps;
    expectNear("4_3_2", "gap at 0 s (2 s), m", play.gapM(play.atFirst(), 0, 1), gap, 0.01);
    expectNear("4_3_2", "BrakeAction ends, s", play.end("BrakeAction"), 10.0 + brakingS, kInstantS);
    // Ego comes nearer by v·t, the lead goes on by v²/2a.
    const double left = gap - (kEgoMps * brakingS - 0.5 * kEgoMps * brakingS);
    expectNear("4_3_2", "gap then, m", play.gapM(play.statesAtEnd("BrakeAction"), 0, 1), left, 0.3);
    expectNear("4_3_2", "collision, s", play.collisionS(), 10.0 + brakingS + left / kEgoMps, 2 * kInstantS);
    expectNear("4_3_2", "end (10 s after the stand), s", play.endS(), 20.0 + brakingS, 2 * kInstantS);
}

TEST_F(Alks, TheOtherCutsInAtItsGap)
{
    for (const auto& [name, trigger, lateral] : {std::tuple("4_4_1_cut_in_no_collision", 30.0, 2.0),
                                                 std::tuple("4_4_2_cut_in_unavoidable_collision", 10.0, 3.0)})
    {
        const AlksPlay play(name);
        ASSERT_TRUE(play.isThere());
        // It is 20 km/h slower. Reference points are (trigger + 10 s · 5.556 m/s) apart at first, boxes 5 m
        // less: the free gap is there after 9.1 s, not after the 10 s that the comment in the file counts
        // with.
        const double closing = 20.0 / 3.6;
        expectNear(name, "CutInEvent begins, s", play.begin("CutInEvent"), 10.0 - 5.0 / closing, kInstantS);
        expectNear(name, "free gap then, m", play.gapM(play.statesAtBegin("CutInEvent"), 0, 1), trigger,
                   0.12);
        expectNear(name, "CutInAction ends, s", play.end("CutInAction"),
                   play.begin("CutInEvent") + changeS(3.5, lateral), kInstantS);
        EXPECT_EQ(play.statesAtEnd("CutInAction")[1].place->lane, -4);
        EXPECT_NEAR(play.statesAtEnd("CutInAction")[1].place->laneOffsetM, 0.0, 1e-3);
        expectNear(name, "speed of the other then, m/s", play.statesAtEnd("CutInAction")[1].speedMps,
                   40.0 / 3.6, 1e-6);
        expectNear(name, "end (10 s after the change), s", play.endS(), play.end("CutInAction") + 10.0,
                   kInstantS);
    }
}

TEST_F(Alks, TheLeadCutsOutBeforeTheTarget)
{
    for (const char* const name : {"4_5_1_cut_out_fully_blocking", "4_5_2_cut_out_multiple_blocking_targets"})
    {
        const AlksPlay play(name);
        ASSERT_TRUE(play.isThere());
        const auto lead = static_cast<std::size_t>(std::find_if(play.atFirst().begin(), play.atFirst().end(),
                                                                [](const EntityState& state)
                                                                { return state.name == "LeadVehicle"; }) -
                                                   play.atFirst().begin());
        ASSERT_LT(lead, play.atFirst().size());
        expectNear(name, "gap at 0 s (2 s), m", play.gapM(play.atFirst(), 0, lead), 2.0 * kEgoMps, 0.01);
        // The lead's reference point is 2 s and 5 m before Ego's; its front is 50 m before the pedestrian at
        // 446.1 m.
        const double beginS = (450.0 - 3.9 - (5.0 + 2.0 * kEgoMps + 5.0)) / kEgoMps;
        expectNear(name, "CutOutEvent begins, s", play.begin("CutOutEvent"), beginS, kInstantS);
        expectNear(name, "CutOutAction ends, s", play.end("CutOutAction"),
                   play.begin("CutOutEvent") + changeS(3.5, 2.0), kInstantS);
        EXPECT_EQ(play.statesAtEnd("CutOutAction")[lead].place->lane, -3);
        expectNear(name, "end, s", play.endS(), 40.0, kInstantS);
    }
}

TEST_F(Alks, TheSideVehicleComesNearer)
{
    const AlksPlay play("4_6_2_lateral_detection_range");
    ASSERT_TRUE(play.isThere());
    const auto beside = [](const std::vector<EntityState>& states)
    { return states[1].place->t - states[0].place->t; };
    expectNear("4_6_2", "t of the other from that of Ego, m", beside(play.atFirst()), -7.0, 1e-6);
    expectNear("4_6_2", "SwerveEvent begins, s", play.begin("SwerveEvent"), 10.0, kInstantS);
    expectNear("4_6_2", "SwerveAction ends (5.25 m at 0.1 m/s²), s", play.end("SwerveAction"),
               10.0 + offsetS(5.25, 0.1), kInstantS);
    expectNear("4_6_2", "t then, m", beside(play.statesAtEnd("SwerveAction")), -1.75, 1e-3);
    expectNear("4_6_2", "end, s", play.endS(), 40.0, kInstantS);
}

/// The instants are those of the file, not of this test: another value of a parameter moves them.
TEST_F(Alks, AnotherParameterMovesTheInstant)
{
    const AlksPlay play("4_4_1_cut_in_no_collision",
                        {{"CutInVehicle_HeadwayDistanceTrigger_dx0_m", "20"},
                         {"CutInVehicle_LaneChange_MaxLateralVelocity_Vy_mps", "1"}});
    ASSERT_TRUE(play.isThere());
    EXPECT_NEAR(play.gapM(play.statesAtBegin("CutInEvent"), 0, 1), 20.0, 0.12);
    EXPECT_NEAR(play.end("CutInAction") - play.begin("CutInAction"), changeS(3.5, 1.0), kInstantS);
    EXPECT_GT(std::fabs(play.end("CutInAction") - play.begin("CutInAction") - changeS(3.5, 2.0)), 1.0);
}

} // namespace
} // namespace simulation
