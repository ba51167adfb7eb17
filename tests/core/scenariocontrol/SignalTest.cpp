// SPDX-License-Identifier: Apache-2.0
// Lights and stop signs on the way of a driver, and of traffic.
#include "ControlPlay.h"
#include "simulation/road/StopAtSign.h"
#include "simulation/road/StopSignals.h"

namespace
{

using namespace controlplay;

/// A light at 300 m and a stop sign at 600 m, for those who drive towards greater s.
std::string signals()
{
    return R"(<signals><signal s="300" t="-4" id="7" name="light" dynamic="yes" orientation="+" zOffset="3" type="1000001" subtype="-1" country="OpenDRIVE" value="-1"/>
<signal s="600" t="-4" id="8" name="stop" dynamic="no" orientation="+" zOffset="3" type="206" subtype="-1" country="DE" value="-1"/></signals>)";
}

std::string light(const std::string& state)
{
    return "<GlobalAction><InfrastructureAction><TrafficSignalAction><TrafficSignalStateAction name=\"7\" "
           "state=\"" +
           state + "\"/></TrafficSignalAction></InfrastructureAction></GlobalAction>";
}

Stage withSignals()
{
    Stage stage;
    stage.roads = straight(signals());
    return stage;
}

TEST(SignalsAhead, ADriverStopsAtARedLightAndGoesOnAtGreen)
{
    simulation::ScenarioText text = driven(15.0);
    text.globals = light("red");
    text.stories =
        simulation::story(simulation::event("go", light("green"), simulation::timeCondition(40.0)));
    auto player = played(text, 39.0, withSignals());
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).speedMps, 0.0, 0.01);
    // The front, 3.5 to 4 m ahead of the rear axle, is before the line.
    EXPECT_LT(ego(*player).position.x + 3.0, 300.0);
    EXPECT_GT(ego(*player).position.x, 285.0);
    playTo(*player, 50.0);
    EXPECT_GT(ego(*player).position.x, 310.0);
}

/// A car of the scenario alone that follows the intelligent driver model.
simulation::ScenarioText followed(double speedMps)
{
    simulation::ScenarioText text = driven(speedMps);
    text.entities = "<ScenarioObject name=\"Ego\">" + simulation::kCar + controller("IntelligentDriver", "") +
                    "</ScenarioObject>";
    return text;
}

TEST(SignalsAhead, TrafficStopsAtARedLightAndGoesOnAtGreen)
{
    simulation::ScenarioText text = followed(15.0);
    text.globals = light("red");
    text.stories =
        simulation::story(simulation::event("go", light("green"), simulation::timeCondition(60.0)));
    auto player = played(text, 59.0, withSignals());
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).speedMps, 0.0, 0.1);
    // The front is 3.9 m ahead of the reference point, and stands 0.5 to 1.5 m before the line.
    EXPECT_NEAR(ego(*player).position.x + 3.9, 299.0, 0.6);
    playTo(*player, 75.0);
    EXPECT_GT(ego(*player).position.x, 310.0);
}

TEST(SignalsAhead, TrafficDrivesThroughALightThatTurnsTooLate)
{
    simulation::ScenarioText text = followed(15.0);
    text.globals = light("green");
    // The front is 10 m before the line: no way to stop from 15 m/s.
    text.stories =
        simulation::story(simulation::event("turn", light("red"), simulation::timeCondition(12.4)));
    const auto player = played(text, 20.0, withSignals());
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).position.x, 100.0 + 15.0 * 20.0, 2.0);
}

/// How somebody came to the stop sign and went on, in steps of 0.1 s.
struct AtSign
{
    double slowestMps = 1e9, stoodAtM = 0.0, stoodS = 0.0, endM = 0.0;
};

AtSign stopsAtSign(simulation::ScenarioText text)
{
    text.globals = light("green");
    auto player = played(text, 25.0, withSignals());
    AtSign seen;
    if (!player) return seen;
    for (double timeS = 25.1; timeS < 90.0; timeS += 0.1)
    {
        playTo(*player, timeS);
        const double speedMps = ego(*player).speedMps;
        if (speedMps < 0.2) seen.stoodS += 0.1;
        if (speedMps >= seen.slowestMps) continue;
        seen.slowestMps = speedMps;
        seen.stoodAtM = ego(*player).position.x;
    }
    seen.endM = ego(*player).position.x;
    return seen;
}

