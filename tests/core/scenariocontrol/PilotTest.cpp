// SPDX-License-Identifier: Apache-2.0
// Aircraft that an autopilot flies in a scenario: its orders, and the wind of the environment.
#include <cmath>

#include "ControlPlay.h"

namespace
{

using namespace controlplay;

std::string windTo(double directionRad, double speedMps)
{
    return "<GlobalAction><EnvironmentAction><Environment name=\"e\"><Weather><Wind direction=\"" +
           std::to_string(directionRad) + "\" speed=\"" + std::to_string(speedMps) +
           "\"/></Weather></Environment></EnvironmentAction></GlobalAction>";
}

std::unique_ptr<simulation::ScenarioPlayer> flight(const simulation::ScenarioText& text, double timeS,
                                                   std::uint64_t seed = 0)
{
    Stage stage;
    stage.roads = nullptr;
    stage.seed = seed;
    return played(text, timeS, stage);
}

TEST(ScenarioPilot, FliesItsOrders)
{
    // East is a heading of 90° and an angle of 0 in the scene; north is 90.
    const auto player = flight(flown(50.0, property("orders", "heading 0; altitude 1080")), 90.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).headingDeg, 90.0, 2.0);
    EXPECT_NEAR(ego(*player).position.z, 1080.0, 8.0); // the Earth bends away by 1 m or so
    EXPECT_TRUE(ego(*player).aircraft);
}

TEST(ScenarioPilot, HoldsWhatItHasWithoutOrders)
{
    const auto player = flight(flown(50.0, ""), 60.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).headingDeg, 0.0, 1.0);
    EXPECT_NEAR(ego(*player).position.z, 1000.0, 5.0);
    EXPECT_NEAR(ego(*player).speedMps, 50.0, 1.0);
}

TEST(ScenarioPilot, DriftsWithTheWindOfTheScenario)
{
    // The nose stays to the east; in a minute a wind of 8 m/s to the north carries it 480 m.
    simulation::ScenarioText text = flown(50.0, property("orders", "heading 90"));
    const auto calm = flight(text, 60.0);
    text.globals = windTo(std::acos(0.0), 8.0);
    const auto windy = flight(text, 60.0);
    ASSERT_TRUE(calm && windy);
    EXPECT_NEAR(ego(*calm).position.y, 0.0, 10.0);
    EXPECT_NEAR(ego(*windy).position.y, 480.0, 50.0);
}

TEST(ScenarioPilot, FeelsAWindThatBeginsLater)
{
    simulation::ScenarioText text = flown(50.0, property("orders", "heading 90"));
    text.stories = simulation::story(
        simulation::event("wind", windTo(std::acos(0.0), 8.0), simulation::timeCondition(30.0)));
    const auto player = flight(text, 60.0);
    ASSERT_TRUE(player);
    EXPECT_GT(ego(*player).position.y, 150.0);
    EXPECT_LT(ego(*player).position.y, 260.0);
}

TEST(ScenarioPilot, IsShakenByTurbulenceThatItsSeedChooses)
{
    const simulation::ScenarioText text = flown(50.0, property("turbulence", "2"));
    const auto one = flight(text, 20.0, 1), again = flight(text, 20.0, 1), other = flight(text, 20.0, 2);
    const auto still = flight(flown(50.0, ""), 20.0);
    ASSERT_TRUE(one && again && other && still);
    EXPECT_EQ(ego(*one).position, ego(*again).position);
    EXPECT_NE(ego(*one).position, ego(*other).position);
    EXPECT_NE(ego(*one).position, ego(*still).position);
}

TEST(ScenarioPilot, HearsSpeedActions)
{
    simulation::ScenarioText text = flown(55.0, "");
    text.stories = simulation::story(
        simulation::event("slower", simulation::speedAction(45.0), simulation::timeCondition(5.0)));
    const auto player = flight(text, 60.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(ego(*player).speedMps, 45.0, 1.0);
}

TEST(ScenarioPilot, TakesOffFromItsStrip)
{
    simulation::ScenarioText text =
        flown(0.0, property("strip", "0,0,90,1000") + property("orders", "takeoff"));
    text.privates = simulation::teleport(R"(<WorldPosition x="20" y="0" h="0"/>)") + activate("true", "true");
    const auto player = flight(text, 70.0);
    ASSERT_TRUE(player);
    EXPECT_GT(ego(*player).position.z, 100.0);
    EXPECT_NEAR(ego(*player).headingDeg, 0.0, 5.0);
}

} // namespace
