// SPDX-License-Identifier: Apache-2.0
// A car and a van by hand, and a driver who gets his vehicle back.
#include "simulation/control/driver/ManualDriver.h"

#include <cmath>

#include "DriverSupport.h"
#include "simulation/control/ControlSwitch.h"

namespace
{

using namespace simulation;
using testsupport::Ride;

std::size_t axisOf(const ManualController& manual, std::string_view input)
{
    const int axis = manual.axisOf(input);
    EXPECT_GE(axis, 0) << input;
    return static_cast<std::size_t>(axis);
}

DriverPath wayOf(double lengthM)
{
    std::vector<DriverPoint> points;
    for (int x = 0; x < static_cast<int>(lengthM); ++x)
        points.push_back({{x, 0.0, 0.0}, 20.0});
    return DriverPath(points, {});
}

/// Steps a vehicle of its own by a controller.
class RoadSeat
{
public:
    explicit RoadSeat(const std::string& name)
        : _ride(name, wayOf(2000.0), std::make_shared<const LevelGround>())
    {
    }

    void run(VehicleController& controller, double seconds)
    {
        RoadVehicle& vehicle = _ride.vehicle();
        for (int i = 0; i < std::lround(seconds / RoadVehicle::kStepS); ++i)
        {
            const VehicleState state = vehicle.state();
            controller.control({state, vehicle.status(), *_ground, _air, {}, _steps++, state.timeS},
                               vehicle.inputs());
            vehicle.step(*_ground, _air);
        }
    }

    void standOn(const Ground& ground)
    {
        _ground = &ground;
        vehicle().place({}, ground);
    }

    RoadVehicle& vehicle() { return _ride.vehicle(); }
    Driver& driver() { return _ride.driver(); }

private:
    Ride _ride;
    LevelGround _level;
    const Ground* _ground = &_level;
    WeatherAir _air;
    std::int64_t _steps = 0;
};

class ManualOf : public testing::TestWithParam<const char*>
{
};

TEST_P(ManualOf, DriveOffSteerAndStopByKeys)
{
    RoadSeat seat(GetParam());
    ControlSwitch both(nullptr, manualDriver(seat.vehicle()), true);
    ManualController& manual = both.manual();
    manual.hold(axisOf(manual, "throttle"), 1.0);
    seat.run(both, 12.0);
    EXPECT_GT(seat.vehicle().readings().speedMps, 12.0);
    EXPECT_GT(seat.vehicle().readings().gear, 1); // a manual gearbox was shifted
    manual.hold(axisOf(manual, "throttle"), 0.0);
    manual.hold(axisOf(manual, "steering"), 1.0);
    double mostMps2 = 0.0;
    for (int i = 0; i < 20; ++i)
    {
        seat.run(both, 0.1);
        mostMps2 = std::max(
            mostMps2, std::abs(seat.vehicle().readings().yawRateRadps * seat.vehicle().readings().speedMps));
    }
    EXPECT_NEAR(mostMps2, 4.0, 1.2) << "held keys lead to a bend that the tyres hold";
    manual.hold(axisOf(manual, "steering"), 0.0);
    manual.hold(axisOf(manual, "brake"), 1.0);
    seat.run(both, 6.0);
    EXPECT_NEAR(seat.vehicle().readings().speedMps, 0.0, 0.1);
    EXPECT_EQ(seat.vehicle().status().condition, VehicleCondition::sound);
}

TEST_P(ManualOf, DriveBackwardsInReverse)
{
    RoadSeat seat(GetParam());
    ControlSwitch both(nullptr, manualDriver(seat.vehicle()), true);
    ManualController& manual = both.manual();
    seat.run(both, 0.5);
    manual.add(axisOf(manual, "gear"), -2.0);
    seat.run(both, 0.5);
    EXPECT_EQ(both.phase(), "parked") << "the lever alone releases nothing";
    manual.hold(axisOf(manual, "throttle"), 0.5);
    seat.run(both, 6.0);
    EXPECT_LT(seat.vehicle().readings().speedMps, -1.0);
}

/// A slope of 8 % along x, upwards.
class Slope final : public Ground
{
public:
    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {kShare * points[i].x, glm::normalize(glm::dvec3(-kShare, 0.0, 1.0)),
                          GroundKind::asphalt, true};
    }

    static constexpr double kShare = 0.08;
};

