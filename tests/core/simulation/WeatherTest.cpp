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

TEST(Weather, ReportedPressureIsReducedToTheSeaByTheStandardAtmosphere)
{
    // An altimeter that is set to the report shows the geopotential height of the origin, 999.843 m, whatever
    // the day's temperature: p = 101325 (1 - 0.0065 (H + Hq) / 288.15)^5.25588, Hq = -39.47 m of 1018 hPa.
    constexpr double kHereM = 999.8427, kSettingPa = 101800.0;
    const double settingM = 288.15 / 0.0065 * (1.0 - std::pow(kSettingPa / 101325.0, 1.0 / 5.25588));
    const double herePa = 101325.0 * std::pow(1.0 - 0.0065 * (kHereM + settingM) / 288.15, 5.25588);
    EXPECT_NEAR(herePa, 90307.3, 1.0);
    EnvironmentClock clock(Geodetic{47.0, 11.0, 1000.0});
    Environment environment;
    environment.weather.emplace();
    environment.weather->pressurePa = 98000.0;
    clock.apply(environment, 0.0);
    environment.weather->pressurePa.reset();
    environment.weather->seaPressurePa = kSettingPa;
    clock.apply(environment, 0.0);
    EXPECT_FALSE(clock.at(0.0).pressurePa) << "the last one counts";
    const auto here = [&]
    { return WeatherAir(weatherOf(clock.at(0.0), 1000.0)).at(glm::dvec3(0.0), 1000.0, 0.0); };
    for (const double temperatureK : {255.0, 281.65, 305.0})
    {
        environment.weather->temperatureK = temperatureK;
        clock.apply(environment, 0.0);
        EXPECT_NEAR(here().temperatureK, temperatureK, 1e-9);
        EXPECT_NEAR(here().pressurePa, herePa, 0.5);
        EXPECT_NEAR(altimeterHeight(here().pressurePa, kSettingPa), kHereM, 1e-3);
    }
    environment.weather->seaPressurePa.reset();
    environment.weather->pressurePa = 98000.0;
    clock.apply(environment, 0.0);
    EXPECT_NEAR(here().pressurePa, 98000.0, 1e-6) << "told for the origin itself";
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

/// What tables tell of an aircraft that goes east at 50 m/s, 1 000 m above the sea, as a recording does.
std::optional<VehicleReadings> readingsIn(const std::string& weather, const std::string& object)
{
    ScenarioText text;
    text.entities = "<ScenarioObject name=\"Ego\">" + object + "</ScenarioObject>";
    text.privates = followTrajectory(vertex(R"(<WorldPosition x="0" y="0" z="0"/>)", "0") +
                                         vertex(R"(<WorldPosition x="5000" y="0" z="0"/>)", "100"),
                                     kTiming);
    text.globals = "<GlobalAction><EnvironmentAction><Environment name=\"e\">" + weather +
                   "</Environment></EnvironmentAction></GlobalAction>";
    auto parsed = parseScenario(text.text(), "air.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    PlayerOptions options;
    options.origin = Geodetic{46.0, 8.0, 1000.0};
    const auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    for (int i = 0; i < 120; ++i)
        (*player)->step();
    return (*player)->entities().at(0).readings;
}

const std::string kPlane = R"(<MiscObject name="plane" miscObjectCategory="none" mass="1100">
<BoundingBox><Center x="0" y="0" z="1"/><Dimensions width="11" length="8" height="2"/></BoundingBox>
<Properties><Property name="domain" value="air"/></Properties></MiscObject>)";

TEST(Weather, AircraftWithoutPhysicsHaveAirspeedsWhereTheWindIsKnown)
{
    // The air moves north at 20 m/s: √(50² + 20²) m/s go past the aircraft.
    const std::string wind = "<Weather><Wind direction=\"1.5707963267948966\" speed=\"20\"/></Weather>";
    const auto told = readingsIn(wind, kPlane);
    ASSERT_TRUE(told && told->trueAirspeedMps && told->calibratedAirspeedMps);
    EXPECT_NEAR(*told->trueAirspeedMps, std::sqrt(2900.0), 1e-3);
    // Slow air is incompressible: calibrated is to true as the root of the densities, 1.1117 over 1.225
    // kg/m³.
    EXPECT_NEAR(*told->calibratedAirspeedMps, std::sqrt(2900.0 * 1.1117 / 1.225), 0.1);
    EXPECT_EQ(told->condition, "") << "it has no physics";
    EXPECT_FALSE(readingsIn("<Weather/>", kPlane)) << "nobody says how the air moves";
    EXPECT_FALSE(readingsIn(wind, kCar)) << "a car has none";
}

} // namespace
} // namespace simulation
