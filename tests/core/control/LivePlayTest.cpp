// SPDX-License-Identifier: Apache-2.0
// A ride by hand at the pace of a wall clock that the test turns: slow pictures never change what the vehicle
// does.
#include "simulation/player/LivePlay.h"

#include <cstring>

#include <gtest/gtest.h>

#include "TestCart.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/RecordedInputs.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/vehicle/WeatherAir.h"

namespace
{

using namespace simulation;
using testsupport::TestCart;

struct LiveRide
{
    std::unique_ptr<ScenarioPlayer> player;
    std::shared_ptr<VehicleMotion> motion;
    ControlSwitch* controls = nullptr;
};

Scenario oneCart()
{
    Scenario scenario;
    scenario.entities.push_back({{}, "Ego", Vehicle{}});
    return scenario;
}

LiveRide rideOf(std::unique_ptr<ControlledVehicle> vehicle)
{
    LiveRide ride;
    vehicle->record();
    ride.motion = std::make_shared<VehicleMotion>(std::move(vehicle), std::make_shared<LevelGround>(),
                                                  std::make_shared<WeatherAir>());
    PlayerOptions options;
    options.motions["Ego"] = ride.motion;
    auto player = ScenarioPlayer::create(oneCart(), options);
    EXPECT_TRUE(player) << player.error().message();
    ride.player = std::move(*player);
    return ride;
}

LiveRide byHand()
{
    auto cart = std::make_unique<TestCart>();
    auto manual = ManualController::create({{"push", -1.0, 1.0, 2.0, 1.0}, {"brake", 0.0, 1.0, 0.5}}, *cart);
    auto both = std::make_unique<ControlSwitch>(nullptr, std::move(*manual), true);
    ControlSwitch* const seen = both.get();
    LiveRide ride = rideOf(std::make_unique<ControlledVehicle>(std::move(cart), std::move(both)));
    ride.controls = seen;
    return ride;
}

/// The x of every step of a ride of 6 s, with keys at whole seconds and pictures every `frameS`.
std::vector<double> driven(double frameS)
{
    LiveRide ride = byHand();
    std::vector<double> places;
    LivePlay live(std::move(ride.player),
                  [&](const ScenarioPlayer& player) { places.push_back(player.entities()[0].position.x); });
    live.advance(0.0);
    for (int i = 1; i <= std::llround(6.0 / frameS); ++i)
    {
        const double wallS = i * frameS;
        ride.controls->manual().hold(0, wallS > 1.0 && wallS <= 3.0 ? 1.0 : wallS > 4.0 ? -1.0 : 0.0);
        live.advance(wallS);
    }
    return places;
}

TEST(LivePlay, SlowPicturesLeaveEveryStepAsItIs)
{
    const std::vector<double> quick = driven(1.0 / 60.0);
    EXPECT_EQ(quick.size(), 6U * 120U + 1U);
    EXPECT_GT(std::abs(quick.back()), 1.0);
    for (const double frameS : {0.1, 0.25, 0.5, 1.0})
        EXPECT_EQ(quick, driven(frameS)) << frameS;
    // The control: keys that come to other steps move it elsewhere.
    EXPECT_NE(quick, driven(0.6));
}

TEST(LivePlay, ShowsTheEntitiesBetweenTheLastTwoSteps)
{
    LiveRide ride = byHand();
    std::vector<double> places;
    LivePlay live(std::move(ride.player),
                  [&](const ScenarioPlayer& player) { places.push_back(player.entities()[0].position.x); });
    ride.controls->manual().hold(0, 1.0);
    live.advance(0.0);
    live.advance(0.5);
    live.advance(0.5 + 0.25 / 120.0);
    ASSERT_EQ(places.size(), 62U);
    EXPECT_NEAR(live.shown()[0].position.x, 0.75 * places[60] + 0.25 * places[61], 1e-12);
    EXPECT_LT(live.shown()[0].position.x, live.player().entities()[0].position.x);
}

TEST(LivePlay, WhatHandsDidRepeatsFromTheRecordingToTheLastBit)
{
    LiveRide ride = byHand();
    LivePlay live(std::move(ride.player));
    live.advance(0.0);
    for (int i = 1; i < 200; ++i)
    {
        if (i % 17 == 0) ride.controls->manual().hold(0, (i % 3) - 1.0);
        if (i == 100) ride.controls->manual().put(1, 0.3);
        live.pace().setPaused(i % 23 == 0);
        live.advance(0.037 * i);
    }
    const auto read = parseInputs(writeInputs(ride.motion->vehicle().recorder()->track()), "recorded");
    ASSERT_TRUE(read) << read.error().message();
    auto cart = std::make_unique<TestCart>();
    auto recorded = RecordedInputs::create(*read, *cart, "recorded");
    ASSERT_TRUE(recorded);
    LiveRide again = rideOf(std::make_unique<ControlledVehicle>(
        std::move(cart), std::make_unique<RecordedInputs>(std::move(*recorded))));
    while (!again.player->areMotionsDone())
        again.player->step();
    const EntityState &first = live.player().entities()[0], &second = again.player->entities()[0];
    EXPECT_EQ(live.player().timeS(), again.player->timeS());
    EXPECT_EQ(std::memcmp(&first.position, &second.position, sizeof first.position), 0);
    EXPECT_EQ(std::memcmp(&first.velocity, &second.velocity, sizeof first.velocity), 0);
    EXPECT_NE(first.position.x, 0.0);
}

TEST(LivePlay, BeginsAnewAndPausesWhereItIsOver)
{
    LiveRide ride = byHand(), other = byHand();
    LivePlay live(std::move(ride.player));
    ride.controls->manual().put(0, 1.0);
    live.advance(0.0);
    live.advance(0.9);
    EXPECT_GT(live.shown()[0].position.x, 0.1);
    live.restart(std::move(other.player));
    EXPECT_EQ(live.shown()[0].position.x, 0.0);
    EXPECT_EQ(live.pace().timeS(), 0.0);
    live.advance(1.0);
    EXPECT_EQ(live.player().clock().step(), 12);
    EXPECT_FALSE(live.pace().isPaused());

    auto cart = std::make_unique<TestCart>();
    InputTrack track{120, false, {"push"}, {{0.0, {1.0}}}, 30.0};
    auto recorded = RecordedInputs::create(track, *cart, "recorded");
    ASSERT_TRUE(recorded);
    LiveRide shortRide = rideOf(std::make_unique<ControlledVehicle>(
        std::move(cart), std::make_unique<RecordedInputs>(std::move(*recorded))));
    live.restart(std::move(shortRide.player));
    live.advance(1.9);
    EXPECT_TRUE(live.isOver());
    EXPECT_TRUE(live.pace().isPaused());
    EXPECT_EQ(live.player().clock().step(), 30);
}

} // namespace
