// SPDX-License-Identifier: Apache-2.0
// Wheels and gear of vehicles with physics, as they are drawn, touch the surface that is drawn: within 1 cm
// up to 20 m from the eye, within a pixel beyond, in every frame of a drive and of a landing; standing, no
// wheel jitters by more than 1 mm.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <osgRoads/core/query/ChooseDrive.h>
#include <osgRoads/core/query/LaneGraph.h>
#include <osgTerrainROAM/core/edit/GroundEditor.h>

#include "ContactDrive.h"
#include "DriverSupport.h"
#include "RealData.h"
#include "scenery/models/entities/DefaultSize.h"
#include "scenery/models/entities/EntityModel.h"
#include "scenery/roads/LanePath.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/vehicle/ProvidedGround.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"

namespace
{

namespace models = scenery::models;
using namespace osgTerrainROAM::core;

/// The car as it is drawn: its wheels where the vehicle file has them.
models::EntityModel drawnCar(const simulation::RoadVehicleData& data)
{
    models::EntityShape shape;
    shape.kind = models::EntityKind::car;
    models::setDefaultSize(shape);
    shape.axles.clear();
    for (const auto& axle : data.axles)
        shape.axles.push_back({axle.xM, axle.trackM, axle.tyre.radiusM, shape.axles.empty()});
    shape.widthM = std::max(shape.widthM, data.axles[0].trackM / 0.92);
    return models::makeEntityModel(shape);
}

/// The lowest points of the wheels as they are drawn. Frame: the scene's.
std::vector<glm::dvec3> lowestOfWheels(const models::EntityModel& car, const simulation::EntityState& state)
{
    models::EntityMotion motion;
    motion.wheelTravelM = state.wheelTravelM;
    motion.steeringRad = glm::radians(state.steeringDeg);
    const auto pose = car.pose(motion), built = car.pose({});
    std::vector<glm::dvec3> lowest;
    for (std::size_t i = 1; i < pose.size(); ++i)
    {
        const glm::dvec3 hub(pose[i][3]);
        const double radiusM = built[i][3].z; // built to stand on z = 0
        lowest.push_back(state.position + state.bodyToLocal() * (hub - glm::dvec3(0.0, 0.0, radiusM)));
    }
    return lowest;
}

simulation::DriverPath pathOver(const RoadScene& scene, double lengthM)
{
    const auto& network = scene.roads->network();
    const auto route = osgRoads::core::chooseDrive(network, osgRoads::core::LaneGraph(network), lengthM);
    std::vector<simulation::DriverPoint> points;
    for (const scenery::LanePathPoint& point : scenery::lanePath(*scene.roads, route))
        points.push_back({point.place, point.limitMps});
    return simulation::DriverPath(points, {});
}

simulation::EntityState stateOf(const simulation::DynamicVehicle& vehicle)
{
    simulation::EntityState state = simulation::entityStateOf(vehicle.state(), vehicle.referencePoint());
    vehicle.writeParts(state);
    return state;
}

struct DriveReport
{
    ContactReport contacts;
    std::size_t wheelsInAir = 0;
};

/// Drives, and compares each frame from behind.
DriveReport driveReport(const RoadScene& scene, double durationS, const ContactRequest& request)
{
    constexpr int kStepsAFrame = 5; // 24 frames a second
    DriveReport report;
    const auto ground = std::make_shared<simulation::ProvidedGround>(scene.stage().ground);
    testsupport::Ride ride("car", pathOver(scene, 400.0), ground);
    const models::EntityModel car = drawnCar(ride.vehicle().data());
    DrawnWatcher behind(scene, request);
    for (int step = 0; ride.timeS() < durationS; ++step)
    {
        ride.step();
        if (step % (kStepsAFrame * request.everyFrames) != 0) continue;
        const simulation::EntityState state = stateOf(ride.vehicle());
        const glm::dmat3 body = state.bodyToLocal();
        behind.look(state.position - 9.0 * body[0] + glm::dvec3(0.0, 0.0, 2.8), state.position);
        ++report.contacts.frames;
        const auto wheels = lowestOfWheels(car, state);
        for (std::size_t i = 0; i < wheels.size(); ++i)
            if (ride.vehicle().wheels()[i].isTouching())
                behind.check(wheels[i], report.contacts);
            else
                ++report.wheelsInAir;
    }
    return report;
}

/// Gentle waves of land, 30 m a sample.
HeightField waves()
{
    HeightField field;
    field.name = "waves";
    field.columns = field.rows = 129;
    field.spacingEastM = field.spacingNorthM = 30.0;
    for (int row = 0; row < field.rows; ++row)
        for (int column = 0; column < field.columns; ++column)
            field.heightsM.push_back(
                static_cast<float>(40.0 + 2.0 * std::sin(0.9 * column) * std::cos(0.7 * row)));
    return field;
}

/// Waves with a level strip of 900 m by 60 m laid into them, along x.
RoadScene sceneWithStrip()
{
    RoadScene scene;
    scene.tile = std::make_shared<RoamTile>(
        PlacedTile(waves(), PlacedTileOptions{.placement = Placement::planar, .gridExponent = 4}));
    scene.roads =
        std::make_shared<osgRoads::core::PlacedNetwork>(std::make_shared<osgRoads::core::RoadNetwork>());
    GroundEditor editor(scene.tile);
    Ribbon strip;
    strip.points = {{1000.0, 2000.0}, {1900.0, 2000.0}};
    strip.widthM = 60.0;
    strip.heightsM = {40.0, 40.0};
    const auto laid = editor.conform(strip);
    EXPECT_TRUE(laid) << (laid ? "" : laid.error().message());
    return scene;
}

/// An aircraft that lands on the strip by its autopilot.
class Landing
{
public:
    explicit Landing(const RoadScene& scene) : _ground(scene.stage().ground)
    {
        const auto earth =
            std::make_shared<const simulation::EarthFrame>(simulation::Geodetic{46.0, 8.0, 0.0});
        const auto data = simulation::readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
        EXPECT_TRUE(data) << (data ? "" : data.error().message());
        auto aircraft = std::make_unique<simulation::Aircraft>(
            std::make_shared<const simulation::AircraftData>(*data), earth, 1);
        const auto begun = aircraft->begin({{400.0, 2000.0, 78.0}, 0.0, 33.0, true}, _ground, _air);
        EXPECT_TRUE(begun) << (begun ? "" : begun.error().message());
        const simulation::RunwayStrip runway{{1015.0, 2000.0, 40.0}, std::numbers::pi / 2.0, 870.0, 30.0};
        auto pilot =
            simulation::Autopilot::create({earth, {{simulation::FlightOrderKind::land}}, runway}, *aircraft);
        EXPECT_TRUE(pilot) << (pilot ? "" : pilot.error().message());
        _vehicle.emplace(std::move(aircraft), std::make_unique<simulation::Autopilot>(std::move(*pilot)));
        _vehicle->look();
    }

