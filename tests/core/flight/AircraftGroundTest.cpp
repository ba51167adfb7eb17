// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <foundation/Angle.h>

#include "FlightSupport.h"
#include "simulation/vehicle/WeatheredGround.h"

namespace
{

using namespace simulation;
using testsupport::kKnot;
using testsupport::setInput;

/// Ground that rises to the north.
class Slope : public Ground
{
public:
    explicit Slope(double rise) : _rise(rise) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {_rise * points[i].y, glm::normalize(glm::dvec3(0.0, -_rise, 1.0)),
                          GroundKind::asphalt, true};
    }

private:
    double _rise;
};

void stepFor(Aircraft& aircraft, const Ground& ground, double seconds)
{
    const WeatherAir air;
    for (int i = 0; i < static_cast<int>(seconds * 120.0); ++i)
        aircraft.step(ground, air);
}

TEST(AircraftGroundTest, StandsOnItsWheelsWithoutCreeping)
{
    Aircraft aircraft = testsupport::standing();
    stepFor(aircraft, LevelGround(), 10.0);
    const glm::dvec3 settled = aircraft.state().position;
    EXPECT_TRUE(aircraft.state().isOnGround);
    double load = 0.0;
    for (const Contact& contact : aircraft.contacts())
        load += contact.loadN;
    EXPECT_NEAR(load, aircraft.readings().massKg * 9.806, 20.0);
    for (int i = 0; i < 60; ++i)
    {
        stepFor(aircraft, LevelGround(), 0.5);
        EXPECT_LT(glm::length(aircraft.state().position - settled), 1e-3);
    }
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound);
}

// With brakes on a slope of 10 % it stays; without, it rolls back: the control.
TEST(AircraftGroundTest, BrakesHoldOnASlope)
{
    for (const double brake : {1.0, 0.0})
    {
        Aircraft aircraft = testsupport::standing();
        setInput(aircraft, FlightInput::leftBrake, brake);
        setInput(aircraft, FlightInput::rightBrake, brake);
        stepFor(aircraft, Slope(0.1), 10.0);
        const glm::dvec3 settled = aircraft.state().position;
        stepFor(aircraft, Slope(0.1), 20.0);
        const double moved = glm::length(aircraft.state().position - settled);
        if (brake > 0.0)
            EXPECT_LT(moved, 1e-3);
        else
            EXPECT_GT(moved, 5.0);
    }
}

// Full throttle on a level strip: it rolls straight enough to hold with the feet, and flies off.
TEST(AircraftGroundTest, TakesOff)
{
    Aircraft aircraft = testsupport::standing();
    FlightState state = aircraft.flightState();
    state.engineRadps = 80.0;
    aircraft.place(state);
    setInput(aircraft, FlightInput::throttle, 1.0);
    double groundRollM = 0.0;
    for (int i = 0; i < 120 * 40 && aircraft.readings().heightAboveGroundM < 15.0; ++i)
    {
        const FlightReadings readings = aircraft.readings();
        const double yaw = std::remainder(readings.headingDeg, 360.0);
        setInput(aircraft, FlightInput::rudder,
                 std::clamp(0.1 * yaw + 0.03 * aircraft.state().position.x, -1.0, 1.0));
        setInput(aircraft, FlightInput::aileron, std::clamp(-0.02 * readings.rollDeg, -1.0, 1.0));
        const double wanted = readings.calibratedAirspeedMps > 55.0 * kKnot ? 8.0 : 0.0;
        setInput(aircraft, FlightInput::elevator,
                 std::clamp(-0.06 * (wanted - readings.pitchDeg), -1.0, 1.0));
        aircraft.step(LevelGround(), WeatherAir());
        if (aircraft.state().isOnGround) groundRollM = aircraft.state().position.y;
    }
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound) << aircraft.status().reason;
    EXPECT_GT(aircraft.readings().heightAboveGroundM, 14.9);
    EXPECT_GT(groundRollM, 100.0);
    EXPECT_LT(groundRollM, 400.0);
    EXPECT_LT(std::abs(aircraft.state().position.x), 15.0);
}

