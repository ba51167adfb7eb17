// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <random>

#include "RoadSupport.h"

namespace
{

using namespace simulation;

/// Hills, ditches and steps of all kinds of ground but water.
class RoughLand : public Ground
{
    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double x = points[i].x, y = points[i].y;
            const double step = std::fmod(std::abs(x), 60.0) < 30.0 ? 0.0 : 0.15;
            const double cliff = std::fmod(std::abs(y), 500.0) < 250.0 ? 0.0 : 4.0;
            answers[i] = {8.0 * std::sin(x / 40.0) + 5.0 * std::cos(y / 25.0) + step + cliff,
                          {0.0, 0.0, 1.0},
                          static_cast<GroundKind>(static_cast<unsigned>(std::abs(y) / 70.0) % 6U),
                          true};
        }
    }
};

/// The steps of a soak: 12 000, or what OSGTRAINER_SOAK_STEPS says.
int roadSoakSteps()
{
    const char* const asked = std::getenv("OSGTRAINER_SOAK_STEPS");
    return asked ? std::atoi(asked) : 12000;
}

class RoadVehicleSoak : public testing::TestWithParam<const char*>
{
};

// Random controls, gusts and terrain, started anew every 20 s: no number is lost, and no energy comes but
// from engine, fall and wind.
TEST_P(RoadVehicleSoak, KeepsItsNumbersAndItsEnergy)
{
    WeatherSettings weather;
    weather.windMps = {12.0, -8.0, 2.0};
    weather.gust = {3.0, 2.0, {20.0, 10.0, 5.0}};
    const WeatherAir air(weather);
    const RoughLand ground;
    RoadVehicle vehicle(testsupport::roadVehicle(GetParam()));
    std::mt19937 random(17);
    const auto number = [&](double most)
    { return most * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
    const double strongestW = 2.5e5 + 40.0 * vehicle.mass().massKg; // engine, and wind on its sides
    int crashes = 0, rolledOver = 0;
    double allowedJ = 0.0;
    for (int i = 0, steps = roadSoakSteps(); i < steps; ++i)
    {
        if (i % 2400 == 0)
        {
            crashes += vehicle.status().condition == VehicleCondition::crashed;
            rolledOver += vehicle.status().reason == "it rolled over";
            vehicle.place({{number(2000.0), number(2000.0), 0.0}, number(3.2), std::abs(number(60.0))},
                          ground);
            // Springs and what the ground's steps lift are in the allowance.
            allowedJ = vehicle.energyJ() + 12.0 * vehicle.mass().massKg * 9.81;
        }
        if (i % 40 == 0)
        {
            for (double& input : vehicle.inputs())
                input = number(1.0);
            vehicle.inputs()[static_cast<std::size_t>(RoadInput::gear)] = std::floor(number(4.0)) + 3.0;
            if (random() % 50U == 0) vehicle.inputs()[0] = NAN;
        }
        vehicle.step(ground, air);
        allowedJ += strongestW * RoadVehicle::kStepS;
        const VehicleState state = vehicle.state();
        ASSERT_TRUE(std::isfinite(glm::length(state.position) + glm::length(state.velocity) +
                                  glm::length(state.bodyRates) + state.bodyToScene.w))
            << i;
        ASSERT_NE(vehicle.status().condition, VehicleCondition::failed)
            << i << ' ' << vehicle.status().reason;
        ASSERT_LT(vehicle.energyJ(), allowedJ) << i;
        ASSERT_LT(glm::length(state.velocity), 110.0) << i;
    }
    EXPECT_GT(crashes, 0);
    RecordProperty("rolledOver", rolledOver);
}

// Without engine and wind, on level ground, energy only falls.
TEST_P(RoadVehicleSoak, WithoutPowerEnergyOnlyFalls)
{
    const LevelGround ground(0.0, GroundKind::asphalt);
    const WeatherAir air;
    RoadVehicle vehicle(testsupport::roadVehicle(GetParam()));
    std::mt19937 random(3);
    for (int run = 0; run < 5; ++run)
    {
        vehicle.place({{0.0, 0.0, 0.0}, 0.0, 8.0 * run}, ground);
        double before = vehicle.energyJ() + 0.02 * vehicle.mass().massKg * 9.81; // what the springs hold
        for (int i = 0; i < 1200; ++i)
        {
            if (i % 60 == 0)
            {
                testsupport::setInput(vehicle, RoadInput::steering, 1.0 - 2.0 * (random() % 2U));
                testsupport::setInput(vehicle, RoadInput::brake, 0.5 * (random() % 3U));
            }
            vehicle.step(ground, air);
            ASSERT_LT(vehicle.energyJ(), before) << run << ' ' << i;
        }
        EXPECT_LT(vehicle.energyJ(), before);
    }
}

INSTANTIATE_TEST_SUITE_P(Vehicles, RoadVehicleSoak, testing::ValuesIn(testsupport::kVehicleNames));

} // namespace
