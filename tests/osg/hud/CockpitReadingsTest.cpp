// SPDX-License-Identifier: Apache-2.0
// What instruments are told, against the state of vehicles reckoned another way.
#include "view/CockpitReadings.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace
{

using namespace trainer;
using namespace simulation;
using scenery::models::Reading;

std::shared_ptr<const AircraftData> aircraftData()
{
    const auto data = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
    EXPECT_TRUE(data);
    return std::make_shared<const AircraftData>(*data);
}

void setInput(Aircraft& aircraft, FlightInput input, double value)
{
    aircraft.inputs()[static_cast<std::size_t>(input)] = value;
}

EntityState shownOf(const DynamicVehicle& vehicle)
{
    EntityState entity;
    entity.position = vehicle.state().position;
    entity.velocity = vehicle.state().velocity;
    vehicle.writeParts(entity);
    return entity;
}

TEST(CockpitReadings, OfAFlightAreItsState)
{
    const LevelGround ground;
    WeatherSettings weather;
    weather.offsets.seaPressurePa = 100'300.0;
    const WeatherAir air(weather);
    for (const double headingDeg : {0.0, 45.0, 130.0, 250.0, 359.0})
    {
        Aircraft aircraft(aircraftData(), std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0}));
        const double heightM = 200.0 + 5.0 * headingDeg;
        ASSERT_TRUE(aircraft.begin(
            {{0.0, 0.0, heightM}, (90.0 - headingDeg) / 180.0 * std::numbers::pi, 50.0, true}, ground, air));
        setInput(aircraft, FlightInput::aileron, 0.2);
        setInput(aircraft, FlightInput::rudder, 0.3);
        setInput(aircraft, FlightInput::flaps, headingDeg / 400.0);
        setInput(aircraft, FlightInput::elevatorTrim, -0.25);
        VehicleState before;
        for (int i = 0; i < 240; ++i)
        {
            before = aircraft.state();
            aircraft.step(ground, air);
        }
        const EntityState entity = shownOf(aircraft);
        const auto readings = cockpitReadings({entity, {}, &aircraft, true, 0.0, 1003.0});
        const VehicleState state = aircraft.state();
        const auto axis = [&](const VehicleState& of, double x, double y)
        { return of.bodyToScene * glm::dvec3(x, y, 0.0); };
        const glm::dvec3 forward = axis(state, 1.0, 0.0), left = axis(state, 0.0, 1.0);
        const double deg = 180.0 / std::numbers::pi;
        EXPECT_NEAR(readings[Reading::pitchDeg], std::asin(forward.z) * deg, 0.02);
        EXPECT_NEAR(readings[Reading::rollDeg],
                    std::atan2(left.z, (state.bodyToScene * glm::dvec3(0.0, 0.0, 1.0)).z) * deg, 0.02);
        EXPECT_NEAR(
            std::remainder(readings[Reading::headingDeg] - std::atan2(forward.x, forward.y) * deg, 360.0),
            0.0, 0.02);
        // Set to the pressure at the sea it shows the true height, but for the air being a little colder
        // there than the standard has it.
        EXPECT_NEAR(readings[Reading::altitudeFt] * 0.3048,
                    state.position.z * std::pow(1003.0 / 1013.25, 0.190263), 1.0);
        EXPECT_EQ(readings[Reading::altimeterHpa], 1003.0);
        EXPECT_NEAR(readings[Reading::climbFpm] * 0.3048 / 60.0, state.velocity.z, 0.01);
        const glm::dvec3 ahead = axis(before, 1.0, 0.0);
        const double turned =
            std::remainder((std::atan2(forward.x, forward.y) - std::atan2(ahead.x, ahead.y)) * deg, 360.0);
        EXPECT_NEAR(readings[Reading::turnDegps], turned * 120.0, 1.5);
        EXPECT_GT(std::abs(readings[Reading::slip]), 0.05); // the rudder is held
        EXPECT_EQ(readings[Reading::trim], 0.25);
        EXPECT_NEAR(readings[Reading::flapDeg], entity.aircraft->flapDeg, 1e-9);
        EXPECT_NEAR(readings[Reading::engineRpm], entity.aircraft->propellerRadps * 30.0 / std::numbers::pi,
                    1e-6);
        EXPECT_NEAR(readings[Reading::fuelLeft], aircraft.flightState().fuelKg[0] / 83.915, 1e-9);
        EXPECT_NEAR(readings[Reading::fuelRight], aircraft.flightState().fuelKg[1] / 83.915, 1e-9);
    }
}

