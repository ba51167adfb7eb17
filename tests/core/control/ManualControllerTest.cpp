// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "TestCart.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/ControlledVehicle.h"
#include "simulation/vehicle/WeatherAir.h"

namespace
{

using namespace simulation;
using testsupport::TestCart;

constexpr double kHandStepS = 1.0 / 120.0;

ManualController manualOn(const DynamicVehicle& cart)
{
    auto manual = ManualController::create(
        {{"push", -1.0, 1.0, 2.0, 1.0}, {"brake", 0.0, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.25}}, cart);
    EXPECT_TRUE(manual);
    return std::move(*manual);
}

/// A cart, its inputs and manual control of it.
struct CartSeat
{
    TestCart cart;
    LevelGround ground;
    WeatherAir air;
    std::int64_t steps = 0;

    void step(VehicleController& controller, double speedMps = 0.0)
    {
        VehicleState state = cart.state();
        state.velocity = {speedMps, 0.0, 0.0};
        controller.control({state, cart.status(), ground, air, {}, steps++, 0.0}, cart.inputs());
    }
};

TEST(ManualController, MoveAnInputWhileAKeyIsHeldAndLetItReturn)
{
    CartSeat seat;
    ManualController manual = manualOn(seat.cart);
    manual.hold(0, 1.0);
    for (int i = 0; i < 30; ++i)
        seat.step(manual);
    EXPECT_NEAR(seat.cart.inputs()[0], 30.0 * 2.0 * kHandStepS, 1e-12);
    manual.hold(0, 0.0);
    for (int i = 0; i < 30; ++i)
        seat.step(manual);
    EXPECT_NEAR(seat.cart.inputs()[0], 0.25, 1e-12);
    for (int i = 0; i < 120; ++i)
        seat.step(manual);
    EXPECT_EQ(seat.cart.inputs()[0], 0.0);
    // What has no way back stays.
    manual.hold(1, 1.0);
    for (int i = 0; i < 60; ++i)
        seat.step(manual);
    manual.hold(1, 0.0);
    for (int i = 0; i < 600; ++i)
        seat.step(manual);
    EXPECT_NEAR(seat.cart.inputs()[1], 0.25, 1e-12);
}

TEST(ManualController, StayWhereADevicePutsThemUntilAKeyMovesThem)
{
    CartSeat seat;
    ManualController manual = manualOn(seat.cart);
    manual.put(0, 0.6);
    manual.put(1, 7.0);
    for (int i = 0; i < 100; ++i)
        seat.step(manual);
    EXPECT_EQ(seat.cart.inputs()[0], 0.6);
    EXPECT_EQ(seat.cart.inputs()[1], 1.0);
    manual.put(0, std::numeric_limits<double>::quiet_NaN());
    seat.step(manual);
    EXPECT_EQ(seat.cart.inputs()[0], 0.6);
    manual.hold(0, -1.0);
    seat.step(manual);
    EXPECT_NEAR(seat.cart.inputs()[0], 0.6 - 2.0 * kHandStepS, 1e-12);
}

TEST(ManualController, ReachLessTheFasterItGoes)
{
    CartSeat seat;
    auto manual = ManualController::create({{"push", -1.0, 1.0, 1e3, 1e3, 0.0, 5.0, 0.1}}, seat.cart);
    ASSERT_TRUE(manual);
    manual->hold(0, -1.0);
    seat.step(*manual, 4.0);
    EXPECT_NEAR(seat.cart.inputs()[0], -1.0, 1e-12);
    seat.step(*manual, 10.0);
    EXPECT_NEAR(seat.cart.inputs()[0], -0.35, 1e-12);
}

TEST(ManualController, RefuseAnInputThatThereIsNot)
{
    const TestCart cart;
    const auto manual = ManualController::create({{"wings"}}, cart);
    ASSERT_FALSE(manual);
    EXPECT_EQ(manual.error().place, "wings");
}

/// Pushes at half strength; remembers where it got the vehicle back.
class HalfPush : public VehicleController
{
public:
    void control(const ControlView& /*view*/, std::span<double> inputs) override { inputs[0] = 0.5; }
    void resume(const ControlView& /*view*/, std::span<const double> inputs) override
    {
        resumedAt = inputs[0];
    }
    bool isDone() const override { return true; }
    double resumedAt = -1.0;
};

TEST(ControlSwitch, TakesOverWithoutAJumpAndGivesBack)
{
    CartSeat seat;
    auto automatic = std::make_unique<HalfPush>();
    const HalfPush& half = *automatic;
    ControlSwitch both(std::move(automatic), manualOn(seat.cart), false);
    seat.step(both);
    EXPECT_EQ(seat.cart.inputs()[0], 0.5);
    EXPECT_TRUE(both.isDone());
    EXPECT_EQ(half.resumedAt, -1.0); // it never had lost it
    EXPECT_TRUE(both.giveToPerson(true));
    EXPECT_FALSE(both.isDone());
    seat.step(both);
    EXPECT_NEAR(seat.cart.inputs()[0], 0.5 - kHandStepS, 1e-12); // on its way back, from where it was
    both.manual().put(0, -0.75);
    seat.step(both);
    EXPECT_EQ(seat.cart.inputs()[0], -0.75);
    EXPECT_TRUE(both.giveToPerson(false));
    seat.step(both);
    EXPECT_EQ(half.resumedAt, -0.75);
    EXPECT_EQ(seat.cart.inputs()[0], 0.5);
}

TEST(ControlSwitch, OfNobodyElseStaysWithTheHands)
{
    CartSeat seat;
    ControlSwitch alone(nullptr, manualOn(seat.cart), false);
    EXPECT_TRUE(alone.isByHand());
    EXPECT_FALSE(alone.giveToPerson(false));
    seat.step(alone);
    EXPECT_EQ(seat.cart.inputs()[1], 0.25); // where manual control from the first step begins step on
    EXPECT_EQ(alone.phase(), "hand");
}

} // namespace
