// SPDX-License-Identifier: Apache-2.0
// The autopilot and hills: it climbs over them, turns away from those that it cannot climb over, and lays its
// circuit where the ground is low. Each flight has its control without the guard, which ends in the hill.
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/control/ControlledVehicle.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"

namespace
{

using namespace simulation;

/// Round hills on a plain at height 0.
class Hills final : public Ground
{
public:
    struct Hill
    {
        glm::dvec2 place{0.0};
        double heightM = 0.0, widthM = 0.0; ///< of a bell
    };

    explicit Hills(std::vector<Hill> hills) : _hills(std::move(hills)) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            double height = 0.0;
            glm::dvec2 slope(0.0);
            for (const Hill& hill : _hills)
            {
                const glm::dvec2 apart = (glm::dvec2(points[i]) - hill.place) / hill.widthM;
                const double bell = hill.heightM * std::exp(-glm::dot(apart, apart));
                height += bell;
                slope -= 2.0 * bell / hill.widthM * apart;
            }
            answers[i] = {height, glm::normalize(glm::dvec3(-slope, 1.0)), GroundKind::grass, true};
        }
    }

private:
    std::vector<Hill> _hills;
};

struct HillFlight
{
    VehicleCondition condition = VehicleCondition::sound;
    double leastClearanceM = 1e9; ///< in the air, away from the runway
    glm::dvec3 place{0.0};
    bool isDone = false;
    double mostEastM = -1e9, mostWestM = 1e9;
    std::string note;
};

HillFlight flyOver(const Hills& hills, const std::string& orders, const VehicleStart& start, double mostS,
                   bool avoidsGround)
{
    static const auto data = []
    {
        const auto read = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
        EXPECT_TRUE(read);
        return std::make_shared<const AircraftData>(*read);
    }();
    const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
    const WeatherAir air;
    auto aircraft = std::make_unique<Aircraft>(data, earth);
    EXPECT_TRUE(aircraft->begin(start, hills, air));
    auto read = parseFlightOrders(orders, "orders");
    EXPECT_TRUE(read);
    auto pilot = Autopilot::create(
        {earth, *read, RunwayStrip{{0.0, 0.0, 0.0}, 0.0, 800.0, 30.0}, avoidsGround}, *aircraft);
    EXPECT_TRUE(pilot);
    ControlledVehicle vehicle(std::move(aircraft), std::make_unique<Autopilot>(std::move(*pilot)));
    vehicle.look();
    HillFlight flight;
    while (vehicle.now().timeS < mostS && vehicle.vehicle().status().condition == VehicleCondition::sound &&
           (!vehicle.controller()->isDone() || start.isInAir))
    {
        vehicle.step(hills, air, {});
        const glm::dvec3 place = vehicle.now().position;
        GroundPoint below;
        hills.below({&place, 1}, {&below, 1});
        if (below.heightM > 20.0)
            flight.leastClearanceM = std::min(flight.leastClearanceM, place.z - below.heightM);
        flight.mostEastM = std::max(flight.mostEastM, place.x);
        flight.mostWestM = std::min(flight.mostWestM, place.x);
    }
    flight.condition = vehicle.vehicle().status().condition;
    flight.place = vehicle.now().position;
    flight.isDone = vehicle.controller()->isDone();
    flight.note = vehicle.controller()->note();
    return flight;
}

/// 300 m above the plain, to the east.
VehicleStart eastwards()
{
    return {{0.0, 0.0, 300.0}, 0.0, 50.0, true};
}

