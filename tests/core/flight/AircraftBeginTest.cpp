// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "FlightSupport.h"

namespace
{

using namespace simulation;
using testsupport::earthHere;
using testsupport::lightSingle;

/// A plane that rises to the east.
class RisingGround : public Ground
{
public:
    explicit RisingGround(double rise) : _rise(rise) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {_rise * points[i].x, glm::normalize(glm::dvec3(-_rise, 0.0, 1.0)),
                          GroundKind::grass, true};
    }

private:
    double _rise;
};

/// Where the unloaded main wheels' axle line meets the ground.
glm::dvec3 referenceOf(const Aircraft& aircraft)
{
    const VehicleState state = aircraft.state();
    return state.position + state.bodyToScene * aircraft.referencePoint();
}

TEST(AircraftBegin, StandsStillOnItsWheels)
{
    Aircraft aircraft(lightSingle(), earthHere());
    const LevelGround ground(420.0);
    const auto begun = aircraft.begin({{30.0, -20.0, 999.0}, 1.0, 0.0, false}, ground, WeatherAir());
    ASSERT_TRUE(begun) << begun.error().message();
    EXPECT_NEAR(referenceOf(aircraft).x, 30.0, 0.05);
    EXPECT_NEAR(referenceOf(aircraft).y, -20.0, 0.05);
    // Pressed in by the weight on the main wheels: some centimetres.
    EXPECT_LT(referenceOf(aircraft).z, 420.0 - 0.02);
    EXPECT_GT(referenceOf(aircraft).z, 420.0 - 0.08);
    const glm::dvec3 nose = aircraft.state().bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
    EXPECT_NEAR(std::atan2(nose.y, nose.x), 1.0, 1e-3);

    testsupport::setInput(aircraft, FlightInput::leftBrake, 1.0);
    testsupport::setInput(aircraft, FlightInput::rightBrake, 1.0);
    const glm::dvec3 before = aircraft.state().position;
    for (int i = 0; i < 1200; ++i)
        aircraft.step(ground, WeatherAir());
    EXPECT_LT(glm::distance(before, aircraft.state().position), 0.02);
    EXPECT_TRUE(aircraft.state().isOnGround);
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound);
    EXPECT_GT(aircraft.readings().engineRpm, 500.0); // it idles
}

TEST(AircraftBegin, FliesSteadilyOverTheGround)
{
    Aircraft aircraft(lightSingle(), earthHere());
    WeatherSettings weather;
    weather.windMps = {0.0, 8.0, 0.0}; // from the right of one that flies east
    const WeatherAir air(weather);
    const auto begun = aircraft.begin({{0.0, 0.0, 800.0}, 0.0, 50.0, true}, LevelGround(), air);
    ASSERT_TRUE(begun) << begun.error().message();
    for (int i = 0; i < 600; ++i)
        aircraft.step(LevelGround(), air);
    const VehicleState state = aircraft.state();
    EXPECT_NEAR(state.velocity.x, 50.0, 0.5);
    EXPECT_NEAR(state.velocity.y, 0.0, 0.5);
    EXPECT_NEAR(state.position.z, 800.0, 2.0);
    EXPECT_NEAR(aircraft.readings().betaDeg, 0.0, 0.5);
}

TEST(AircraftBegin, TellsWhyItCannot)
{
    Aircraft aircraft(lightSingle(), earthHere());
    const glm::dvec3 before = aircraft.state().position;
    const auto whatOf = [&](const VehicleStart& start, const Ground& ground)
    {
        const auto begun = aircraft.begin(start, ground, WeatherAir());
        return begun ? std::string("it began") : begun.error().message();
    };
    EXPECT_NE(whatOf({{0.0, 0.0, 100.0}, 0.0, 50.0, true}, LevelGround(150.0)).find("50 m inside the ground"),
              std::string::npos);
    EXPECT_NE(whatOf({{}, 0.0, 0.0, false}, LevelGround(0.0, GroundKind::water)).find("water"),
              std::string::npos);
    EXPECT_NE(whatOf({{}, 0.0, 0.0, false}, ProvidedGround({})).find("no ground"), std::string::npos);
    EXPECT_NE(whatOf({{}, 0.0, 0.0, false}, RisingGround(2.0)).find("steep"), std::string::npos);
    EXPECT_EQ(whatOf({{}, 0.0, 0.0, false}, RisingGround(0.1)), "it began");
    EXPECT_NE(whatOf({{0.0, 0.0, 500.0}, 0.0, 10.0, true}, LevelGround()).find("the start at"),
              std::string::npos);
    EXPECT_NE(whatOf({{0.0, 0.0, NAN}, 0.0, 50.0, true}, LevelGround()), "it began");
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound);
    EXPECT_NE(aircraft.state().position, before); // that of the slope of 10 %
}

TEST(AircraftParts, FollowInputsAndGround)
{
    Aircraft aircraft(lightSingle(), earthHere());
    ASSERT_TRUE(aircraft.begin({{}, 0.0, 10.0, false}, LevelGround(), WeatherAir()));
    testsupport::setInput(aircraft, FlightInput::aileron, 1.0);
    testsupport::setInput(aircraft, FlightInput::elevator, -1.0);
    testsupport::setInput(aircraft, FlightInput::rudder, 0.5);
    testsupport::setInput(aircraft, FlightInput::flaps, 1.0);
    EntityState entity;
    for (int i = 0; i < 12; ++i)
        aircraft.step(LevelGround(), WeatherAir());
    aircraft.writeParts(entity);
    ASSERT_TRUE(entity.aircraft);
    const AircraftParts& parts = *entity.aircraft;
    EXPECT_NEAR(parts.leftAileronDeg, 15.0, 1e-9);
    EXPECT_NEAR(parts.rightAileronDeg, -20.0, 1e-9);
    EXPECT_NEAR(parts.elevatorDeg, -28.0, 1e-9);
    EXPECT_NEAR(parts.rudderDeg, 8.0, 1e-9);
    EXPECT_NEAR(parts.flapDeg, 0.75, 1e-9); // 7.5 degrees a second
    EXPECT_NEAR(parts.noseSteeringDeg, 5.0, 1e-9);
    EXPECT_GT(parts.strutM[kNoseLeg], 0.0);
    EXPECT_GT(parts.strutM[kLeftLeg], 0.01);
    // A tenth of a second at 10 m/s on a wheel of 0.22 m.
    EXPECT_NEAR(parts.wheelTurnDeg[kLeftLeg], 1.0 / 0.22 * 180.0 / std::numbers::pi, 5.0);
    EXPECT_GT(parts.propellerTurnDeg, 0.0);
    EXPECT_TRUE(parts.hasNavigationLights);
    EXPECT_TRUE(entity.isOnGround);
}

} // namespace
