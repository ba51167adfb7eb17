// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/VehicleMotion.h"

#include <gtest/gtest.h>

#include "TestCart.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/vehicle/WeatherAir.h"

namespace
{

using namespace simulation;
using testsupport::TestCart;

Scenario twoCars()
{
    Scenario scenario;
    for (const char* name : {"Ego", "Other"})
    {
        Vehicle vehicle;
        vehicle.category = "car";
        scenario.entities.push_back({{}, name, vehicle});
    }
    InitPrivate init;
    init.entity = "Ego";
    TeleportAction teleport;
    teleport.position = WorldPosition{{}, 100.0, 20.0, 0.0, {}};
    init.actions.emplace_back(teleport);
    scenario.storyboard.init.privates.push_back(init);
    return scenario;
}

/// Pushes harder the nearer the other entity is: whoever steps it must show it the others.
class PushAway : public VehicleController
{
public:
    void control(const ControlView& view, std::span<double> inputs) override
    {
        EXPECT_EQ(view.traffic.entities.size(), 2U);
        EXPECT_EQ(view.traffic.own, 0);
        inputs[0] = 1.0 + 10.0 / (1.0 + glm::length(view.traffic.entities[1].position - view.state.position));
    }
};

std::shared_ptr<VehicleMotion> motion()
{
    return std::make_shared<VehicleMotion>(
        std::make_unique<ControlledVehicle>(std::make_unique<TestCart>(), std::make_unique<PushAway>()),
        std::make_shared<LevelGround>(), std::make_shared<WeatherAir>());
}

/// Ego's state after two seconds of a clock.
EntityState afterTwoSeconds(const FixedClock& clock)
{
    PlayerOptions options;
    options.clock = clock;
    options.motions["Ego"] = motion();
    auto player = ScenarioPlayer::create(twoCars(), options);
    EXPECT_TRUE(player) << player.error().message();
    while ((*player)->timeS() < 2.0 - 1e-9)
        (*player)->step();
    return (*player)->entities()[0];
}

TEST(VehicleMotion, MovesTheEntityFromWhereInitPutsIt)
{
    PlayerOptions options;
    options.motions["Ego"] = motion();
    auto player = ScenarioPlayer::create(twoCars(), options);
    ASSERT_TRUE(player) << player.error().message();
    EXPECT_NEAR((*player)->entities()[0].position.x, 100.0, 1e-9);
    EXPECT_NEAR((*player)->entities()[0].position.y, 20.0, 1e-9);
    EXPECT_EQ((*player)->entities()[0].name, "Ego");
    (*player)->step();
    EXPECT_GT((*player)->entities()[0].position.x, 100.0);
    EXPECT_EQ((*player)->entities()[1].position, glm::dvec3(0.0));
}

TEST(VehicleMotion, AnotherRateOfPicturesHasEqualStatesAtEqualTimes)
{
    const EntityState at24 = afterTwoSeconds(FixedClock(24));
    for (const int rate : {25, 30, 60, 120, 240})
    {
        const EntityState other = afterTwoSeconds(FixedClock(rate));
        EXPECT_EQ(at24.position, other.position) << rate;
        EXPECT_EQ(at24.velocity, other.velocity) << rate;
        EXPECT_EQ(at24.odometerM, other.odometerM) << rate;
    }
}

TEST(VehicleMotion, RefusesAMotionOfNobody)
{
    PlayerOptions options;
    options.motions["Nobody"] = motion();
    const auto player = ScenarioPlayer::create(twoCars(), options);
    ASSERT_FALSE(player);
    EXPECT_NE(player.error().what.find("Nobody"), std::string::npos);
}

TEST(EntityStateOf, HasThePlaceAndAnglesOfTheReferencePoint)
{
    VehicleState vehicle;
    vehicle.position = {10.0, 0.0, 5.0};
    // Nose to the north, 30 degrees up; then right wing down by 20.
    vehicle.bodyToScene = glm::angleAxis(glm::radians(90.0), glm::dvec3(0, 0, 1)) *
                          glm::angleAxis(glm::radians(-30.0), glm::dvec3(0, 1, 0)) *
                          glm::angleAxis(glm::radians(20.0), glm::dvec3(1, 0, 0));
    const EntityState state = entityStateOf(vehicle, {2.0, 0.0, 0.0});
    EXPECT_NEAR(state.headingDeg, 90.0, 1e-9);
    EXPECT_NEAR(state.pitchDeg, -30.0, 1e-9);
    EXPECT_NEAR(state.rollDeg, 20.0, 1e-9);
    EXPECT_NEAR(state.position.y, 2.0 * std::cos(glm::radians(30.0)), 1e-9);
    EXPECT_NEAR(state.position.z, 6.0, 1e-9);
    const glm::dmat3 body = state.bodyToLocal();
    EXPECT_NEAR(glm::distance(body[1], glm::mat3_cast(vehicle.bodyToScene)[1]), 0.0, 1e-9);
}

} // namespace
