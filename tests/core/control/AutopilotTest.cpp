// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/Autopilot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "TestCart.h"
#include "simulation/control/ControlledVehicle.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"

namespace
{

using namespace simulation;

constexpr double kKnotMps = 1852.0 / 3600.0;
constexpr double kNorth = std::numbers::pi / 2.0;

std::shared_ptr<const AircraftData> aircraftData()
{
    static const auto read = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
    EXPECT_TRUE(read) << read.error().message();
    return std::make_shared<const AircraftData>(*read);
}

/// A strip at the origin that leads north.
RunwayStrip strip()
{
    return {{0.0, 0.0, 0.0}, 0.0, 800.0, 30.0};
}

WeatherSettings wind(double fromWestKt)
{
    WeatherSettings weather;
    weather.windMps = {fromWestKt * kKnotMps, 0.0, 0.0};
    weather.windAtSixMetresMps = std::abs(weather.windMps.x);
    weather.gustDeviationMps = fromWestKt == 0.0 ? 0.0 : 1.0;
    return weather;
}

/// A flight and its figures.
struct Flight
{
    double touchdownSinkMps = -1.0, touchdownBesideM = 0.0, touchdownAlongM = 0.0;
    double mostBesideM = 0.0; ///< on the ground after the first touchdown
    VehicleState last;
    bool isDone = false;
    VehicleCondition condition = VehicleCondition::sound;
};

class Ride
{
public:
    Ride(const std::string& orders, const VehicleStart& start, const WeatherSettings& weather,
         std::uint64_t seed = 1, const RunwayStrip& runway = strip())
        : _air(weather)
    {
        const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
        auto aircraft = std::make_unique<Aircraft>(aircraftData(), earth, seed);
        const auto begun = aircraft->begin(start, _ground, _air);
        EXPECT_TRUE(begun) << begun.error().message();
        _aircraft = aircraft.get();
        const auto read = parseFlightOrders(orders, "orders");
        EXPECT_TRUE(read) << read.error().message();
        auto pilot = Autopilot::create({earth, *read, runway}, *aircraft);
        EXPECT_TRUE(pilot) << pilot.error().message();
        _vehicle.emplace(std::move(aircraft), std::make_unique<Autopilot>(std::move(*pilot)));
        _vehicle->look();
    }

    Flight fly(double mostS)
    {
        Flight flight;
        bool wasUp = false;
        for (double t = 0.0; t < mostS && !_vehicle->controller()->isDone(); t += _aircraft->stepSeconds())
        {
            _vehicle->step(_ground, _air, {});
            const VehicleState& now = _vehicle->now();
            wasUp = wasUp || now.position.z > 50.0;
            if (!wasUp || !now.isOnGround) continue;
            if (flight.touchdownSinkMps < 0.0)
            {
                flight.touchdownSinkMps = -_vehicle->before().velocity.z;
                flight.touchdownBesideM = now.position.x;
                flight.touchdownAlongM = now.position.y;
            }
            flight.mostBesideM = std::max(flight.mostBesideM, std::abs(now.position.x));
        }
        flight.last = _vehicle->now();
        flight.isDone = _vehicle->controller()->isDone();
        flight.condition = _vehicle->vehicle().status().condition;
        return flight;
    }

