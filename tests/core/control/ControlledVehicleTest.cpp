// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/ControlledVehicle.h"

#include <cstring>

#include <gtest/gtest.h>

#include "TestCart.h"
#include "simulation/control/RecordedInputs.h"
#include "simulation/vehicle/WeatherAir.h"

namespace
{

using namespace simulation;
using testsupport::TestCart;

/// Pushes with the sine of the step, so that each step has another input.
class SinePush : public VehicleController
{
public:
    void control(const ControlView& view, std::span<double> inputs) override
    {
        inputs[0] = std::sin(static_cast<double>(view.step));
        inputs[1] = view.step < 10 ? 0.0 : 0.1;
    }
};

void run(ControlledVehicle& cart, int steps)
{
    for (int i = 0; i < steps; ++i)
        cart.step(LevelGround(), WeatherAir(), {});
}

bool sameBytes(const VehicleState& a, const VehicleState& b)
{
    return std::memcmp(&a.position, &b.position, sizeof a.position) == 0 &&
           std::memcmp(&a.velocity, &b.velocity, sizeof a.velocity) == 0 && a.timeS == b.timeS;
}

TEST(ControlledVehicle, RecordedInputsRepeatTheRideToTheLastBit)
{
    ControlledVehicle first(std::make_unique<TestCart>(), std::make_unique<SinePush>());
    first.record();
    run(first, 500);
    const auto read = parseInputs(writeInputs(first.recorder()->track()), "recorded");
    ASSERT_TRUE(read) << read.error().message();

    auto cart = std::make_unique<TestCart>();
    auto recorded = RecordedInputs::create(*read, *cart, "recorded");
    ASSERT_TRUE(recorded) << recorded.error().message();
    ControlledVehicle second(std::move(cart), std::make_unique<RecordedInputs>(std::move(*recorded)));
    run(second, 499);
    EXPECT_FALSE(second.controller()->isDone());
    run(second, 1);
    EXPECT_TRUE(sameBytes(first.now(), second.now()));
    run(second, 1);
    EXPECT_TRUE(second.controller()->isDone());
}

TEST(ControlledVehicle, AnotherDigitOfOneInputIsAnotherRide)
{
    ControlledVehicle first(std::make_unique<TestCart>(), std::make_unique<SinePush>());
    first.record();
    run(first, 100);
    InputTrack changed = first.recorder()->track();
    changed.rows[50].values[0] += 1e-12;
    auto cart = std::make_unique<TestCart>();
    auto recorded = RecordedInputs::create(changed, *cart, "changed");
    ASSERT_TRUE(recorded);
    ControlledVehicle second(std::move(cart), std::make_unique<RecordedInputs>(std::move(*recorded)));
    run(second, 100);
    EXPECT_FALSE(sameBytes(first.now(), second.now()));
}

TEST(ControlledVehicle, WithoutAControllerInputsStay)
{
    ControlledVehicle cart(std::make_unique<TestCart>(), nullptr);
    cart.vehicle().inputs()[0] = 2.0;
    run(cart, 120);
    EXPECT_NEAR(cart.now().velocity.x, 2.0, 1e-12);
}

TEST(RecordedInputs, RefusesAnotherRateAndUnknownInputs)
{
    const TestCart cart;
    InputTrack track{60, false, {"push"}, {{0.0, {1.0}}}, std::nullopt};
    const auto slow = RecordedInputs::create(track, cart, "file");
    ASSERT_FALSE(slow);
    EXPECT_NE(slow.error().what.find("60"), std::string::npos);
    track.stepsPerSecond = 120;
    EXPECT_TRUE(RecordedInputs::create(track, cart, "file"));
    track.names = {"pull"};
    const auto unknown = RecordedInputs::create(track, cart, "file");
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().remedy.find("push, brake"), std::string::npos);
}

TEST(RecordedInputs, LeavesWhatTheTrackDoesNotSay)
{
    auto cart = std::make_unique<TestCart>();
    cart->inputs()[1] = 0.25;
    auto inputs = RecordedInputs::create({0, false, {"push"}, {{0.5, {1.0}}}, std::nullopt}, *cart, "file");
    ASSERT_TRUE(inputs);
    ControlledVehicle vehicle(std::move(cart), std::make_unique<RecordedInputs>(std::move(*inputs)));
    run(vehicle, 60);
    EXPECT_EQ(vehicle.vehicle().inputs()[0], 0.0);
    run(vehicle, 1);
    EXPECT_EQ(vehicle.vehicle().inputs()[0], 1.0);
    EXPECT_EQ(vehicle.vehicle().inputs()[1], 0.25);
    EXPECT_FALSE(vehicle.controller()->isDone());
}

TEST(StateBetween, GoesStraightAndTurnsEvenly)
{
    VehicleState from, to;
    to.timeS = 2.0;
    to.position = {4.0, 0.0, 2.0};
    to.bodyToScene = glm::angleAxis(1.0, glm::dvec3(0.0, 0.0, 1.0));
    const VehicleState half = stateBetween(from, to, 1.0);
    EXPECT_EQ(half.position, glm::dvec3(2.0, 0.0, 1.0));
    EXPECT_NEAR(glm::angle(half.bodyToScene), 0.5, 1e-12);
    EXPECT_EQ(stateBetween(from, to, 9.0).position, to.position);
    EXPECT_EQ(stateBetween(from, to, -9.0).position, from.position);
}

} // namespace
