// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/ScenarioMotions.h"

#include <algorithm>
#include <cmath>

#include <foundation/Fnv1a.h>

#include "simulation/control/VehicleMotion.h"
#include "simulation/control/driver/Driver.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/control/scenario/ControllerProperties.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/vehicle/WeatherAir.h"

namespace simulation
{
namespace
{

using foundation::Error;
using foundation::Result;
using Controls = Result<std::unique_ptr<VehicleController>>;

constexpr double kTownMps = 50.0 / 3.6; ///< where neither scenario nor road gives a speed
constexpr double kStraightM = 20'000.0; ///< ahead of a driver who has no way
constexpr double kLeastPieceM = 0.2;

/// What the properties say of the vehicle, whoever drives it.
struct VehicleWish
{
    std::filesystem::path file;
    std::uint64_t seed = 0;
    double turbulenceMps = 0.0; ///< deviation above 600 m
};

VehicleWish vehicleWish(ControllerProperties& properties, const ScenarioObject& object)
{
    constexpr double kMostSeed = 4294967295.0;
    VehicleWish wish;
    wish.file = properties.file("vehicle", vehicleFileFor(object));
    wish.seed = static_cast<std::uint64_t>(properties.number("seed", 0.0, 0.0, kMostSeed));
    wish.turbulenceMps = properties.number("turbulence", 0.0, 0.0, 20.0);
    return wish;
}

DriverPath pathOf(const MotionStart& start)
{
    std::vector<DriverPoint> points;
    for (const AheadPoint& point : start.way.points)
        if (points.empty() ||
            glm::distance(glm::dvec2(points.back().place), glm::dvec2(point.place)) > kLeastPieceM)
            points.push_back({point.place, point.limitMps.value_or(1e9)});
    if (points.size() < 2)
    {
        const glm::dvec3 ahead = start.state.bodyToLocal()[0];
        points = {{start.state.position}, {start.state.position + kStraightM * ahead}};
    }
    std::vector<DriverStop> stops;
    for (const AheadStop& stop : start.way.stops)
        stops.push_back({stop.atM, stop.signal});
    return DriverPath(points, std::move(stops));
}

/// A speed that the scenario gave comes before the limits of the roads.
double wantedSpeed(const MotionStart& start)
{
    constexpr double kMovesMps = 0.1;
    if (start.state.speedMps > kMovesMps) return start.state.speedMps;
    const bool hasLimits = std::any_of(start.way.points.begin(), start.way.points.end(),
                                       [](const AheadPoint& point) { return point.limitMps.has_value(); });
    return hasLimits ? 1e9 : kTownMps;
}

Controls driverOf(ControllerProperties& properties, const DynamicVehicle& vehicle, const MotionStart* start)
{
    DriverSettings settings;
    const double speed = properties.number("speed", 0.0, 0.1, 100.0);
    settings.lateralMps2 = properties.number("lateralAcceleration", settings.lateralMps2, 0.2, 10.0);
    settings.accelerateMps2 = properties.number("acceleration", settings.accelerateMps2, 0.1, 10.0);
    settings.brakeMps2 = properties.number("deceleration", settings.brakeMps2, 0.1, 10.0);
    settings.headwayS = properties.number("headway", settings.headwayS, 0.1, 10.0);
    settings.gapM = properties.number("gap", settings.gapM, 0.5, 50.0);
    settings.waitS = properties.number("wait", settings.waitS, 0.0, 600.0);
    settings.overtakes = properties.flag("overtakes", settings.overtakes);
    if (properties.error()) return *properties.error();
    const auto* const road = dynamic_cast<const RoadVehicle*>(&vehicle);
    if (!road)
        return Error{"property vehicle", "a Driver drives road vehicles alone",
                     "give a data file of a road vehicle, or write Autopilot"};
    if (!start) return std::unique_ptr<VehicleController>();
    settings.speedMps = speed > 0.0 ? speed : wantedSpeed(*start);
    return std::unique_ptr<VehicleController>(std::make_unique<Driver>(*road, pathOf(*start), settings));
}

Controls autopilotOf(ControllerProperties& properties, const DynamicVehicle& vehicle,
                     const std::shared_ptr<const EarthFrame>& earth, const Ground& ground)
{
    AutopilotSettings settings{earth, {}, {}};
    const std::string orders = properties.text("orders");
    const std::vector<double> strip = properties.numbers("strip", 4, 5);
    if (properties.error()) return *properties.error();
    if (!strip.empty())
        settings.runway = runwayOn(ground, {strip[0], strip[1]}, strip[2], strip[3],
                                   strip.size() > 4 ? strip[4] : RunwayStrip().widthM);
    if (!orders.empty())
    {
        auto read = parseFlightOrders(orders, "property orders");
        if (!read) return read.error();
        settings.orders = std::move(*read);
    }
    auto pilot = Autopilot::create(std::move(settings), vehicle);
    if (!pilot)
        return Error{"property orders", pilot.error().what,
                     "give the property strip, other orders, or the data file of an aircraft"};
    return std::unique_ptr<VehicleController>(std::make_unique<Autopilot>(std::move(*pilot)));
}

/// The controller for a vehicle. `start`: null only checks.
Controls controlsOf(const Controller& controller, ControllerProperties& properties,
                    const DynamicVehicle& vehicle, const std::shared_ptr<const EarthFrame>& earth,
                    const Ground& ground, const MotionStart* start)
{
    if (controller.isDriver()) return driverOf(properties, vehicle, start);
    if (controller.isAutopilot()) return autopilotOf(properties, vehicle, earth, ground);
    const std::filesystem::path inputs = properties.file("inputs", "");
    if (properties.error()) return *properties.error();
    if (inputs.empty())
        return Error{"property inputs", "is missing", "name an inputs file (docs/reference/inputs-file.md)"};
    return openInputs(inputs, vehicle);
}

ControllerProperties propertiesOf(const Controller& controller, const std::filesystem::path& folder)
{
    if (controller.isDriver())
        return {controller,
                folder,
                {"vehicle", "seed", "turbulence", "speed", "lateralAcceleration", "acceleration",
                 "deceleration", "headway", "gap", "wait", "overtakes"}};
    if (controller.isAutopilot())
        return {controller, folder, {"vehicle", "seed", "turbulence", "orders", "strip"}};
    return {controller, folder, {"vehicle", "seed", "turbulence", "inputs"}};
}

/// The series of random numbers of one entity.
std::uint64_t seedOf(std::uint64_t seed, const std::string& entity)
{
    foundation::Fnv1a hash(seed ^ foundation::Fnv1a().value()); // begins with the seed itself
    hash.add(entity);
    return hash.value();
}

} // namespace

ScenarioMotions::ScenarioMotions(World world) : _world(std::move(world)), _earth(earthOf(_world.origin)) {}

foundation::Outcome ScenarioMotions::check(const Controller& controller, const ScenarioObject& object)
{
    ControllerProperties properties = propertiesOf(controller, _world.folder);
    const VehicleWish wish = vehicleWish(properties, object);
    if (properties.error()) return *properties.error();
    const auto vehicle = openVehicle(wish.file, _world.origin, wish.seed);
    if (!vehicle) return vehicle.error();
    const auto controls = controlsOf(controller, properties, **vehicle, _earth, *_world.ground, nullptr);
    if (!controls) return controls.error();
    return foundation::success();
}

Result<std::shared_ptr<ExternalMotion>>
ScenarioMotions::make(const Controller& controller, const ScenarioObject& object, const MotionStart& start)
{
    ControllerProperties properties = propertiesOf(controller, _world.folder);
    const VehicleWish wish = vehicleWish(properties, object);
    if (properties.error()) return *properties.error();
    auto vehicle = openVehicle(wish.file, _world.origin, seedOf(_world.seed + wish.seed, object.name));
    if (!vehicle) return vehicle.error();
    auto controls = controlsOf(controller, properties, **vehicle, _earth, *_world.ground, &start);
    if (!controls) return controls.error();
    auto motion = std::make_shared<VehicleMotion>(
        std::make_unique<ControlledVehicle>(std::move(*vehicle), std::move(*controls)), _world.ground,
        std::make_shared<const WeatherAir>());
    motion->followWeather(_world.origin ? _world.origin->heightM : 0.0, wish.turbulenceMps);
    if (auto begun = motion->begin(start.state, start.isAirborne, start.timeS, start.environment); !begun)
        return begun.error();
    return std::shared_ptr<ExternalMotion>(std::move(motion));
}

} // namespace simulation
