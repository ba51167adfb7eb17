// SPDX-License-Identifier: Apache-2.0
// Conditions on entities, each at the instant worked by hand. Ego drives at 10 m/s from x = 0 along the lane;
// Other is 100 m ahead, at 4 m/s where it moves. The cars are 5 m long, their middle 1.4 m before the
// reference point: bumpers are 5 m nearer than the points.
#include <cmath>

#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

struct ConditionCase
{
    const char* name;
    const char* condition;
    double startS;
    const char* mutation; ///< another condition, which must give another instant
    double otherMps = 0.0;
    const char* more = ""; ///< further events
};

/// When the event `b` starts, or -1.
double startOf(const ConditionCase& kind, const std::string& condition)
{
    ScenarioText text;
    text.entities += "<ScenarioObject name=\"Other\">" + kCar + "</ScenarioObject>";
    text.globals =
        "<Private entityRef=\"Other\">" + roadplay::onLane(100.0) + speedAction(kind.otherMps) + "</Private>";
    text.privates = roadplay::onLane(0.0) + speedAction(10.0);
    text.stories = story(
        kind.more +
        event(
            "b", speedAction(10.0),
            R"(<ConditionGroup><Condition name="c" delay="0" conditionEdge="none"><ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="Ego"/></TriggeringEntities><EntityCondition>)" +
                condition + "</EntityCondition></ByEntityCondition></Condition></ConditionGroup>"));
    const auto player = roadplay::played(text, 30.0, roadplay::straight(280.0));
    for (const StoryboardLogEntry& entry : player->log())
        if (entry.path.ends_with("::b") && entry.transition == StoryboardElementState::startTransition)
            return entry.timeS;
    return -1.0;
}

class ConditionKinds : public testing::TestWithParam<ConditionCase>
{
};

TEST_P(ConditionKinds, StartAtTheInstantWorkedByHand)
{
    const ConditionCase& kind = GetParam();
    EXPECT_NEAR(startOf(kind, kind.condition), kind.startS, 0.5 * roadplay::kStepS);
    EXPECT_GT(std::fabs(startOf(kind, kind.mutation) - kind.startS), 0.5 * roadplay::kStepS);
}

const std::string kSlower = event("s", speedAction(4.0, "linear", "rate", 3.0), timeCondition(1.0));
const std::string kStops = event("s", speedAction(0.0), timeCondition(1.0));

INSTANTIATE_TEST_SUITE_P(
    Table, ConditionKinds,
    testing::Values(
        // 100 m − 10 m/s · t < 2 s · 10 m/s after 8 s: at 8.01 s.
        ConditionCase{
            "TimeHeadway",
            R"(<TimeHeadwayCondition entityRef="Other" value="2" rule="lessThan" freespace="false" coordinateSystem="road" relativeDistanceType="longitudinal"/>)",
            8.01,
            R"(<TimeHeadwayCondition entityRef="Other" value="2" rule="lessThan" freespace="true" coordinateSystem="road" relativeDistanceType="longitudinal"/>)"},
        // (100 − 5 − 6t) / 6 < 3 from t = 12.83 s on.
        ConditionCase{
            "TimeToCollision",
            R"(<TimeToCollisionCondition value="3" rule="lessThan" freespace="true" coordinateSystem="road" relativeDistanceType="longitudinal"><TimeToCollisionConditionTarget><EntityRef entityRef="Other"/></TimeToCollisionConditionTarget></TimeToCollisionCondition>)",
            12.84,
            R"(<TimeToCollisionCondition value="3" rule="lessThan" freespace="false" coordinateSystem="road" relativeDistanceType="longitudinal"><TimeToCollisionConditionTarget><EntityRef entityRef="Other"/></TimeToCollisionConditionTarget></TimeToCollisionCondition>)",
            4.0},
        // 100 − 10t < 25 after 7.5 s.
        ConditionCase{
            "RelativeDistance",
            R"(<RelativeDistanceCondition entityRef="Other" value="25" rule="lessThan" freespace="false" relativeDistanceType="longitudinal" coordinateSystem="road"/>)",
            7.51,
            R"(<RelativeDistanceCondition entityRef="Other" value="25" rule="lessThan" freespace="true" relativeDistanceType="longitudinal" coordinateSystem="road"/>)"},
        // √((60 − 10t)² + 1.75²) < 10: 60 − 10t < 9.8457, t > 5.0154 s.
        ConditionCase{
            "Distance",
            R"(<DistanceCondition value="10" rule="lessThan" freespace="false" relativeDistanceType="euclidianDistance"><Position><WorldPosition x="60" y="0"/></Position></DistanceCondition>)",
            5.02,
            R"(<DistanceCondition value="10" rule="lessThan" freespace="false" relativeDistanceType="euclidianDistance"><Position><WorldPosition x="61" y="0"/></Position></DistanceCondition>)"},
        ConditionCase{"TraveledDistance", R"(<TraveledDistanceCondition value="42"/>)", 4.2,
                      R"(<TraveledDistanceCondition value="43"/>)"},
        // Within 2 m of x = 50: at x = 48.
        ConditionCase{
            "ReachPosition",
            R"(<ReachPositionCondition tolerance="2"><Position><LanePosition roadId="1" laneId="-1" s="50"/></Position></ReachPositionCondition>)",
            4.8,
            R"(<ReachPositionCondition tolerance="3"><Position><LanePosition roadId="1" laneId="-1" s="50"/></Position></ReachPositionCondition>)"},
        // From 10 to 4 m/s at 3 m/s² from 1 s on: below 7 m/s after 2 s. What begins at 1 s moves with the
        // step after it.
        ConditionCase{"Speed", R"(<SpeedCondition value="7" rule="lessThan"/>)", 2.01,
                      R"(<SpeedCondition value="6.9" rule="lessThan"/>)", 0.0, kSlower.c_str()},
        // 10 − 4 = 6 m/s at first; 4 m/s when Ego drives at 8 m/s.
        ConditionCase{"RelativeSpeed",
                      R"(<RelativeSpeedCondition entityRef="Other" value="4" rule="lessThan"/>)", 1.67,
                      R"(<RelativeSpeedCondition entityRef="Other" value="3.9" rule="lessThan"/>)", 4.0,
                      kSlower.c_str()},
        ConditionCase{"Acceleration",
                      R"(<AccelerationCondition value="-2" rule="lessThan" direction="longitudinal"/>)", 1.01,
                      R"(<AccelerationCondition value="-4" rule="lessThan" direction="longitudinal"/>)", 0.0,
                      kSlower.c_str()},
        ConditionCase{"StandStill", R"(<StandStillCondition duration="1.495"/>)", 2.51,
                      R"(<StandStillCondition duration="1.6"/>)", 0.0, kStops.c_str()},
        // The road ends at 280 m, after 28 s; with the step after that it goes no further. So it has been for
        // 0.995 s at 29.01 s.
        ConditionCase{"EndOfRoad", R"(<EndOfRoadCondition duration="0.995"/>)", 29.01,
                      R"(<EndOfRoadCondition duration="1.2"/>)"},
        // Bumpers touch at 95 m, at 9.5 s; the boxes overlap a step later.
        ConditionCase{"Collision",
                      R"(<CollisionCondition><EntityRef entityRef="Other"/></CollisionCondition>)", 9.51,
                      R"(<CollisionCondition><ByType type="pedestrian"/></CollisionCondition>)"}),
    [](const testing::TestParamInfo<ConditionCase>& test) { return std::string(test.param.name); });

} // namespace
} // namespace simulation
