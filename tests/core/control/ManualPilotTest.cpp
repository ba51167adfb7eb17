// SPDX-License-Identifier: Apache-2.0
// An aircraft by hand, and an autopilot that gets it back.
#include "simulation/control/flight/ManualPilot.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulation/control/ControlSwitch.h"
#include "simulation/control/ControlledVehicle.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"

namespace
{

using namespace simulation;

/// An aircraft over level ground, which `orders` fly until the person takes it; without orders the person has
/// it.
class Cockpit
{
public:
    explicit Cockpit(const char* orders, const VehicleStart& start)
    {
        const auto data = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
        EXPECT_TRUE(data);
        const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
        auto aircraft = std::make_unique<Aircraft>(std::make_shared<const AircraftData>(*data), earth);
        EXPECT_TRUE(aircraft->begin(start, _ground, _air));
        _aircraft = aircraft.get();
        std::unique_ptr<VehicleController> automatic;
        if (orders)
        {
            const auto read = parseFlightOrders(orders, "orders");
            auto pilot = Autopilot::create({earth, *read, std::nullopt}, *aircraft);
            EXPECT_TRUE(pilot);
            automatic = std::make_unique<Autopilot>(std::move(*pilot));
        }
        auto manual = manualPilot(*aircraft);
        EXPECT_TRUE(manual);
        auto both =
            std::make_unique<ControlSwitch>(std::move(automatic), std::move(*manual), orders == nullptr);
        _both = both.get();
        _vehicle.emplace(std::move(aircraft), std::move(both));
        _vehicle->look();
    }

    void run(double seconds)
    {
        for (int i = 0; i < std::lround(seconds * 120.0); ++i)
            _vehicle->step(_ground, _air, {});
    }

    void hold(std::string_view input, double direction)
    {
        _both->manual().hold(static_cast<std::size_t>(_both->manual().axisOf(input)), direction);
    }

    ControlSwitch& both() { return *_both; }
    FlightReadings readings() const { return _aircraft->readings(); }
    VehicleCondition condition() const { return _aircraft->status().condition; }

private:
    LevelGround _ground;
    WeatherAir _air;
    Aircraft* _aircraft = nullptr;
    ControlSwitch* _both = nullptr;
    std::optional<ControlledVehicle> _vehicle;
};

constexpr double kNorthward = std::numbers::pi / 2.0;

/// The key that brings a reading back to where it shall be: -1, 0 or 1.
double keyFor(double is, double wanted, double near)
{
    return std::abs(is - wanted) < near ? 0.0 : is > wanted ? 1.0 : -1.0;
}

// By somebody who looks at pitch and bank ten times a second and has keys, which know no half.
TEST(ManualPilot, TakeOffAndClimbByKeys)
{
    Cockpit cockpit(nullptr, {{0.0, 0.0, 0.0}, kNorthward, 0.0, false});
    cockpit.run(1.0);
    EXPECT_LT(cockpit.readings().calibratedAirspeedMps, 1.0);
    cockpit.hold("throttle", 1.0);
    cockpit.run(16.0);
    cockpit.hold("throttle", 0.0);
    double mostBankDeg = 0.0;
    for (int i = 0; i < 300; ++i)
    {
        cockpit.hold("elevator", keyFor(cockpit.readings().pitchDeg, 8.0, 2.0));
        cockpit.hold("aileron", -keyFor(cockpit.readings().rollDeg, 0.0, 2.0));
        cockpit.run(0.1);
        mostBankDeg = std::max(mostBankDeg, std::abs(cockpit.readings().rollDeg));
    }
    EXPECT_GT(cockpit.readings().heightAboveGroundM, 50.0);
    EXPECT_GT(cockpit.readings().calibratedAirspeedMps, 28.0);
    EXPECT_LT(mostBankDeg, 15.0);
    EXPECT_EQ(cockpit.condition(), VehicleCondition::sound);
}

TEST(FlightControlSwitch, AutopilotGoesOnWithItsOrdersFromWhereHandsLeftIt)
{
    Cockpit cockpit("heading 0; altitude 600; speed 50; wait 600",
                    {{0.0, 0.0, 600.0}, kNorthward, 50.0, true});
    cockpit.run(20.0);
    cockpit.both().giveToPerson(true);
    cockpit.hold("aileron", 1.0);
    cockpit.run(1.5);
    cockpit.hold("aileron", 0.0);
    cockpit.run(3.0);
    EXPECT_GT(cockpit.readings().rollDeg, 10.0);
    cockpit.both().giveToPerson(false);
    cockpit.run(60.0);
    EXPECT_NEAR(cockpit.readings().rollDeg, 0.0, 2.0);
    EXPECT_NEAR(std::remainder(cockpit.readings().headingDeg, 360.0), 0.0, 3.0);
    EXPECT_NEAR(cockpit.readings().calibratedAirspeedMps, 50.0, 2.0);
}

TEST(FlightControlSwitch, AutopilotWithoutTargetsHoldsWhatItGets)
{
    Cockpit cockpit("wait 600", {{0.0, 0.0, 600.0}, kNorthward, 50.0, true});
    cockpit.run(5.0);
    cockpit.both().giveToPerson(true);
    cockpit.hold("aileron", 1.0);
    cockpit.run(3.0);
    cockpit.hold("aileron", 0.0);
    cockpit.run(12.0);
    const double headingDeg = cockpit.readings().headingDeg;
    EXPECT_GT(std::abs(std::remainder(headingDeg, 360.0)), 20.0);
    cockpit.both().giveToPerson(false);
    cockpit.run(60.0);
    EXPECT_NEAR(std::remainder(cockpit.readings().headingDeg - headingDeg, 360.0), 0.0, 6.0);
    EXPECT_NEAR(cockpit.readings().rollDeg, 0.0, 3.0);
}

} // namespace