TEST_P(ManualOf, StandParkedUntilThrottleIsGiven)
{
    for (const bool isOnSlope : {false, true})
    {
        RoadSeat seat(GetParam());
        const Slope slope;
        if (isOnSlope) seat.standOn(slope);
        ControlSwitch both(nullptr, manualDriver(seat.vehicle()), true);
        ManualController& manual = both.manual();
        seat.run(both, 1.0); // it settles on its springs
        const glm::dvec3 begun = seat.vehicle().state().position;
        seat.run(both, 60.0);
        EXPECT_LT(glm::distance(seat.vehicle().state().position, begun), 0.05) << isOnSlope;
        EXPECT_EQ(seat.vehicle().readings().gear, 0);
        EXPECT_GT(seat.vehicle().readings().engineRpm, 500.0) << "the engine runs";
        EXPECT_EQ(inputOf(seat.vehicle().roadInputs(), RoadInput::handbrake), 1.0);
        EXPECT_EQ(both.phase(), "parked");
        manual.hold(axisOf(manual, "throttle"), 0.6);
        seat.run(both, 8.0);
        EXPECT_EQ(inputOf(seat.vehicle().roadInputs(), RoadInput::handbrake), 0.0);
        EXPECT_GT(seat.vehicle().readings().speedMps, 3.0) << isOnSlope;
        EXPECT_EQ(both.phase(), "hand");
    }
}

/// What would be without parking: the same slope, gear and brake as the axes have them.
TEST_P(ManualOf, RollDownASlopeWhereNothingHoldsThem)
{
    RoadSeat seat(GetParam());
    const Slope slope;
    seat.standOn(slope);
    ControlSwitch both(nullptr, manualDriver(seat.vehicle()), true);
    seat.run(both, 0.1);
    both.manual().hold(axisOf(both.manual(), "throttle"), 0.3);
    seat.run(both, 0.2);
    both.manual().hold(axisOf(both.manual(), "throttle"), 0.0);
    both.manual().add(axisOf(both.manual(), "gear"), -1.0);
    seat.run(both, 8.0);
    EXPECT_EQ(seat.vehicle().readings().gear, 0);
    EXPECT_LT(seat.vehicle().state().position.x, -1.0);
}

TEST(ManualDriver, IsNotParkedInACarThatBeginsAtSpeed)
{
    RoadSeat seat("car");
    seat.vehicle().place({{0.0, 0.0, 0.0}, 0.0, 15.0}, LevelGround());
    ControlSwitch both(nullptr, manualDriver(seat.vehicle()), true);
    seat.run(both, 1.0);
    EXPECT_EQ(both.phase(), "hand");
    EXPECT_GT(seat.vehicle().readings().speedMps, 13.0);
}

TEST(ManualDriver, IsNotParkedAgainAfterADriverHadTheCar)
{
    RoadSeat seat("car");
    ControlSwitch both(std::make_unique<Driver>(seat.vehicle(), wayOf(2000.0)), manualDriver(seat.vehicle()),
                       true);
    seat.run(both, 1.0);
    EXPECT_EQ(both.phase(), "parked");
    both.giveToPerson(false);
    seat.run(both, 6.0);
    EXPECT_GT(seat.vehicle().readings().speedMps, 5.0) << "a driver releases the brake himself";
    both.giveToPerson(true);
    seat.run(both, 0.1);
    EXPECT_EQ(both.phase(), "hand");
    EXPECT_EQ(inputOf(seat.vehicle().roadInputs(), RoadInput::handbrake), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, ManualOf, testing::Values("car", "van"));

TEST(DriverControlSwitch, GoesOnAlongTheWayFromWhereHandsLeftIt)
{
    RoadSeat seat("car");
    auto driver = std::make_unique<Driver>(seat.vehicle(), wayOf(2000.0));
    const Driver& automatic = *driver;
    ControlSwitch both(std::move(driver), manualDriver(seat.vehicle()), false);
    seat.run(both, 10.0);
    both.giveToPerson(true);
    ManualController& manual = both.manual();
    manual.hold(axisOf(manual, "steering"), 1.0);
    seat.run(both, 0.6);
    manual.hold(axisOf(manual, "steering"), -1.0);
    seat.run(both, 0.6);
    manual.hold(axisOf(manual, "steering"), 0.0);
    seat.run(both, 0.5);
    const double asideM = seat.vehicle().state().position.y;
    EXPECT_GT(asideM, 1.0);
    both.giveToPerson(false);
    seat.run(both, 8.0);
    EXPECT_NEAR(seat.vehicle().state().position.y, 0.0, 0.3);
    EXPECT_GT(seat.vehicle().readings().speedMps, 10.0);
    EXPECT_GT(automatic.beside().alongM, 100.0);
}

} // namespace
