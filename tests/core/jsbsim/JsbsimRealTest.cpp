// SPDX-License-Identifier: Apache-2.0
// JSBSim itself: scripts/jsbsim fetches Debian's, OSGTRAINER_JSBSIM names its program; its aircraft are those
// of the real data.
#include <cstdlib>

#include "JsbsimSupport.h"
#include "RealData.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/flight/Trim.h"

namespace
{

using namespace simulation;
using namespace testsupport;

// NOLINTBEGIN(bugprone-macro-parentheses): `data` is the name that is declared
/// Declares `data`: an aircraft of JSBSim; without JSBSim the test is skipped and says so.
#define OSGTRAINER_JSBSIM_OR_SKIP(data, aircraftName)                                                        \
    const char* const data##Program = std::getenv("OSGTRAINER_JSBSIM");                                      \
    if (!data##Program || !*data##Program)                                                                   \
        GTEST_SKIP()                                                                                         \
            << "NOT TESTED WITH JSBSIM: set OSGTRAINER_JSBSIM to its program (scripts/jsbsim fetches it)";   \
    OSGTRAINER_REAL_DATA_OR_SKIP(data##Root, "jsbsim/aircraft");                                             \
    const auto data = std::make_shared<JsbsimData>();                                                        \
    data->name = data->aircraft = aircraftName;                                                              \
    data->root = data##Root;                                                                                 \
    data->program = data##Program
// NOLINTEND(bugprone-macro-parentheses)

const LevelGround kSea;

TEST(Jsbsim, KeepsTheSteadyFlightThatItFound)
{
    OSGTRAINER_JSBSIM_OR_SKIP(data, "c172p");
    JsbsimVehicle vehicle(data, earthOfJsbsim());
    ASSERT_TRUE(vehicle.begin({{0.0, 0.0, 1000.0}, 0.0, 50.0, true}, kSea, WeatherAir()));
    EXPECT_EQ(vehicle.note(), "");
    for (int i = 0; i < 1200; ++i)
        vehicle.step(kSea, WeatherAir());
    ASSERT_EQ(vehicle.status().condition, VehicleCondition::sound) << vehicle.status().reason;
    EXPECT_NEAR(vehicle.state().position.x, 500.0, 1.0);
    EXPECT_NEAR(vehicle.state().position.z, 1000.0, 0.5);
    EXPECT_NEAR(glm::length(vehicle.state().velocity), 50.0, 0.1);
    EXPECT_GT(vehicle.inputs()[static_cast<std::size_t>(FlightInput::throttle)], 0.3);
}

TEST(Jsbsim, KeepsASteadyFlightInWind)
{
    OSGTRAINER_JSBSIM_OR_SKIP(data, "c172x");
    WeatherSettings weather;
    weather.windMps = {0.0, 8.0, 0.0};
    const WeatherAir air(weather);
    JsbsimVehicle vehicle(data, earthOfJsbsim());
    ASSERT_TRUE(vehicle.begin({{0.0, 0.0, 1000.0}, 0.0, 50.0, true}, kSea, air));
    EXPECT_EQ(vehicle.note(), "");
    for (int i = 0; i < 600; ++i)
        vehicle.step(kSea, air);
    // Over the ground eastwards; the nose 9.1° (asin 8/50.6) to the right, into the wind from the south.
    EXPECT_NEAR(vehicle.state().position.x, 250.0, 2.0);
    EXPECT_NEAR(vehicle.state().position.y, 0.0, 2.0);
    const glm::dvec3 nose = vehicle.state().bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
    EXPECT_NEAR(std::atan2(-nose.y, nose.x), std::atan2(8.0, 50.0), 0.03);
}

TEST(Jsbsim, StandsOnAHill)
{
    OSGTRAINER_JSBSIM_OR_SKIP(data, "c172p");
    const LevelGround hill(1234.5, GroundKind::asphalt);
    JsbsimVehicle vehicle(data, earthOfJsbsim());
    ASSERT_TRUE(vehicle.begin({{3000.0, -2000.0, 1234.5}, 0.3, 0.0, false}, hill, WeatherAir()));
    for (int i = 0; i < 240; ++i)
        vehicle.step(hill, WeatherAir());
    ASSERT_EQ(vehicle.status().condition, VehicleCondition::sound);
    EXPECT_TRUE(vehicle.state().isOnGround);
    // JSBSim by itself stands there with its centre of mass 4.356 ft above the ground.
    EXPECT_NEAR(vehicle.state().position.z - 1234.5, 4.356 * 0.3048, 0.01);
}

TEST(Jsbsim, FliesAnAircraftOfAnotherKindAndABall)
{
    OSGTRAINER_JSBSIM_OR_SKIP(data, "T37");
    JsbsimVehicle jet(data, earthOfJsbsim());
    ASSERT_TRUE(jet.begin({{0.0, 0.0, 1000.0}, 1.0, 120.0, true}, kSea, WeatherAir()));
    data->aircraft = "ball";
    JsbsimVehicle ball(data, earthOfJsbsim());
    ASSERT_TRUE(ball.begin({{0.0, 0.0, 1000.0}, 0.0, 50.0, true}, kSea, WeatherAir()));
    EXPECT_NE(ball.note(), ""); // a ball has no steady flight
    for (int i = 0; i < 360; ++i)
        for (JsbsimVehicle* vehicle : {&jet, &ball})
            vehicle->step(kSea, WeatherAir());
    EXPECT_NEAR(glm::length(jet.state().position - glm::dvec3(0.0, 0.0, 1000.0)), 360.0, 2.0);
    EXPECT_NEAR(jet.state().position.z, 1000.0, 2.0);
    EXPECT_NEAR(ball.state().position.z, 1000.0 - 0.5 * 9.8 * 9.0, 0.5); // it falls
    EXPECT_NEAR(ball.state().position.x, 150.0, 0.5);
}

/// Pitch and height of an aircraft through a push and a pull of the elevator, from its own trim on.
std::vector<glm::dvec2> doublet(DynamicVehicle& vehicle)
{
    std::vector<glm::dvec2> motion;
    const double trimmed = vehicle.inputs()[0];
    for (int i = 0; i < 1200; ++i)
    {
        const double timeS = i / 120.0;
        vehicle.inputs()[0] = trimmed + (timeS < 1.0 ? 0.0 : timeS < 2.0 ? -0.1 : timeS < 3.0 ? 0.1 : 0.0);
        vehicle.step(kSea, WeatherAir());
        const glm::dvec3 nose = vehicle.state().bodyToScene * glm::dvec3(1.0, 0.0, 0.0);
        motion.emplace_back(std::asin(nose.z), vehicle.state().position.z);
    }
    return motion;
}

TEST(Jsbsim, FliesAsOurOwnAircraftFromOneTrim)
{
    OSGTRAINER_JSBSIM_OR_SKIP(data, "c172p");
    const VehicleStart start{{0.0, 0.0, 1000.0}, 0.0, 51.4, true};
    JsbsimVehicle theirs(data, earthOfJsbsim());
    ASSERT_TRUE(theirs.begin(start, kSea, WeatherAir()));
    const auto read = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
    ASSERT_TRUE(read);
    Aircraft ours(std::make_shared<const AircraftData>(*read), earthOfJsbsim());
    ASSERT_TRUE(ours.begin(start, kSea, WeatherAir()));
    const auto throttle = static_cast<std::size_t>(FlightInput::throttle);
    EXPECT_NEAR(ours.inputs()[throttle], theirs.inputs()[throttle], 0.03);
    const std::vector<glm::dvec2> own = doublet(ours), other = doublet(theirs);
    for (int axis = 0; axis < 2; ++axis)
    {
        double sum = 0.0, largest = 0.0;
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            const double ofOwn = own[i][axis] - own[0][axis], ofOther = other[i][axis] - other[0][axis];
            sum += (ofOwn - ofOther) * (ofOwn - ofOther);
            largest = std::max(largest, std::abs(ofOther));
        }
        const double rms = std::sqrt(sum / static_cast<double>(own.size()));
        RecordProperty(axis == 0 ? "pitch_share" : "height_share", std::to_string(rms / largest));
        std::printf("%s: RMS %.2f %% of the largest excursion %.3f\n", axis == 0 ? "pitch" : "height",
                    100.0 * rms / largest, largest);
        EXPECT_LT(rms, 0.1 * largest);
    }
}

} // namespace
