// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "FlightSupport.h"

namespace
{

using namespace simulation;
using testsupport::kKnot;

TrimTarget levelAt(double heightM, double speedMps)
{
    TrimTarget target;
    target.position = {0.0, 0.0, heightM};
    target.headingDeg = 30.0;
    target.trueAirspeedMps = speedMps;
    return target;
}

foundation::Result<TrimmedFlight> trimmed(const TrimTarget& target)
{
    return trim(*testsupport::lightSingle(), *testsupport::earthHere(), testsupport::airAt(target.position.z),
                target);
}

void fly(Aircraft& aircraft, double seconds)
{
    const LevelGround ground;
    const WeatherAir air;
    for (int i = 0; i < static_cast<int>(seconds * 120.0); ++i)
        aircraft.step(ground, air);
}

TEST(FlightTrimTest, LevelFlightStaysLevel)
{
    for (const double knots : {60.0, 80.0, 110.0})
    {
        const auto flight = trimmed(levelAt(1000.0, knots * kKnot));
        ASSERT_TRUE(flight) << flight.error().message();
        Aircraft aircraft = testsupport::flying(*flight);
        fly(aircraft, 10.0);
        const FlightReadings readings = aircraft.readings();
        EXPECT_NEAR(readings.place.heightM, 1000.0, 0.1) << knots;
        EXPECT_NEAR(readings.trueAirspeedMps, knots * kKnot, 0.05) << knots;
        EXPECT_NEAR(readings.headingDeg, 30.0, 0.1) << knots;
    }
}

// The control: with the elevator elsewhere it does not stay.
TEST(FlightTrimTest, AnotherElevatorLeavesTheLevel)
{
    const auto flight = trimmed(levelAt(1000.0, 100.0 * kKnot));
    ASSERT_TRUE(flight);
    Aircraft aircraft = testsupport::flying(*flight);
    testsupport::setInput(aircraft, FlightInput::elevator, -0.03);
    fly(aircraft, 10.0);
    EXPECT_GT(aircraft.readings().place.heightM, 1005.0);
}

// Rate of turn g·tan φ / V.
TEST(FlightTrimTest, ASteadyTurnHasTheRateOfItsBank)
{
    for (const double bank : {-30.0, 20.0, 45.0})
    {
        TrimTarget target = levelAt(1000.0, 100.0 * kKnot);
        target.bankDeg = bank;
        const auto flight = trimmed(target);
        ASSERT_TRUE(flight) << flight.error().message();
        Aircraft aircraft = testsupport::flying(*flight);
        const double before = aircraft.readings().headingDeg;
        fly(aircraft, 5.0);
        const double turned = std::remainder(aircraft.readings().headingDeg - before, 360.0) / 5.0;
        const double expected = 9.80665 * std::tan(bank / 57.29578) / (100.0 * kKnot) * 57.29578;
        EXPECT_NEAR(turned / expected, 1.0, 0.02) << bank;
    }
}

TEST(FlightTrimTest, FullThrottleClimbsAndIdleGlides)
{
    TrimTarget target = levelAt(300.0, 76.0 * kKnot);
    target.throttle = 1.0;
    const auto climb = trimmed(target);
    ASSERT_TRUE(climb) << climb.error().message();
    EXPECT_GT(climb->pathDeg, 4.0);
    target.throttle = 0.0;
    const auto glide = trimmed(target);
    ASSERT_TRUE(glide) << glide.error().message();
    EXPECT_LT(glide->pathDeg, -4.0);
    Aircraft aircraft = testsupport::flying(*glide);
    fly(aircraft, 5.0);
    EXPECT_NEAR(aircraft.readings().climbMps, 76.0 * kKnot * std::sin(glide->pathDeg / 57.29578), 0.05);
}

TEST(FlightTrimTest, SaysWhenThereIsNoSteadyFlight)
{
    for (const double speed : {15.0, 130.0})
    {
        const auto flight = trimmed(levelAt(1000.0, speed));
        ASSERT_FALSE(flight) << speed;
        EXPECT_EQ(flight.error().place, "trim");
        EXPECT_FALSE(flight.error().remedy.empty());
    }
    EXPECT_FALSE(trimmed(levelAt(1000.0, std::nan(""))));
}

} // namespace