TEST(TerrainGuard, ClimbsOverAHillThatItCanClimbOver)
{
    const Hills hills({{{9000.0, 0.0}, 420.0, 2500.0}});
    const HillFlight flight = flyOver(hills, "wait 400", eastwards(), 300.0, true);
    EXPECT_EQ(flight.condition, VehicleCondition::sound);
    EXPECT_GT(flight.leastClearanceM, 30.0);
    EXPECT_GT(flight.place.x, 12'000.0);
    EXPECT_NEAR(flight.place.y, 0.0, 500.0); // straight over it
    EXPECT_NE(flight.note.find("left its orders after"), std::string::npos) << flight.note;
    EXPECT_EQ(flyOver(hills, "wait 400", eastwards(), 300.0, false).condition, VehicleCondition::crashed);
}

TEST(TerrainGuard, TurnsAwayFromAMountain)
{
    const Hills hills({{{6000.0, 200.0}, 1500.0, 1200.0}});
    const HillFlight flight = flyOver(hills, "wait 400", eastwards(), 300.0, true);
    EXPECT_EQ(flight.condition, VehicleCondition::sound);
    EXPECT_GT(flight.leastClearanceM, 30.0);
    EXPECT_EQ(flyOver(hills, "wait 400", eastwards(), 300.0, false).condition, VehicleCondition::crashed);
}

TEST(TerrainGuard, LeavesOrdersAloneWhereTheGroundDoesNotRise)
{
    const Hills plain({});
    const HillFlight with = flyOver(plain, "altitude 90; heading 45", eastwards(), 120.0, true);
    const HillFlight without = flyOver(plain, "altitude 90; heading 45", eastwards(), 120.0, false);
    EXPECT_EQ(with.place, without.place);
    EXPECT_TRUE(with.note.empty()) << with.note;
}

TEST(TerrainGuard, ACircuitIsFlownOnTheSideWithTheLowerGround)
{
    // The downwind leg lies 1000 m to the left, west; there is a hill of 420 m.
    const Hills hills({{{-1100.0, 600.0}, 420.0, 500.0}});
    const VehicleStart start{{0.0, 20.0, 0.0}, std::numbers::pi / 2.0, 0.0, false};
    const HillFlight flight = flyOver(hills, "takeoff; circuit; land", start, 500.0, true);
    EXPECT_EQ(flight.condition, VehicleCondition::sound);
    EXPECT_TRUE(flight.isDone);
    EXPECT_GT(flight.mostEastM, 800.0);
    EXPECT_GT(flight.mostWestM, -200.0);
    EXPECT_NE(flight.note.find("right-handed circuit"), std::string::npos) << flight.note;
    EXPECT_EQ(flyOver(hills, "takeoff; circuit; land", start, 500.0, false).condition,
              VehicleCondition::crashed);
}

TEST(TerrainGuard, RefusesToTakeOffIntoAHill)
{
    const Hills hills({{{0.0, 2200.0}, 250.0, 500.0}});
    const VehicleStart start{{0.0, 20.0, 0.0}, std::numbers::pi / 2.0, 0.0, false};
    const HillFlight flight = flyOver(hills, "takeoff; wait 60", start, 100.0, true);
    EXPECT_EQ(flight.condition, VehicleCondition::sound);
    EXPECT_NEAR(flight.place.y, 20.0, 1.0);
    EXPECT_NE(flight.note.find("refused to take off: the ground beyond the runway is"), std::string::npos)
        << flight.note;
    EXPECT_EQ(flyOver(hills, "takeoff; wait 60", start, 100.0, false).condition, VehicleCondition::crashed);
}

TEST(TerrainGuard, RefusesToLandThroughAHill)
{
    const Hills hills({{{0.0, -1000.0}, 150.0, 250.0}});
    const VehicleStart start{{0.0, -2800.0, 180.0}, std::numbers::pi / 2.0, 33.0, true};
    const HillFlight flight = flyOver(hills, "land", start, 150.0, true);
    EXPECT_EQ(flight.condition, VehicleCondition::sound);
    EXPECT_FALSE(flight.isDone);
    EXPECT_GT(flight.leastClearanceM, 10.0);
    EXPECT_NE(flight.note.find("refused to land: the ground before the runway is"), std::string::npos)
        << flight.note;
    EXPECT_EQ(flyOver(hills, "land", start, 150.0, false).condition, VehicleCondition::crashed);
}

} // namespace
