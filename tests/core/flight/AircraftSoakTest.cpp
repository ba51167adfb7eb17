// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <random>

#include "FlightSupport.h"

namespace
{

using namespace simulation;

/// Hills and cliffs.
class Hills : public Ground
{
    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double x = points[i].x / 300.0, y = points[i].y / 200.0;
            const double step = std::fmod(std::abs(points[i].x), 900.0) < 450.0 ? 0.0 : 30.0;
            const glm::dvec3 normal(-80.0 / 300.0 * std::cos(x), 60.0 / 200.0 * std::sin(y), 1.0);
            answers[i] = {80.0 * std::sin(x) + 60.0 * std::cos(y) + step, glm::normalize(normal),
                          static_cast<GroundKind>(static_cast<unsigned>(std::abs(points[i].y) / 400.0) % 7U),
                          true};
        }
    }
};

/// The steps of a soak: 60 000, or what OSGTRAINER_SOAK_STEPS says.
int soakSteps()
{
    const char* const asked = std::getenv("OSGTRAINER_SOAK_STEPS");
    return asked ? std::atoi(asked) : 60000;
}

FlightState randomState(std::mt19937& random, const Aircraft& aircraft)
{
    const auto number = [&](double most)
    { return most * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
    FlightState state = aircraft.flightState();
    state.motion.position = {number(2000.0), number(2000.0), 100.0 + std::abs(number(200.0))};
    state.motion.attitude = glm::normalize(glm::dquat(number(1.0), number(1.0), number(1.0), number(1.0)));
    state.motion.velocity = {number(70.0), number(70.0), number(40.0)};
    state.motion.rates = {number(2.0), number(2.0), number(2.0)};
    state.engineRadps = std::abs(number(280.0));
    state.fuelKg = {40.0, 40.0, 0.0, 0.0};
    return state;
}

// Random controls, gusts and terrain, started anew every 20 s in any attitude: no number is lost, and
// whatever energy comes is bounded.
TEST(AircraftSoakTest, KeepsItsNumbersAndItsEnergy)
{
    WeatherSettings weather;
    weather.windMps = {8.0, -5.0, 1.0};
    weather.windAtSixMetresMps = 20.0;
    weather.gustDeviationMps = 5.0;
    const WeatherAir air(weather);
    const Hills ground;
    Aircraft aircraft(testsupport::lightSingle(), testsupport::earthHere(), 5);
    std::mt19937 random(11);
    int crashes = 0;
    double fastest = 0.0;
    for (int i = 0, steps = soakSteps(); i < steps; ++i)
    {
        if (i % 2400 == 0)
        {
            crashes += aircraft.status().condition == VehicleCondition::crashed;
            aircraft.place(randomState(random, aircraft));
        }
        if (i % 40 == 0)
            for (double& input : aircraft.inputs())
                input = static_cast<double>(random()) / 2147483648.0 - 1.0;
        aircraft.step(ground, air);
        const VehicleState state = aircraft.state();
        ASSERT_TRUE(std::isfinite(glm::length(state.position) + glm::length(state.velocity) +
                                  glm::length(state.bodyRates) + state.bodyToScene.w))
            << i;
        ASSERT_NE(aircraft.status().condition, VehicleCondition::failed) << i;
        fastest = std::max(fastest, glm::length(state.velocity));
        ASSERT_LT(glm::length(state.bodyRates), 15.1);
    }
    EXPECT_LT(fastest, 160.0);
    EXPECT_GT(crashes, 0);
}

// In still air without power, total energy never rises above where it began, but for what moments of the air
// put into turning.
TEST(AircraftSoakTest, WithoutPowerEnergyOnlyFalls)
{
    const WeatherAir air;
    const LevelGround ground;
    Aircraft aircraft(testsupport::lightSingle(), testsupport::earthHere());
    std::mt19937 random(2);
    for (int run = 0; run < 10; ++run)
    {
        FlightState state = randomState(random, aircraft);
        state.engineRadps = 0.0;
        aircraft.place(state);
        testsupport::setInput(aircraft, FlightInput::ignition, 0.0);
        const double before = aircraft.energyJ();
        const double rooms = 5000.0; // of turning, about 2 rad/s
        for (int i = 0; i < 3000; ++i)
        {
            if (i % 60 == 0)
                for (const FlightInput input :
                     {FlightInput::elevator, FlightInput::aileron, FlightInput::rudder})
                    testsupport::setInput(aircraft, input,
                                          static_cast<double>(random()) / 2147483648.0 - 1.0);
            aircraft.step(ground, air);
            ASSERT_LT(aircraft.energyJ(), before + rooms) << run << ' ' << i;
        }
    }
}

} // namespace