TEST(SignalsAhead, TrafficStopsAtASignLooksAndGoesOn)
{
    const AtSign seen = stopsAtSign(followed(15.0));
    EXPECT_LT(seen.slowestMps, 0.2);
    EXPECT_NEAR(seen.stoodAtM + 3.9, 599.0, 1.0);
    EXPECT_GT(seen.stoodS, 1.4);
    EXPECT_LT(seen.stoodS, 4.0);
    EXPECT_GT(seen.endM, 700.0);
}

TEST(SignalsAhead, ADriverStopsAtASignByTheSameRule)
{
    const AtSign seen = stopsAtSign(driven(15.0));
    EXPECT_LT(seen.slowestMps, 0.2);
    EXPECT_LT(seen.stoodAtM + 3.0, 600.0); // its front is 3 to 4 m ahead
    EXPECT_GT(seen.stoodAtM + 4.0, 598.0);
    EXPECT_GT(seen.stoodS, 1.4);
    EXPECT_LT(seen.stoodS, 4.0);
    EXPECT_GT(seen.endM, 700.0);
}

TEST(SignalsAhead, WhoHasStoodAtASignIsNotHeldByItAgain)
{
    simulation::StopAtSign rule(1.0);
    double heldS = 0.0;
    while (heldS < 60.0 && rule.holds(100.0, 1.0, 0.0, 0.25))
        heldS += 0.25;
    EXPECT_EQ(heldS, 0.75); // let go in the step that ends the second
    EXPECT_TRUE(rule.hasServed(101.0));
    EXPECT_FALSE(rule.holds(100.5, 0.5, 0.0, 0.25));
    // The mutations: who has not stood, or not before the line, is held; and so is each at the next sign.
    EXPECT_TRUE(rule.holds(160.0, 1.0, 5.0, 10.0));
    EXPECT_TRUE(rule.holds(160.0, 30.0, 0.0, 10.0));
    EXPECT_FALSE(rule.hasServed(160.0));
}

TEST(SignalsAhead, ALineThatComesTooLateIsPassed)
{
    EXPECT_FALSE(simulation::comesTooLate(12.6, 10.0, 4.0));
    EXPECT_TRUE(simulation::comesTooLate(12.4, 10.0, 4.0));
    EXPECT_FALSE(simulation::comesTooLate(0.0, 0.9, 4.0)); // who creeps stops at once
}

TEST(SignalsAhead, ASignForTheOtherDirectionStopsNobody)
{
    std::string turned = signals();
    const std::size_t sign = turned.find("id=\"8\"");
    turned.replace(turned.find("orientation=\"+\"", sign), 15, "orientation=\"-\"");
    Stage stage;
    stage.roads = straight(turned);
    simulation::ScenarioText text = followed(15.0);
    text.globals = light("green");
    const auto player = played(text, 40.0, stage);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).position.x, 100.0 + 15.0 * 40.0, 3.0);
}

TEST(SignalsAhead, AGreenLightStopsNobody)
{
    simulation::ScenarioText text = driven(15.0);
    text.globals = light("green");
    const auto player = played(text, 16.0, withSignals());
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).position.x, 100.0 + 15.0 * 16.0, 6.0);
}

TEST(SignalsAhead, BetweenTwoPlacesAreThoseOfTheLaneAndDirection)
{
    const Roads roads = straight(signals());
    const auto forward = simulation::stopsBetween(roads->network(), 0, -1, 0.0, 1000.0);
    ASSERT_EQ(forward.size(), 2U);
    EXPECT_EQ(forward[0].signal, "7");
    EXPECT_EQ(forward[0].sM, 300.0);
    EXPECT_TRUE(forward[1].signal.empty());
    EXPECT_TRUE(simulation::stopsBetween(roads->network(), 0, 1, 1000.0, 0.0).empty());
    EXPECT_EQ(simulation::stopsBetween(roads->network(), 0, -1, 301.0, 1000.0).size(), 1U);
}

TEST(SignalsAhead, WordsAndLampsLetPass)
{
    for (const char* const free : {"green", "off;off;on", "go", "off", "off;off;green"})
        EXPECT_TRUE(simulation::letsPass(free)) << free;
    for (const char* const held : {"red", "on;off;off", "yellow", "stop", ""})
        EXPECT_FALSE(simulation::letsPass(held)) << held;
}

} // namespace