    void step() { _vehicle->step(_ground, _air, {}); }
    bool isDone() const { return _vehicle->controller()->isDone(); }
    const simulation::DynamicVehicle& aircraft() const { return _vehicle->vehicle(); }

private:
    simulation::ProvidedGround _ground;
    simulation::WeatherAir _air;
    std::optional<simulation::ControlledVehicle> _vehicle;
};

/// The lowest points of the wheels that are pressed in, as they are drawn.
std::vector<glm::dvec3> pressedGear(const models::EntityModel& aircraft, const simulation::EntityState& state)
{
    std::array<models::AircraftMotion::Leg, 3> legs;
    for (std::size_t leg = 0; leg < 3; ++leg)
        legs[leg] = {state.aircraft->wheelBottom[leg], state.aircraft->strutM[leg], 0.0};
    models::EntityMotion motion;
    motion.aircraft.legs = legs;
    const auto pose = aircraft.pose(motion);
    const std::array<glm::dvec3, 3> built{glm::dvec3(1.70, 0.0, 0.0), glm::dvec3(0.0, 1.26, 0.0),
                                          glm::dvec3(0.0, -1.26, 0.0)};
    std::vector<glm::dvec3> places;
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
        if (state.aircraft->strutM[leg] <= 0.0) continue;
        const auto named =
            std::find(aircraft.names.begin(), aircraft.names.end(), "leg " + std::to_string(leg));
        const auto part = static_cast<std::size_t>(named - aircraft.names.begin());
        places.push_back(state.position +
                         state.bodyToLocal() * glm::dvec3(pose[part] * glm::dvec4(built[leg], 1.0)));
    }
    return places;
}

} // namespace

TEST(VehicleContact, WheelsOfADriveTouchWhatIsDrawnInEveryFrame)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/fabriksgatan.xodr");
    const RoadScene scene = sceneOf(file);
    const DriveReport report = driveReport(scene, 12.0, {});
    std::cout << report.contacts.text() << '\n';
    EXPECT_GE(report.contacts.frames, 288U);
    EXPECT_EQ(report.wheelsInAir, 0U);
    EXPECT_GT(report.contacts.points, 3 * report.contacts.frames);
    EXPECT_EQ(report.contacts.undrawn, 0U);
    EXPECT_EQ(report.contacts.broken, 0U);
    // The mutation: wheels that hover by 2 cm.
    const DriveReport raised = driveReport(scene, 3.0, {.everyFrames = 12, .raisedM = 0.02});
    EXPECT_GT(raised.contacts.broken, raised.contacts.points / 2);
}