/// 1 hPa is about 27 ft near the sea.
TEST(CockpitReadings, TheAltimeterFollowsItsSetting)
{
    Aircraft aircraft(aircraftData(), std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0}));
    ASSERT_TRUE(aircraft.begin({{0.0, 0.0, 300.0}, 0.0, 50.0, true}, LevelGround(), WeatherAir()));
    aircraft.step(LevelGround(), WeatherAir());
    const EntityState entity = shownOf(aircraft);
    const auto shown = [&](double hpa) {
        return cockpitReadings({entity, {}, &aircraft, true, 0.0, hpa})[Reading::altitudeFt];
    };
    for (const double hpa : {950.0, 980.0, 1013.25, 1030.0, 1050.0})
        EXPECT_NEAR(shown(hpa + 1.0) - shown(hpa), 27.3 * std::pow(1013.25 / hpa, 0.81), 0.4) << hpa;
}

TEST(CockpitReadings, OfADriveAreItsState)
{
    const auto data = readRoadVehicle(OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml");
    ASSERT_TRUE(data);
    const LevelGround ground;
    for (const double speedMps : {0.0, 5.0, 12.0, 25.0, 40.0})
    {
        RoadVehicle car(std::make_shared<const RoadVehicleData>(*data));
        car.place({{0.0, 0.0, 0.0}, 0.3, speedMps}, ground);
        car.roadInputs()[static_cast<std::size_t>(RoadInput::handbrake)] = 0.7;
        scenery::models::LitLamps lamps{};
        lamps[static_cast<std::size_t>(scenery::models::EntityLamp::Kind::indicatorRight)] = true;
        const EntityState entity = shownOf(car);
        const auto readings = cockpitReadings({entity, lamps, &car, false, 0.0, 1013.25});
        EXPECT_NEAR(readings[Reading::speedKmh], 3.6 * glm::length(car.state().velocity), 1e-6);
        EXPECT_EQ(readings[Reading::engineRpm], car.readings().engineRpm);
        EXPECT_EQ(readings[Reading::gear], car.readings().gear);
        EXPECT_EQ(readings[Reading::handbrake], 0.7);
        EXPECT_EQ(readings[Reading::indicatorLeft], 0.0);
        EXPECT_EQ(readings[Reading::indicatorRight], 1.0);
        EXPECT_EQ(readings[Reading::headLamps], 0.0);
    }
}

/// A car flashes as its input says, and not without it.
TEST(CockpitReadings, IndicatorsFlashAsTheyAreSwitched)
{
    const auto data = readRoadVehicle(OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml");
    ASSERT_TRUE(data);
    for (const double indicator : {-1.0, 0.0, 1.0})
    {
        RoadVehicle car(std::make_shared<const RoadVehicleData>(*data));
        car.place({{0.0, 0.0, 0.0}, 0.0, 0.0}, LevelGround());
        car.roadInputs()[static_cast<std::size_t>(RoadInput::indicator)] = indicator;
        int left = 0, right = 0;
        for (int i = 0; i < 420; ++i) // five flashes
        {
            car.step(LevelGround(), WeatherAir());
            const EntityState entity = shownOf(car);
            left += entity.lamps.at("indicatorLeft").isLit ? 1 : 0;
            right += entity.lamps.at("indicatorRight").isLit ? 1 : 0;
        }
        EXPECT_NEAR(left, indicator > 0.0 ? 210 : 0, 5);
        EXPECT_NEAR(right, indicator < 0.0 ? 210 : 0, 5);
    }
}

/// What moves without physics: a level turn of a bank has the rate of a coordinated one.
TEST(CockpitReadings, OfMotionAloneAreWhatFollowsFromIt)
{
    EntityState entity;
    entity.position = {0.0, 0.0, 1000.0};
    entity.speedMps = 50.0;
    entity.velocity = {50.0, 0.0, 2.54};
    entity.rollDeg = 30.0;
    entity.pitchDeg = -3.0;
    const auto flight = cockpitReadings({entity, {}, nullptr, true, 500.0, 1013.25});
    EXPECT_NEAR(flight[Reading::airspeedKt], 97.2, 0.05);
    EXPECT_NEAR(flight[Reading::altitudeFt], 4921.3, 4.0);
    EXPECT_NEAR(flight[Reading::climbFpm], 500.0, 0.1);
    EXPECT_NEAR(flight[Reading::turnDegps], 6.49, 0.01);
    EXPECT_EQ(flight[Reading::pitchDeg], 3.0);
    EXPECT_GT(flight[Reading::propellerRadps], 100.0);
    const auto drive = cockpitReadings({entity, {}, nullptr, false, 0.0, 1013.25});
    EXPECT_NEAR(drive[Reading::speedKmh], 180.0, 1e-9);
    EXPECT_EQ(drive[Reading::gear], 5.0);
    EXPECT_EQ(drive[Reading::propellerRadps], 0.0);
}

} // namespace