    FlightReadings readings() const { return _aircraft->readings(); }

private:
    LevelGround _ground;
    WeatherAir _air;
    Aircraft* _aircraft = nullptr;
    std::optional<ControlledVehicle> _vehicle;
};

Flight circuit(double fromWestKt, std::uint64_t seed)
{
    return Ride("takeoff; circuit; land", {{0.0, 20.0, 0.0}, kNorth, 0.0, false}, wind(fromWestKt), seed)
        .fly(400.0);
}

void expectSoundLanding(const Flight& flight, double sinkMps, double besideM)
{
    EXPECT_EQ(flight.condition, VehicleCondition::sound);
    EXPECT_TRUE(flight.isDone);
    EXPECT_GT(flight.touchdownSinkMps, 0.0);
    EXPECT_LT(flight.touchdownSinkMps, sinkMps);
    EXPECT_LT(std::abs(flight.touchdownBesideM), besideM);
    EXPECT_GT(flight.touchdownAlongM, 0.0);
    EXPECT_LT(flight.touchdownAlongM, 400.0);
    EXPECT_LT(flight.mostBesideM, 15.0); // half the strip's width
    EXPECT_LT(glm::length(flight.last.velocity), 0.1);
    EXPECT_LT(flight.last.position.y, 800.0);
    EXPECT_TRUE(flight.last.isOnGround);
}

TEST(Autopilot, TakesOffFliesACircuitAndLandsToAStop)
{
    expectSoundLanding(circuit(0.0, 1), 1.0, 1.5);
}

TEST(Autopilot, LandsInTenKnotsAcrossWithGustsFromEitherSide)
{
    for (const std::uint64_t seed : {1U, 4U, 9U, 14U})
        for (const double knots : {10.0, -10.0})
        {
            SCOPED_TRACE(std::to_string(knots) + " kt, seed " + std::to_string(seed));
            expectSoundLanding(circuit(knots, seed), 2.0, 7.0);
        }
}

/// The mutation of the tests above: a strip that the autopilot believes 30 m beside the true one is missed.
TEST(Autopilot, ACentreLineBesideTheStripIsNotOnIt)
{
    RunwayStrip beside = strip();
    beside.threshold.x = 30.0;
    const Flight flight =
        Ride("takeoff; circuit; land", {{0.0, 20.0, 0.0}, kNorth, 0.0, false}, wind(0.0), 1, beside)
            .fly(400.0);
    EXPECT_GT(std::abs(flight.touchdownBesideM), 7.0);
}

TEST(Autopilot, HoldsHeadingAltitudeAndSpeed)
{
    Ride ride("heading 120; altitude 700; speed 45; vertical_speed 2; wait 150",
              {{0.0, 0.0, 600.0}, kNorth, 50.0, true}, {});
    EXPECT_TRUE(ride.fly(151.0).isDone);
    const FlightReadings readings = ride.readings();
    EXPECT_NEAR(readings.headingDeg, 120.0, 1.5);
    EXPECT_NEAR(readings.place.heightM, 700.0, 3.0);
    EXPECT_NEAR(readings.calibratedAirspeedMps, 45.0, 0.5);
    EXPECT_NEAR(readings.climbMps, 0.0, 0.2);
}

TEST(Autopilot, ChangesAltitudeAtTheVerticalSpeedThatIsAsked)
{
    Ride ride("altitude 900; vertical_speed 2; wait 40", {{0.0, 0.0, 600.0}, kNorth, 45.0, true}, {});
    ride.fly(40.0);
    EXPECT_NEAR(ride.readings().climbMps, 2.0, 0.2);
}

TEST(Autopilot, ClimbsAtFullPowerWithTheSpeedByPitch)
{
    Ride ride("speed 38; climb 900", {{0.0, 0.0, 600.0}, kNorth, 45.0, true}, {});
    EXPECT_FALSE(ride.fly(30.0).isDone);
    EXPECT_NEAR(ride.readings().calibratedAirspeedMps, 38.0, 1.5);
    EXPECT_GT(ride.readings().climbMps, 3.0);
    EXPECT_TRUE(ride.fly(60.0).isDone);
    EXPECT_NEAR(ride.readings().place.heightM, 900.0, 12.0);
}

TEST(Autopilot, SaysWhatItCannotDo)
{
    const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
    const testsupport::TestCart cart;
    const auto ofACart = Autopilot::create({earth, {{FlightOrderKind::wait, 1.0}}, {}}, cart);
    ASSERT_FALSE(ofACart);
    EXPECT_NE(ofACart.error().what.find("elevator"), std::string::npos);
    const Aircraft aircraft(aircraftData(), earth);
    const auto noRunway = Autopilot::create({earth, {{FlightOrderKind::land, 0.0}}, {}}, aircraft);
    ASSERT_FALSE(noRunway);
    EXPECT_NE(noRunway.error().what.find("no runway"), std::string::npos);
}

TEST(FlightOrders, AreReadOrRefusedWithAReason)
{
    const auto read = parseFlightOrders(" takeoff;heading  240 ; ;climb 500;", "orders");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, (std::vector<FlightOrder>{{FlightOrderKind::takeOff, 0.0},
                                               {FlightOrderKind::heading, 240.0},
                                               {FlightOrderKind::climb, 500.0}}));
    EXPECT_TRUE(needsRunway(*read));
    for (const char* wrong : {"", ";", "loop", "heading", "heading x", "speed 5", "land 3", "wait nan"})
        EXPECT_FALSE(parseFlightOrders(wrong, "orders")) << wrong;
}

TEST(CourseLine, TellsBesideAndAlong)
{
    const CourseLine east{{10.0, 20.0}, kNorth};
    EXPECT_NEAR(east.alongM({15.0, 20.0, 0.0}), 5.0, 1e-12);
    EXPECT_NEAR(east.besideM({15.0, 17.0, 0.0}), 3.0, 1e-12); // south is on its right
}

} // namespace
