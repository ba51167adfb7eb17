// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <map>

#include "DriverSupport.h"

namespace
{

using namespace simulation;
using testsupport::Ride;

std::shared_ptr<const Ground> levelRoad()
{
    return std::make_shared<const LevelGround>();
}

/// A straight of 500 m, a half circle of 60 m, and a straight back.
DriverPath hairpin(double limitMps, std::vector<DriverStop> stops = {})
{
    std::vector<DriverPoint> points;
    for (int x = 0; x < 500; ++x)
        points.push_back({{x, 0.0, 0.0}, limitMps});
    for (int i = 0; i < 188; ++i)
        points.push_back(
            {{500.0 + 60.0 * std::sin(i / 60.0), 60.0 - 60.0 * std::cos(i / 60.0), 0.0}, limitMps});
    for (int x = 0; x < 300; ++x)
        points.push_back({{499.0 - x, 120.0, 0.0}, limitMps});
    return DriverPath(points, std::move(stops));
}

TEST(DriverPathTest, TellsPlacesBesideItAndItsBends)
{
    const DriverPath path = hairpin(10.0);
    EXPECT_NEAR(path.lengthM(), 500.0 + 188.0 + 300.0, 2.0);
    const DriverPath::Beside beside = path.nearest({123.25, 1.5, 0.0}, 120.0, 10.0);
    EXPECT_NEAR(beside.alongM, 123.25, 1e-9);
    EXPECT_NEAR(beside.offsetM, 1.5, 1e-9);
    EXPECT_NEAR(path.placeAt(10.0, -2.0).y, -2.0, 1e-12);
    EXPECT_NEAR(path.curvatureAt(600.0), 1.0 / 60.0, 1e-3);
    EXPECT_NEAR(path.curvatureAt(100.0), 0.0, 1e-9);
    EXPECT_NEAR(path.placeAt(-5.0).x, -5.0, 1e-9);
}

class DriverOf : public testing::TestWithParam<const char*>
{
};

// At 15 m/s along straight and hairpin, slower in the bend, to a stop at the end.
TEST_P(DriverOf, KeepsToItsWayAndStopsAtItsEnd)
{
    DriverSettings settings;
    if (std::string(GetParam()) == "bus") settings.lateralMps2 = 1.2; // people stand in it
    Ride ride(GetParam(), hairpin(15.0), levelRoad(), 0.0, settings);
    double worst = 0.0, fastest = 0.0, fastestInBend = 0.0;
    while (!ride.driver().isDone() && ride.timeS() < 200.0)
    {
        ride.step();
        worst = std::max(worst, std::abs(ride.driver().beside().offsetM));
        fastest = std::max(fastest, ride.speedMps());
        const double along = ride.driver().beside().alongM;
        if (along > 510.0 && along < 670.0) fastestInBend = std::max(fastestInBend, ride.speedMps());
    }
    EXPECT_TRUE(ride.driver().isDone()) << ride.driver().beside().alongM;
    EXPECT_LT(worst, 0.5);
    EXPECT_NEAR(fastest, 15.0, 0.7);
    EXPECT_LT(fastestInBend, std::sqrt(settings.lateralMps2 * 60.0) + 0.5);
    EXPECT_LT(ride.speedMps(), 0.2);
    EXPECT_EQ(ride.vehicle().status().condition, VehicleCondition::sound);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, DriverOf, testing::Values("car", "van", "bus"));

double frontOf(Ride& ride)
{
    return ride.driver().beside().alongM + 1.35 + 2.3; // of the car's hull
}

TEST(DriverTest, StopsAtASignAndGoesOn)
{
    Ride ride("car", hairpin(15.0, {{200.0, ""}}), levelRoad());
    double stoodAt = -1.0;
    while (ride.timeS() < 60.0 && ride.driver().beside().alongM < 250.0)
    {
        ride.step();
        if (stoodAt < 0.0 && ride.timeS() > 5.0 && ride.speedMps() < 0.05) stoodAt = frontOf(ride);
    }
    EXPECT_GT(stoodAt, 197.5);
    EXPECT_LT(stoodAt, 200.3);
    EXPECT_GE(ride.driver().beside().alongM, 250.0);
}

TEST(DriverTest, WaitsForGreen)
{
    Ride ride("car", hairpin(15.0, {{200.0, "7"}}), levelRoad());
    std::map<std::string, std::string> states{{"7", "red"}};
    Traffic traffic;
    traffic.signalStates = &states;
    double farthest = 0.0;
    while (ride.timeS() < 40.0)
    {
        ride.step(traffic);
        farthest = std::max(farthest, frontOf(ride));
    }
    EXPECT_LT(farthest, 200.3);
    EXPECT_GT(farthest, 197.5);
    states["7"] = "off;off;on";
    while (ride.timeS() < 55.0)
        ride.step(traffic);
    EXPECT_GT(ride.driver().beside().alongM, 230.0);
}

/// Another vehicle on the straight: where it is after a time.
struct Other
{
    double startM, speedMps;
};

/// Rides with one vehicle ahead; returns the least distance between both hulls along the way.
double leastGap(Ride& ride, const Other& other, double seconds)
{
    std::vector<EntityState> entities(2);
    const std::vector<BoundingBox> boxes{{{1.4, 0.0, 0.75}, 4.6, 1.8, 1.5},
                                         {{1.4, 0.0, 0.75}, 4.6, 1.8, 1.5}};
    Traffic traffic{entities, boxes, 0, nullptr};
    double least = 1e9;
    while (ride.timeS() < seconds)
    {
        entities[1].position = {other.startM + other.speedMps * ride.timeS(), 0.0, 0.0};
        entities[1].velocity = {other.speedMps, 0.0, 0.0};
        ride.step(traffic);
        const glm::dvec3 own = ride.vehicle().state().position +
                               ride.vehicle().state().bodyToScene * ride.vehicle().referencePoint();
        const double along = entities[1].position.x - own.x, across = std::abs(own.y);
        if (across < 1.8) least = std::min(least, std::abs(along) - 4.6);
    }
    return least;
}

TEST(DriverTest, KeepsItsDistanceFromASlowerVehicle)
{
    Ride ride("car", hairpin(20.0), levelRoad(), 18.0);
    EXPECT_GT(leastGap(ride, {60.0, 8.0}, 40.0), 4.0);
    EXPECT_NEAR(ride.speedMps(), 8.0, 0.5);
    EXPECT_EQ(ride.driver().phase(), "follow");
}

TEST(DriverTest, OvertakesWhenTold)
{
    DriverSettings settings;
    settings.overtakes = true;
    Ride ride("car", hairpin(20.0), levelRoad(), 18.0, settings);
    EXPECT_GT(leastGap(ride, {60.0, 8.0}, 23.0), 1.0);
    EXPECT_GT(ride.driver().beside().alongM, 60.0 + 8.0 * 23.0 + 10.0);
    EXPECT_LT(std::abs(ride.driver().beside().offsetM), 0.5);
}

TEST(DriverTest, TwoDrivesAreEqual)
{
    const auto run = []
    {
        Ride ride("van", hairpin(15.0), levelRoad());
        while (ride.timeS() < 15.0)
            ride.step();
        return ride.vehicle().state();
    };
    const VehicleState first = run(), second = run();
    EXPECT_EQ(std::memcmp(&first.position, &second.position, sizeof first.position), 0);
}

} // namespace
