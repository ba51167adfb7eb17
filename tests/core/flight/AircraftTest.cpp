// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "FlightSupport.h"

namespace
{

using namespace simulation;
using testsupport::kKnot;
using testsupport::setInput;

TrimmedFlight cruise()
{
    TrimTarget target;
    target.position = {0.0, 0.0, 1000.0};
    target.trueAirspeedMps = 100.0 * kKnot;
    return *trim(*testsupport::lightSingle(), *testsupport::earthHere(), testsupport::airAt(1000.0), target);
}

// Two flights with the same inputs, gusts and seed end in the same bytes.
TEST(AircraftTest, TheSameInputsGiveTheSameBytes)
{
    WeatherSettings weather;
    weather.gustDeviationMps = 2.0;
    const WeatherAir air(weather);
    const LevelGround ground;
    const TrimmedFlight flight = cruise();
    Aircraft first = testsupport::flying(flight), second = testsupport::flying(flight);
    std::mt19937 random(3);
    for (int i = 0; i < 1200; ++i)
    {
        const double elevator = static_cast<double>(random() % 1000U) / 5000.0 - 0.1;
        for (Aircraft* aircraft : {&first, &second})
        {
            setInput(*aircraft, FlightInput::elevator, elevator);
            aircraft->step(ground, air);
        }
    }
    EXPECT_EQ(std::memcmp(&first.flightState().motion, &second.flightState().motion, sizeof(BodyMotion)), 0);
}

TEST(AircraftTest, InputsThatAreNoNumbersCountAsNothing)
{
    Aircraft aircraft = testsupport::flying(cruise());
    for (double& input : aircraft.inputs())
        input = std::numeric_limits<double>::quiet_NaN();
    setInput(aircraft, FlightInput::throttle, std::numeric_limits<double>::infinity());
    for (int i = 0; i < 120; ++i)
        aircraft.step(LevelGround(), WeatherAir());
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound);
    EXPECT_TRUE(std::isfinite(aircraft.state().position.x));
}

TEST(AircraftTest, AStateThatIsNoneIsRefused)
{
    Aircraft aircraft = testsupport::flying(cruise());
    FlightState wrong = aircraft.flightState();
    wrong.motion.velocity.y = std::nan("");
    aircraft.place(wrong);
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::failed);
    aircraft.step(LevelGround(), WeatherAir());
    EXPECT_TRUE(std::isfinite(aircraft.state().velocity.y));
}

// Air that is not sound leaves a status, not a NaN.
TEST(AircraftTest, AirThatIsNoneEndsInAStatus)
{
    class Void : public Air
    {
        AirSample at(const glm::dvec3&, double, double) const override
        {
            AirSample sample;
            sample.windMps.x = std::nan("");
            return sample;
        }
    };
    Aircraft aircraft = testsupport::flying(cruise());
    aircraft.step(LevelGround(), Void());
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::failed);
    const VehicleState state = aircraft.state();
    EXPECT_TRUE(std::isfinite(state.position.x + state.velocity.x + state.bodyToScene.w + state.bodyRates.x));
}

TEST(AircraftTest, BurnsItsFuelAndStops)
{
    Aircraft aircraft = testsupport::flying(cruise());
    FlightState state = aircraft.flightState();
    state.fuelKg = {0.01, 0.02, 0.0, 0.0};
    aircraft.place(state);
    for (int i = 0; i < 120 * 20; ++i)
        aircraft.step(LevelGround(), WeatherAir());
    EXPECT_EQ(aircraft.readings().fuelKg, 0.0);
    EXPECT_EQ(aircraft.readings().fuelKgPerS, 0.0);
    EXPECT_LT(aircraft.readings().engineRpm, 1500.0);
}

// Stick back with the engine idle: the flow separates, the nose falls, and it flies again.
TEST(AircraftTest, StallsAndRecovers)
{
    Aircraft aircraft = testsupport::flying(cruise());
    setInput(aircraft, FlightInput::throttle, 0.0);
    double largestAlpha = 0.0, stalled = 0.0;
    for (int i = 0; i < 120 * 30; ++i)
    {
        const double time = i / 120.0;
        setInput(aircraft, FlightInput::elevator, time < 20.0 ? -std::min(1.2, time * 0.08) : 0.3);
        aircraft.step(LevelGround(), WeatherAir());
        largestAlpha = std::max(largestAlpha, aircraft.readings().alphaDeg);
        stalled = std::max(stalled, aircraft.flightState().stalled);
    }
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound);
    EXPECT_GT(largestAlpha, 18.0);
    EXPECT_EQ(aircraft.flightState().stalled, 0.0);
}

// Forces over the whole circle of angles are finite, and drag never pushes.
TEST(AircraftTest, AirDragsAtEveryAngle)
{
    const auto data = testsupport::lightSingle();
    for (int alpha = -180; alpha <= 180; alpha += 3)
        for (int beta = -90; beta <= 90; beta += 10)
        {
            const double a = alpha / 57.29578, b = beta / 57.29578;
            const glm::dvec3 velocity =
                40.0 * glm::dvec3(std::cos(a) * std::cos(b), std::sin(b), std::sin(a) * std::cos(b));
            const AirData air = airDataOf(velocity, glm::dvec3(0.0), 1.2);
            const ForceMoment load =
                aerodynamicForces(*data, air, {}, {0.0, 10.0, air.dynamicPressurePa}, glm::dvec3(0.0));
            EXPECT_LT(glm::dot(load.force, velocity), 0.0) << alpha << ' ' << beta;
            EXPECT_LT(glm::length(load.force), 3.0 * air.dynamicPressurePa * data->wingAreaM2);
        }
}

// Just above the ground the same wing lifts more and drags less.
TEST(AircraftTest, TheGroundCarries)
{
    const auto data = testsupport::lightSingle();
    const AirData air = airDataOf({30.0, 0.0, 3.0}, glm::dvec3(0.0), 1.2);
    const auto at = [&](double height) {
        return aerodynamicForces(*data, air, {}, {0.0, height, air.dynamicPressurePa}, glm::dvec3(0.0)).force;
    };
    EXPECT_LT(at(0.15).z, 1.05 * at(2.0).z);
    EXPECT_GT(glm::dot(at(0.15), air.velocity), glm::dot(at(2.0), air.velocity));
}

} // namespace
