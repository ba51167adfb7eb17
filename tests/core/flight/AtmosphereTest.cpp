// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/WeatherAir.h"

namespace
{

using namespace simulation;

/// The geometric height of a geopotential one.
double geometric(double geopotentialM)
{
    return 6356766.0 * geopotentialM / (6356766.0 - geopotentialM);
}

// The figures of the standard's own table.
TEST(StandardAtmosphereTest, HasTheTableOfIcao)
{
    struct Row
    {
        double geopotentialM, temperatureK, pressurePa, densityKgPerM3;
    };
    for (const Row& row : {Row{-1000.0, 294.651, 113929.0, 1.34700}, Row{0.0, 288.15, 101325.0, 1.22500},
                           Row{5000.0, 255.65, 54019.9, 0.736116}, Row{11000.0, 216.65, 22632.0, 0.363918},
                           Row{15000.0, 216.65, 12044.6, 0.193674}})
    {
        const AirState air = standardAtmosphere(geometric(row.geopotentialM));
        EXPECT_NEAR(air.temperatureK, row.temperatureK, 0.01) << row.geopotentialM;
        EXPECT_NEAR(air.pressurePa / row.pressurePa, 1.0, 1e-4) << row.geopotentialM;
        EXPECT_NEAR(air.densityKgPerM3 / row.densityKgPerM3, 1.0, 1e-4) << row.geopotentialM;
    }
}

TEST(StandardAtmosphereTest, AHotDayWithLowPressureIsThinner)
{
    const AirState air = standardAtmosphere(0.0, {20.0, 99000.0});
    EXPECT_DOUBLE_EQ(air.temperatureK, 308.15);
    EXPECT_NEAR(air.densityKgPerM3, 99000.0 / (287.05287 * 308.15), 1e-9);
    EXPECT_GT(standardAtmosphere(3000.0, {20.0, 101325.0}).pressurePa, standardAtmosphere(3000.0).pressurePa)
        << "warm air is taller";
}

// 100 kt calibrated at 4000 ft are 179.018 ft/s (JSBSim).
TEST(StandardAtmosphereTest, CalibratedAirspeedGoesBothWays)
{
    const AirState air = standardAtmosphere(4000.0 * 0.3048);
    const double knots = 1852.0 / 3600.0;
    EXPECT_NEAR(trueAirspeed(100.0 * knots, air), 179.018 * 0.3048, 0.01);
    EXPECT_NEAR(calibratedAirspeed(trueAirspeed(60.0, air), air), 60.0, 1e-9);
}

TEST(WeatherAirTest, AGustRisesAndFallsOnce)
{
    WeatherSettings weather;
    weather.windMps = {3.0, 0.0, 0.0};
    weather.gust = {10.0, 4.0, {0.0, 8.0, 0.0}};
    const WeatherAir air(weather);
    const auto north = [&](double timeS) { return air.at(glm::dvec3(0.0), 100.0, timeS).windMps.y; };
    EXPECT_EQ(north(9.9), 0.0);
    EXPECT_NEAR(north(11.0), 4.0, 1e-12);
    EXPECT_NEAR(north(12.0), 8.0, 1e-12);
    EXPECT_EQ(north(14.1), 0.0);
    EXPECT_EQ(air.at(glm::dvec3(0.0), 100.0, 12.0).windMps.x, 3.0);
}

} // namespace
