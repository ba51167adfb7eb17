// SPDX-License-Identifier: Apache-2.0
// Who acts where the actors are the entities that triggered the event (selectTriggeringEntities).
#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

/// Entities A, B, C and Ego begin at 10, 20, 30 and 40 m/s; A to C may trigger. B slows to 12 m/s from 2 s
/// on, at once.
std::string fourCars(const std::string& actors, const std::string& condition, const std::string& rule = "any",
                     const std::string& edge = "none", double delayS = 0.0)
{
    ScenarioText text;
    double speed = 10.0;
    text.entities.clear();
    for (const std::string name : {"A", "B", "C", "Ego"})
    {
        text.entities += "<ScenarioObject name=\"" + name + "\">" + kCar + "</ScenarioObject>";
        text.globals += "<Private entityRef=\"" + name + "\">" + speedAction(speed) + "</Private>";
        speed += 10.0;
    }
    const std::string trigger =
        "<ConditionGroup><Condition name=\"c\" delay=\"" + std::to_string(delayS) + "\" conditionEdge=\"" +
        edge + "\"><ByEntityCondition><TriggeringEntities triggeringEntitiesRule=\"" + rule +
        "\"><EntityRef entityRef=\"A\"/><EntityRef entityRef=\"B\"/><EntityRef "
        "entityRef=\"C\"/></TriggeringEntities>"
        "<EntityCondition>" +
        condition + "</EntityCondition></ByEntityCondition></Condition></ConditionGroup>";
    std::string slowing = story(event("slower", speedAction(12.0), timeCondition(2.0)));
    slowing.replace(slowing.find("entityRef=\"Ego\""), 15, "entityRef=\"B\"");
    std::string stopping = story(event("halt", speedAction(1.0), trigger));
    stopping.replace(stopping.find("name=\"story\""), 12, "name=\"other\"");
    stopping.replace(stopping.find("selectTriggeringEntities=\"false\"><EntityRef entityRef=\"Ego\"/>"), 61,
                     actors);
    text.stories = slowing + stopping;
    text.stop = stopAt(10.0);
    return text.text();
}

std::vector<double> speedsAfter(const std::string& text, double timeS)
{
    auto parsed = parseScenario(text, "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return {};
    PlayerOptions options;
    options.clock = FixedClock(10);
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return {};
    while ((*player)->timeS() < timeS - 1e-9)
        (*player)->step();
    std::vector<double> speeds;
    for (const EntityState& state : (*player)->entities())
        speeds.push_back(state.speedMps);
    return speeds;
}

const std::string kAlone = "selectTriggeringEntities=\"true\">";
const std::string kWithEgo = "selectTriggeringEntities=\"true\"><EntityRef entityRef=\"Ego\"/>";
const std::string kEgo = "selectTriggeringEntities=\"false\"><EntityRef entityRef=\"Ego\"/>";

std::string speedIs(const std::string& rule, double speed)
{
    return "<SpeedCondition rule=\"" + rule + "\" value=\"" + std::to_string(speed) + "\"/>";
}

using Speeds = std::vector<double>;

TEST(TriggeringEntities, ActWhereTheConditionHeldForThem)
{
    EXPECT_EQ(speedsAfter(fourCars(kAlone, speedIs("greaterThan", 15.0)), 1.0),
              (Speeds{10.0, 1.0, 1.0, 40.0}));
    EXPECT_EQ(speedsAfter(fourCars(kAlone, speedIs("lessThan", 100.0), "all"), 1.0),
              (Speeds{1.0, 1.0, 1.0, 40.0}));
}

TEST(TriggeringEntities, ActBesideThoseThatAreNamed)
{
    EXPECT_EQ(speedsAfter(fourCars(kWithEgo, speedIs("greaterThan", 25.0)), 1.0),
              (Speeds{10.0, 20.0, 1.0, 1.0}));
    // The mutation: without the attribute Ego acts alone.
    EXPECT_EQ(speedsAfter(fourCars(kEgo, speedIs("greaterThan", 25.0)), 1.0),
              (Speeds{10.0, 20.0, 30.0, 1.0}));
}

TEST(TriggeringEntities, AreThoseOfTheStepBeforeAtAFallingEdge)
{
    // B alone has 20 m/s, until 2 s.
    const std::string between = "<SpeedCondition rule=\"equalTo\" value=\"20\"/>";
    EXPECT_EQ(speedsAfter(fourCars(kAlone, between, "any", "falling"), 1.5),
              (Speeds{10.0, 20.0, 30.0, 40.0}));
    EXPECT_EQ(speedsAfter(fourCars(kAlone, between, "any", "falling"), 3.0), (Speeds{10.0, 1.0, 30.0, 40.0}));
}

TEST(TriggeringEntities, AreThoseOfTheInstantThatADelayLooksBackTo)
{
    // At 2.5 s the condition counts as it was at 0 s: B had 20 m/s, though it has 12 since 2 s.
    EXPECT_EQ(speedsAfter(fourCars(kAlone, speedIs("equalTo", 20.0), "any", "none", 2.5), 2.4),
              (Speeds{10.0, 12.0, 30.0, 40.0}));
    EXPECT_EQ(speedsAfter(fourCars(kAlone, speedIs("equalTo", 20.0), "any", "none", 2.5), 2.7),
              (Speeds{10.0, 1.0, 30.0, 40.0}));
}

} // namespace
} // namespace simulation