TEST(VehicleContact, WheelsThatStandDoNotJitter)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/curves_elevation.xodr");
    const RoadScene scene = sceneOf(file);
    const auto ground = std::make_shared<simulation::ProvidedGround>(scene.stage().ground);
    testsupport::Ride ride("car", pathOver(scene, 400.0), ground);
    const models::EntityModel car = drawnCar(ride.vehicle().data());
    auto& inputs = ride.vehicle().roadInputs();
    inputs = {};
    inputs[static_cast<std::size_t>(simulation::RoadInput::handbrake)] = 1.0;
    const simulation::WeatherAir air;
    for (int i = 0; i < 600; ++i) // it settles on its springs
        ride.vehicle().step(*ground, air);
    const auto before = lowestOfWheels(car, stateOf(ride.vehicle()));
    double mostM = 0.0;
    for (int i = 0; i < 1200; ++i)
    {
        ride.vehicle().step(*ground, air);
        const auto now = lowestOfWheels(car, stateOf(ride.vehicle()));
        for (std::size_t wheel = 0; wheel < now.size(); ++wheel)
            mostM = std::max(mostM, glm::distance(now[wheel], before[wheel]));
    }
    std::cout << 1000.0 * mostM << " mm in 10 s\n";
    EXPECT_LT(mostM, 0.001);
    inputs[static_cast<std::size_t>(simulation::RoadInput::steering)] =
        0.2; // the mutation: it does something
    inputs[static_cast<std::size_t>(simulation::RoadInput::handbrake)] = 0.0;
    inputs[static_cast<std::size_t>(simulation::RoadInput::throttle)] = 0.3;
    inputs[static_cast<std::size_t>(simulation::RoadInput::gear)] = 1.0;
    for (int i = 0; i < 60; ++i)
        ride.vehicle().step(*ground, air);
    EXPECT_GT(glm::distance(lowestOfWheels(car, stateOf(ride.vehicle()))[0], before[0]), 0.001);
}

TEST(VehicleContact, GearOfALandingTouchesWhatIsDrawnInEveryFrame)
{
    constexpr int kStepsAFrame = 5;
    const RoadScene scene = sceneWithStrip();
    models::EntityShape shape;
    shape.kind = models::EntityKind::lightAircraft;
    models::setDefaultSize(shape);
    const models::EntityModel model = models::makeEntityModel(shape);
    const ContactRequest kept{}, hovering{.raisedM = 0.02};
    DrawnWatcher behind(scene, kept), raised(scene, hovering);
    ContactReport report, mutated;
    Landing landing(scene);
    std::vector<glm::dvec3> standing;
    double jitterM = 0.0;
    for (int step = 0; landing.aircraft().state().timeS < 120.0 && !landing.isDone(); ++step)
    {
        landing.step();
        if (step % kStepsAFrame != 0) continue;
        const simulation::EntityState state = stateOf(landing.aircraft());
        const auto wheels = pressedGear(model, state);
        ++report.frames;
        if (wheels.empty()) continue;
        const glm::dvec3 ahead = state.bodyToLocal()[0];
        behind.look(state.position - 18.0 * ahead + glm::dvec3(0.0, 0.0, 5.0), state.position);
        for (const glm::dvec3& wheel : wheels)
            behind.check(wheel, report);
        if (step % (24 * kStepsAFrame) != 0) continue;
        raised.look(state.position - 14.0 * ahead + glm::dvec3(0.0, 0.0, 4.0), state.position);
        for (const glm::dvec3& wheel : wheels)
            raised.check(wheel, mutated);
    }
    EXPECT_TRUE(landing.isDone()) << "it has not landed";
    for (int step = 0; step < 600; ++step) // stands
    {
        landing.step();
        const auto wheels = pressedGear(model, stateOf(landing.aircraft()));
        if (step < 240) continue;
        if (step == 240) standing = wheels;
        ASSERT_EQ(wheels.size(), standing.size());
        for (std::size_t i = 0; i < wheels.size(); ++i)
            jitterM = std::max(jitterM, glm::distance(wheels[i], standing[i]));
    }
    std::cout << report.text() << "; standing " << 1000.0 * jitterM << " mm\n";
    EXPECT_GT(report.points, 200U);
    EXPECT_EQ(report.undrawn, 0U);
    EXPECT_EQ(report.broken, 0U);
    EXPECT_GT(mutated.broken, mutated.points / 2) << "the mutation: gear that hovers by 2 cm";
    EXPECT_EQ(standing.size(), 3U);
    EXPECT_LT(jitterM, 0.001);
}
