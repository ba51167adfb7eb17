// SPDX-License-Identifier: Apache-2.0
#include "FlyCommand.h"

#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>
#include <foundation/WholeFile.h>

#include "FlatScene.h"
#include "SceneGround.h"
#include "SceneStrip.h"
#include "SceneTerrain.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/control/flight/FlightHands.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/tour/TourScenario.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/jsbsim/JsbsimFile.h"
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"

namespace trainer
{

namespace
{

constexpr double kStartHeightM = 300.0, kStartSpeedMps = 50.0;
constexpr double kBehindThresholdM = 20.0; ///< where a take-off begins on its strip
constexpr const char* kEntity = "Ego";

/// Where a flight begins. Angles in degrees from north, clockwise.
struct FlightStart
{
    std::string name;
    glm::dvec2 place{0.0};
    double heightM = 0.0; ///< above the ground
    double headingDeg = 0.0, speedMps = 0.0;
};

/// A place beside a strip. `alongM`, `leftM`: from its threshold.
glm::dvec2 besideStrip(const StripRequest& strip, double alongM, double leftM)
{
    const double course = foundation::radiansOf(strip.courseDeg);
    const glm::dvec2 ahead(std::sin(course), std::cos(course));
    return strip.threshold + alongM * ahead + leftM * glm::dvec2(-ahead.y, ahead.x);
}

/// The first is that of the request.
std::vector<FlightStart> startsOf(const FlyRequest& request)
{
    const auto& strip = request.play.terrain.strip;
    std::vector<FlightStart> starts;
    if (!request.start.empty())
        starts.push_back({"the start",
                          {request.start[0], request.start[1]},
                          request.start[2],
                          request.start[3],
                          request.start[4]});
    else if (!strip)
        starts.push_back({"the start", {0.0, 0.0}, kStartHeightM, 0.0, kStartSpeedMps});
    const glm::dvec2 middle = starts.empty() ? glm::dvec2(0.0) : starts.front().place;
    if (!strip)
    {
        starts.push_back({"high above", middle, 1500.0, 0.0, kStartSpeedMps});
        return starts;
    }
    const double course = strip->courseDeg;
    starts.push_back({"on the runway", besideStrip(*strip, kBehindThresholdM, 0.0), 0.0, course, 0.0});
    starts.push_back({"on final", besideStrip(*strip, -2500.0, 0.0), 140.0, course, 33.0});
    starts.push_back({"downwind", besideStrip(*strip, 0.5 * strip->lengthM, 1200.0), 300.0,
                      std::fmod(course + 180.0, 360.0), 45.0});
    return starts;
}

simulation::WeatherAir airOf(const FlyRequest& request)
{
    simulation::WeatherSettings weather;
    weather.gustDeviationMps = request.gustsMps;
    if (!request.wind.empty())
    {
        const double from = foundation::radiansOf(request.wind[0]), mps = request.wind[1] * 1852.0 / 3600.0;
        weather.windMps = {-mps * std::sin(from), -mps * std::cos(from), 0.0};
        if (request.gustsMps > 0.0) weather.windAtSixMetresMps = mps;
    }
    return simulation::WeatherAir(weather);
}

/// What stands where the flight begins, for the scenario that the pictures show.
simulation::Scenario scenarioOf(const glm::dvec3& start, const FlightStart& from,
                                const std::optional<simulation::Geodetic>& origin)
{
    simulation::Scenario scenario;
    scenario.header = {1, 3, "2024-01-01T00:00:00", "osgTrainer", "A flight"};
    simulation::Vehicle vehicle;
    vehicle.name = "aircraft";
    vehicle.category = "aircraft";
    vehicle.box = {{-0.8, 0.0, 1.4}, 8.2, 11.0, 2.8};
    scenario.entities.push_back({{}, kEntity, vehicle});
    const double heading = foundation::radiansOf(90.0 - from.headingDeg);
    simulation::TourTerrain terrain;
    terrain.origin = origin;
    terrain.eastM = terrain.northM = 20'000.0;
    scenario.storyboard.init.globals.push_back(
        simulation::EnvironmentAction{{}, simulation::tourEnvironment(terrain, heading)});
    simulation::TeleportAction teleport;
    teleport.position = simulation::WorldPosition{
        {}, start.x, start.y, start.z, simulation::Orientation{heading, std::nullopt, std::nullopt}};
    simulation::SpeedAction speed;
    speed.target = simulation::AbsoluteTargetSpeed{from.speedMps};
    scenario.storyboard.init.privates.push_back({{}, kEntity, {teleport, speed}});
    return scenario;
}

std::vector<simulation::FlightOrder> standardOrders(const FlyRequest& request)
{
    using simulation::FlightOrderKind;
    if (!request.play.terrain.strip) return {{FlightOrderKind::wait, request.durationS}};
    if (request.start.empty())
        return {{FlightOrderKind::takeOff}, {FlightOrderKind::circuit}, {FlightOrderKind::land}};
    return {{FlightOrderKind::land}};
}

foundation::Result<std::unique_ptr<simulation::VehicleController>>
controllerOf(const FlyRequest& request, const simulation::DynamicVehicle& vehicle,
             const std::shared_ptr<const simulation::EarthFrame>& earth,
             const std::optional<simulation::RunwayStrip>& runway)
{
    if (!request.inputs.empty()) return simulation::openInputs(request.inputs, vehicle);
    std::vector<simulation::FlightOrder> orders = standardOrders(request);
    if (!request.orders.empty())
    {
        const auto read = simulation::parseFlightOrders(request.orders, "--orders");
        if (!read) return read.error();
        orders = *read;
    }
    auto pilot = simulation::Autopilot::create({earth, std::move(orders), runway}, vehicle);
    if (!pilot) return foundation::Error{"--orders", pilot.error().what, "give --strip, or other orders"};
    return std::unique_ptr<simulation::VehicleController>(
        std::make_unique<simulation::Autopilot>(std::move(*pilot)));
}

/// The strip as it lies in the scene.
std::optional<simulation::RunwayStrip> runwayOf(const FlyRequest& request, const simulation::Ground& ground)
{
    const auto& strip = request.play.terrain.strip;
    if (!strip) return std::nullopt;
    return simulation::runwayOn(ground, strip->threshold, strip->courseDeg, strip->lengthM, strip->widthM);
}

/// What JSBSim is to fly; nothing: the aircraft is one of our own.
foundation::Result<std::optional<simulation::JsbsimData>> jsbsimOf(const FlyRequest& request)
{
    std::error_code ignored;
    simulation::JsbsimData data;
    if (simulation::isJsbsimFile(request.aircraft))
    {
        auto read = simulation::readJsbsimAircraft(request.aircraft);
        if (!read) return read.error();
        data = std::move(*read);
    }
    else if (!request.jsbsimRoot.empty() && !std::filesystem::exists(request.aircraft, ignored))
        data.name = data.aircraft = request.aircraft.string();
    else if (!request.jsbsimRoot.empty())
        return foundation::Error{"--jsbsim-root", "the aircraft is a file that JSBSim does not fly",
                                 "write --aircraft NAME, a folder of aircraft/ there"};
    else
        return std::optional<simulation::JsbsimData>();
    if (!request.jsbsimRoot.empty()) data.root = request.jsbsimRoot;
    if (!request.jsbsim.empty()) data.program = request.jsbsim;
    if (data.root.empty())
        return foundation::Error{data.name, "it names no root of JSBSim", "write --jsbsim-root FOLDER"};
    return std::optional(std::move(data));
}

foundation::Result<std::unique_ptr<simulation::DynamicVehicle>>
aircraftOf(const FlyRequest& request, const std::optional<simulation::Geodetic>& origin)
{
    auto jsbsim = jsbsimOf(request);
    if (!jsbsim) return jsbsim.error();
    if (*jsbsim)
        return std::unique_ptr<simulation::DynamicVehicle>(std::make_unique<simulation::JsbsimVehicle>(
            std::make_shared<const simulation::JsbsimData>(std::move(**jsbsim)), simulation::earthOf(origin),
            request.seed));
    auto aircraft = simulation::openVehicle(request.aircraft, origin, request.seed);
    if (!aircraft) return aircraft.error();
    if (!dynamic_cast<const simulation::Aircraft*>(aircraft->get()))
        return foundation::Error{request.aircraft.string(), "is a road vehicle",
                                 "give the data file of an aircraft, or write trainer drive"};
    return aircraft;
}

/// Makes one flight after the other over one ground.
class FlightMaker final : public RideMaker
{
public:
    FlightMaker(const FlyRequest& request, std::shared_ptr<const simulation::Ground> ground,
                const std::optional<simulation::Geodetic>& origin)
        : _request(request),
          _ground(std::move(ground)),
          _origin(origin),
          _earth(simulation::earthOf(origin)),
          _starts(startsOf(request))
    {
    }