// Braking on wet asphalt and on snow takes longer than on dry, by the grip.
TEST(AircraftGroundTest, FrictionDecidesTheBrakingDistance)
{
    const auto distance = [](GroundKind kind)
    {
        const LevelGround ground(0.0, kind);
        Aircraft aircraft = testsupport::standing();
        stepFor(aircraft, ground, 5.0);
        FlightState state = aircraft.flightState();
        state.motion.velocity.y = 15.0;
        aircraft.place(state);
        setInput(aircraft, FlightInput::leftBrake, 0.8);
        setInput(aircraft, FlightInput::rightBrake, 0.8);
        const double from = aircraft.state().position.y;
        stepFor(aircraft, ground, 20.0);
        return aircraft.state().position.y - from;
    };
    const double dry = distance(GroundKind::asphalt), wet = distance(GroundKind::wetAsphalt),
                 snow = distance(GroundKind::snow);
    EXPECT_GT(wet, 1.2 * dry);
    EXPECT_GT(snow, 1.25 * wet);
    EXPECT_GT(dry, 15.0);
    EXPECT_LT(dry, 45.0);
}

/// From 25 m/s down to walking pace, with both brakes, on a runway under a weather. Metres.
double landingRunM(const SurfaceWeather& surface)
{
    EnvironmentState environment;
    environment.surface = surface;
    const WeatheredGround ground(std::make_shared<LevelGround>(), groundWeatherOf(environment));
    Aircraft aircraft = testsupport::standing();
    stepFor(aircraft, ground, 5.0);
    FlightState state = aircraft.flightState();
    state.motion.velocity.y = 25.0;
    aircraft.place(state);
    setInput(aircraft, FlightInput::leftBrake, 0.8);
    setInput(aircraft, FlightInput::rightBrake, 0.8);
    const double from = aircraft.state().position.y;
    stepFor(aircraft, ground, 40.0);
    return aircraft.state().position.y - from;
}

TEST(AircraftGroundTest, ALandingRunIsLongerOnAWetRunwayAndLongestOnIce)
{
    const double dry = landingRunM({}), wet = landingRunM({0.5}), snow = landingRunM({0.0, 3.0}),
                 ice = landingRunM({0.5, 0.0, true});
    EXPECT_GT(wet, 1.15 * dry);
    EXPECT_GT(snow, 1.1 * wet);
    EXPECT_GT(ice, 1.1 * snow);
    EXPECT_DOUBLE_EQ(landingRunM({0.0, 3.0, false, true}), dry) << "a runway that is cleared";
}

TEST(AircraftGroundTest, ADiveEndsAsWreckage)
{
    Aircraft aircraft = testsupport::standing();
    FlightState state = aircraft.flightState();
    state.motion.position.z = 100.0;
    state.motion.velocity = {0.0, 50.0, -40.0};
    aircraft.place(state);
    stepFor(aircraft, LevelGround(), 60.0);
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::crashed);
    EXPECT_FALSE(aircraft.status().reason.empty());
    EXPECT_LT(glm::length(aircraft.state().velocity), 0.1);
    EXPECT_LT(std::abs(aircraft.state().position.z), 5.0);
}

/// Whatever a wreck lies on, it is on the ground: the wings, the nose, the roof.
TEST(AircraftGroundTest, AWreckLiesOnTheGround)
{
    for (const double rollDeg : {0.0, 60.0, 120.0, 180.0, -90.0})
        for (const double downMps : {20.0, 60.0})
        {
            Aircraft aircraft = testsupport::standing();
            FlightState state = aircraft.flightState();
            state.motion.position.z = 60.0;
            state.motion.velocity = {0.0, 40.0, -downMps};
            state.motion.attitude = state.motion.attitude *
                                    glm::angleAxis(foundation::radiansOf(rollDeg), glm::dvec3(1.0, 0.0, 0.0));
            aircraft.place(state);
            stepFor(aircraft, LevelGround(), 30.0);
            ASSERT_EQ(aircraft.status().condition, VehicleCondition::crashed) << rollDeg << " " << downMps;
            EXPECT_TRUE(aircraft.state().isOnGround) << rollDeg << " " << downMps;
        }
}

TEST(AircraftGroundTest, AStartInsideAHillIsACrashAndNoExplosion)
{
    Aircraft aircraft = testsupport::standing(-500.0);
    double fastest = 0.0;
    for (int i = 0; i < 600; ++i)
    {
        stepFor(aircraft, LevelGround(), 1.0 / 120.0);
        fastest = std::max(fastest, glm::length(aircraft.state().velocity));
    }
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::crashed);
    EXPECT_LT(fastest, 15.0);
    EXPECT_NEAR(aircraft.state().position.z, 1.0, 2.0);
}

TEST(AircraftGroundTest, WaterIsNoRunway)
{
    Aircraft aircraft = testsupport::standing(2.0);
    stepFor(aircraft, LevelGround(0.0, GroundKind::water), 2.0);
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::crashed);
    EXPECT_EQ(aircraft.status().reason, "it came down on water");
}

} // namespace
