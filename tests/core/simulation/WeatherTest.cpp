// SPDX-License-Identifier: Apache-2.0
// What an EnvironmentAction says of the air and the road, and the air that vehicles with physics of their own
// meet: worked by hand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "RoadPlay.h"
#include "simulation/vehicle/ScenarioWeather.h"

namespace simulation
{
namespace
{

EnvironmentState environmentOf(const std::string& content)
{
    ScenarioText text;
    text.privates = roadplay::onLane(100.0);
    text.stories = story(event("a",
                               "<GlobalAction><EnvironmentAction><Environment name=\"e\">" + content +
                                   "</Environment></EnvironmentAction></GlobalAction>",
                               timeCondition(1.0)));
    return roadplay::played(text, 2.0)->environment();
}

TEST(Weather, WindBlowsTowardsItsDirectionFromTheXAxis)
{
    // 10 m/s towards 120° from x, counter-clockwise: −5 m/s along x, 8.660 m/s along y.
    const auto state =
        environmentOf("<Weather><Wind direction=\"2.0943951023931953\" speed=\"10\"/></Weather>");
    const WeatherAir air(weatherOf(state));
    const AirSample sample = air.at(glm::dvec3(0.0), 0.0, 0.0);
    EXPECT_NEAR(sample.windMps.x, -5.0, 1e-9);
    EXPECT_NEAR(sample.windMps.y, std::sqrt(75.0), 1e-9);
    EXPECT_EQ(sample.windMps.z, 0.0);
    EXPECT_EQ(weatherOf(environmentOf("<Weather/>")).windMps, glm::dvec3(0.0));
}

TEST(Weather, TemperatureAndPressureAreThoseAtTheOrigin)
{
    // ρ = p / (R T): 98 000 Pa and 303.15 K give 1.1262 kg/m³.
    const auto state = environmentOf("<Weather temperature=\"303.15\" atmosphericPressure=\"98000\"/>");
    for (const double heightM : {0.0, 1500.0})
    {
        const AirSample sample = WeatherAir(weatherOf(state, heightM)).at(glm::dvec3(0.0), heightM, 0.0);
        EXPECT_NEAR(sample.temperatureK, 303.15, 1e-9);
        EXPECT_NEAR(sample.pressurePa, 98000.0, 1e-6);
        EXPECT_NEAR(sample.densityKgPerM3, 98000.0 / (kGasConstant * 303.15), 1e-9);
    }
    EXPECT_NEAR(
        WeatherAir(weatherOf(environmentOf("<Weather/>"))).at(glm::dvec3(0.0), 0.0, 0.0).densityKgPerM3,
        kSeaDensity, 1e-3);
}

TEST(Weather, WhatAnActionLeavesOutStays)
{
    const auto state = environmentOf("<RoadCondition frictionScaleFactor=\"0.4\"/>");
    EXPECT_EQ(state.roadFriction, 0.4);
    EXPECT_FALSE(state.wind || state.fogVisualRangeM || state.precipitation);
    const auto rain = environmentOf(
        R"(<Weather cloudState="rainy"><Fog visualRange="800"/><Precipitation precipitationType="rain" precipitationIntensity="4"/></Weather>)");
    EXPECT_EQ(rain.roadFriction, 1.0);
    EXPECT_EQ(rain.fogVisualRangeM, 800.0);
    EXPECT_EQ(rain.precipitation->type, "rain");
    EXPECT_EQ(rain.precipitation->intensity, 4.0);
    EXPECT_EQ(rain.cloudState, "rainy");
}

} // namespace
} // namespace simulation
