// SPDX-License-Identifier: Apache-2.0
// What the head-up display shows against the state, and where its pointers are drawn.
#include "hud/Hud.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "hud/TextOverlay.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace
{

using namespace trainer;
using namespace simulation;

Aircraft someAircraft()
{
    const auto data = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
    EXPECT_TRUE(data);
    return Aircraft(std::make_shared<const AircraftData>(*data),
                    std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0}));
}

RoadVehicle someCar()
{
    const auto data = readRoadVehicle(OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml");
    EXPECT_TRUE(data);
    return RoadVehicle(std::make_shared<const RoadVehicleData>(*data));
}

/// Five values and both ends, and beyond them: where an independent reckoning puts the pointer.
TEST(Hud, PointersStandWhereTheScaleHasTheValue)
{
    const Aircraft aircraft = someAircraft();
    const HudLayout layout = hudLayoutOf(aircraft);
    Hud hud(layout);
    for (const auto& [wide, high] : {std::pair{640, 360}, std::pair{1920, 1080}, std::pair{400, 700}})
    {
        hud.resize(wide, high);
        for (const double share : {-0.5, 0.0, 0.2, 0.37, 0.5, 0.75, 1.0, 1.5})
        {
            std::vector<double> values;
            for (const GaugeKind& gauge : layout.gauges)
                values.push_back(gauge.least + share * (gauge.most - gauge.least));
            hud.setValues(values);
            for (std::size_t i = 0; i < values.size(); ++i)
            {
                const double wanted = hud.leftPx(i) + std::clamp(share, 0.0, 1.0) * hud.scale(i).lengthPx;
                EXPECT_NEAR(hud.pointerPx(i), wanted, 1e-3) << layout.gauges[i].label << " at " << share;
                EXPECT_GT(hud.scale(i).lengthPx, 40.0);
                EXPECT_LE(hud.leftPx(i) + hud.scale(i).lengthPx, wide);
            }
        }
    }
    hud.setValues(std::vector<double>(layout.gauges.size(), std::numeric_limits<double>::quiet_NaN()));
    EXPECT_NEAR(hud.pointerPx(0), hud.leftPx(0), 1e-3);
}

/// A pixel of a gauge's scale at 640x360, in its units.
double pixelOf(const GaugeKind& gauge)
{
    Hud hud({std::vector<GaugeKind>(6, gauge)});
    hud.resize(640, 360);
    return (gauge.most - gauge.least) / hud.scale(0).lengthPx;
}

TEST(HudValues, TellTheStateOfAnAircraftWithinAPixel)
{
    const LevelGround ground;
    const WeatherAir still;
    const auto gauges = hudLayoutOf(someAircraft()).gauges;
    for (const double headingDeg : {0.0, 45.0, 130.0, 250.0, 359.0})
    {
        Aircraft aircraft = someAircraft();
        const double heightM = 200.0 + 5.0 * headingDeg;
        ASSERT_TRUE(
            aircraft.begin({{0.0, 0.0, heightM}, (90.0 - headingDeg) / 180.0 * std::numbers::pi, 50.0, true},
                           ground, still));
        for (int i = 0; i < 60; ++i)
            aircraft.step(ground, still);
        const std::vector<double> values = hudValuesOf(aircraft);
        const VehicleState state = aircraft.state();
        const glm::dvec3 forward = state.bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
        const double compassDeg = std::atan2(forward.x, forward.y) / std::numbers::pi * 180.0;
        EXPECT_NEAR(values[1] * 0.3048, state.position.z, 0.3048 * pixelOf(gauges[1]));
        EXPECT_NEAR(std::remainder(values[2] - compassDeg, 360.0), 0.0, pixelOf(gauges[2]));
        EXPECT_NEAR(values[3] * 0.3048 / 60.0, state.velocity.z, 0.3048 / 60.0 * pixelOf(gauges[3]));
        // Calibrated airspeed is the true one by the square root of the density, compressibility aside.
        const double density = std::pow(1.0 - 2.25577e-5 * state.position.z, 4.2559);
        EXPECT_NEAR(values[0] / 1.943844, glm::length(state.velocity) * std::sqrt(density),
                    pixelOf(gauges[0]) / 1.943844);
    }
}

TEST(HudValues, TellTheStateOfACarWithinAPixel)
{
    const LevelGround ground;
    const auto gauges = hudLayoutOf(someCar()).gauges;
    for (const double speedMps : {0.0, 5.0, 12.0, 25.0, 40.0})
    {
        RoadVehicle car = someCar();
        car.place({{0.0, 0.0, 0.0}, 0.3, speedMps}, ground);
        const std::vector<double> values = hudValuesOf(car);
        EXPECT_NEAR(values[0], 3.6 * glm::length(car.state().velocity), pixelOf(gauges[0]));
        EXPECT_EQ(values[1], car.readings().engineRpm);
        EXPECT_EQ(values[2], car.readings().gear);
    }
}

/// The same state in each system of units: by factors written out here.
TEST(HudValues, AreInTheUnitsAskedFor)
{
    Aircraft aircraft = someAircraft();
    ASSERT_TRUE(aircraft.begin({{0.0, 0.0, 900.0}, 0.4, 50.0, true}, LevelGround(), WeatherAir()));
    aircraft.step(LevelGround(), WeatherAir());
    const auto usual = hudValuesOf(aircraft), metric = hudValuesOf(aircraft, HudUnits::metric);
    EXPECT_NEAR(metric[0], usual[0] * 1.852, 1e-9);
    EXPECT_NEAR(metric[1], usual[1] * 0.3048, 1e-9);
    EXPECT_NEAR(metric[3], usual[3] * 0.00508, 1e-9);
    EXPECT_EQ(hudLayoutOf(aircraft, HudUnits::metric).gauges[1].label, "ALT m");
    EXPECT_EQ(hudValuesOf(aircraft, HudUnits::imperial), usual);
    RoadVehicle car = someCar();
    car.place({{0.0, 0.0, 0.0}, 0.3, 25.0}, LevelGround());
    EXPECT_NEAR(hudValuesOf(car, HudUnits::imperial)[0], 55.92, 0.01);
    EXPECT_NEAR(hudValuesOf(car, HudUnits::metric)[0], 90.0, 1e-9);
    EXPECT_EQ(hudLayoutOf(car, HudUnits::imperial).gauges[0].label, "SPEED mph");
    for (const HudUnits units : {HudUnits::usual, HudUnits::metric, HudUnits::imperial})
        EXPECT_EQ(hudValuesOf(aircraft, units).size(), hudLayoutOf(aircraft, units).gauges.size());
}

TEST(Help, HasEveryKeyOfTheTable)
{
    for (const KeyScope vehicle : {KeyScope::all, KeyScope::flight, KeyScope::drive})
    {
        const std::vector<std::string> lines = helpLines(vehicle);
        std::size_t expected = 0;
        for (const KeyBinding& binding : keyTable())
        {
            if (!isFor(binding, vehicle)) continue;
            ASSERT_LT(expected, lines.size());
            EXPECT_EQ(lines[expected].rfind(std::string(binding.key) + " ", 0), 0U) << lines[expected];
            EXPECT_NE(lines[expected].find(binding.text), std::string::npos);
            EXPECT_LE(lines[expected].size(), 42U) << "longer than a column at 640x360";
            ++expected;
        }
        EXPECT_EQ(expected, lines.size());
    }
}

} // namespace