    KeyScope kind() const override { return KeyScope::flight; }
    std::vector<RidePlace> places() const override;
    foundation::Result<Ride> make(std::size_t place) override;

private:
    foundation::Result<std::unique_ptr<simulation::VehicleController>>
    seated(std::unique_ptr<simulation::VehicleController> automatic,
           const simulation::DynamicVehicle& aircraft) const;

    const FlyRequest& _request;
    std::shared_ptr<const simulation::Ground> _ground;
    std::optional<simulation::Geodetic> _origin;
    std::shared_ptr<const simulation::EarthFrame> _earth;
    std::vector<FlightStart> _starts;
};

std::vector<RidePlace> FlightMaker::places() const
{
    std::vector<RidePlace> places;
    for (const FlightStart& start : _starts)
    {
        char option[160];
        std::snprintf(option, sizeof option, "--start %.17g,%.17g,%.17g,%.17g,%.17g", start.place.x,
                      start.place.y, start.heightM, start.headingDeg, start.speedMps);
        places.push_back({start.name, option});
    }
    return places;
}

/// A pilot beside the autopilot. He has it first unless there are orders or inputs.
foundation::Result<std::unique_ptr<simulation::VehicleController>>
FlightMaker::seated(std::unique_ptr<simulation::VehicleController> automatic,
                    const simulation::DynamicVehicle& aircraft) const
{
    auto hands = simulation::pilotHands(aircraft);
    if (!hands) return hands.error();
    const bool isByHand = _request.orders.empty() && _request.inputs.empty();
    return std::unique_ptr<simulation::VehicleController>(
        std::make_unique<simulation::HandOver>(std::move(automatic), std::move(*hands), isByHand));
}

foundation::Result<Ride> FlightMaker::make(std::size_t place)
{
    const FlightStart& from = _starts[place];
    glm::dvec3 start(from.place, 1e4);
    simulation::GroundPoint below;
    _ground->below({&start, 1}, {&below, 1});
    if (!below.isKnown)
        return foundation::Error{"--start", "there is no ground at the start", "give a place on the terrain"};
    start.z = below.heightM + from.heightM;
    auto aircraft = aircraftOf(_request, _origin);
    if (!aircraft) return aircraft.error();
    auto controller = controllerOf(_request, **aircraft, _earth, runwayOf(_request, *_ground));
    if (!controller) return controller.error();
    if (_request.hasWindow()) controller = seated(std::move(*controller), **aircraft);
    if (!controller) return controller.error();
    auto* const hands = dynamic_cast<simulation::HandOver*>(controller->get());
    auto vehicle =
        std::make_unique<simulation::ControlledVehicle>(std::move(*aircraft), std::move(*controller));
    if (!_request.recordInputs.empty()) vehicle->record();
    auto motion = std::make_shared<simulation::VehicleMotion>(
        std::move(vehicle), _ground, std::make_shared<const simulation::WeatherAir>(airOf(_request)));
    return Ride{scenarioOf(start, from, _origin), kEntity, std::move(motion), "flight", hands};
}

void tellFlight(const simulation::VehicleMotion& motion)
{
    const simulation::VehicleState& state = motion.vehicle().now();
    std::printf("flown %.2f s; at the end %s, %.1f m/s, %.1f m east, %.1f m north, %.1f m high\n",
                state.timeS, state.isOnGround ? "on the ground" : "in the air", glm::length(state.velocity),
                state.position.x, state.position.y, state.position.z);
    if (!motion.note().empty()) std::printf("note: the aircraft %s\n", motion.note().c_str());
    const auto* jsbsim = dynamic_cast<const simulation::JsbsimVehicle*>(&motion.vehicle().vehicle());
    if (jsbsim && !jsbsim->note().empty()) std::printf("note: %s\n", jsbsim->note().c_str());
}

/// The world of the request; level ground for a window without one.
foundation::Result<SceneTerrain> openWorld(const FlyRequest& request)
{
    const std::filesystem::path& world = request.play.terrain.file;
    if (!world.empty()) return openElevation(world, request.play.terrain);
    if (request.isHeadless) return SceneTerrain{};
    if (!request.hasWindow())
        return foundation::Error{"WORLD", "pictures need a world", "name a terrain, or write --headless"};
    simulation::FlightTrack middle;
    middle.fixes.push_back({});
    middle.fixes.back().latitudeDeg = 46.0;
    middle.fixes.back().longitudeDeg = 8.0;
    middle.fixes.back().heightM = 0.0;
    std::vector<osgTerrainROAM::core::GroundFeature> painted;
    if (request.play.terrain.strip) painted.push_back(paintedStrip(*request.play.terrain.strip));
    return makeFlatScene({middle}, std::move(painted));
}

} // namespace

foundation::Outcome fly(const FlyRequest& request)
{
    for (const auto& file : {request.recordInputs, request.play.output.motionFile})
        if (const auto writable = foundation::checkWritable(file); !writable) return writable;
    auto terrain = openWorld(request);
    if (!terrain) return terrain.error();
    std::shared_ptr<const simulation::Ground> ground = std::make_shared<simulation::LevelGround>();
    // Without a world the ground is level, in a window as without one: a flight repeats.
    const bool hasWorld = !request.play.terrain.file.empty();
    if (hasWorld) ground = std::make_shared<SceneGround>(terrain->ground(), terrain->seaLevelM);
    if (hasWorld && !request.play.terrain.strip && request.start.empty())
        std::printf(
            "note: there is no runway in this world; the flight begins in the air (--strip lays one)\n");
    FlightMaker maker(request, ground, terrain->origin());
    const auto motion = playRides(request, std::move(*terrain), maker);
    if (!motion) return motion.error();
    tellFlight(**motion);
    return foundation::success();
}

} // namespace trainer
