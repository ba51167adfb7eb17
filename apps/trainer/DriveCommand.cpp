// SPDX-License-Identifier: Apache-2.0
#include "DriveCommand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <foundation/Angle.h>
#include <foundation/WholeFile.h>

#include "DriveWay.h"
#include "SceneTerrain.h"
#include "simulation/control/RecordedInputs.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/control/driver/Driver.h"
#include "simulation/tour/TourScenario.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace trainer
{

namespace
{

constexpr const char* kCar = "Ego";
constexpr double kStartM = 1.0; ///< of the way, at which the rear axle begins

simulation::Axle scenarioAxle(const simulation::RoadVehicleData& data, std::size_t index)
{
    const simulation::AxleData& axle = data.axles[index];
    return {index == 0 ? foundation::radiansOf(data.steering.lockDeg) : 0.0, 2.0 * axle.tyre.radiusM,
            axle.trackM, axle.xM, axle.tyre.radiusM};
}

/// One vehicle that stands at the begin of its way.
simulation::Scenario driveScenario(const simulation::RoadVehicleData& data,
                                   const simulation::DriverPath& path,
                                   const std::optional<simulation::Geodetic>& origin)
{
    simulation::Scenario scenario;
    scenario.header = {1, 3, "2024-01-01T00:00:00", "osgTrainer", "A drive"};
    simulation::Vehicle vehicle;
    vehicle.name = data.name;
    vehicle.category = simulation::massProperties(data).massKg > 8000.0 ? "bus" : "car";
    const simulation::HullBox& box = data.hull.boxes.front();
    double topM = 0.0;
    for (const simulation::HullBox& part : data.hull.boxes)
        topM = std::max(topM, part.place.z + 0.5 * part.sizeM.z);
    vehicle.box = {{box.place.x, 0.0, 0.5 * topM}, box.sizeM.x, box.sizeM.y, topM};
    vehicle.frontAxle = scenarioAxle(data, 0);
    vehicle.rearAxle = scenarioAxle(data, 1);
    scenario.entities.push_back({{}, kCar, vehicle});
    const glm::dvec3 start = path.placeAt(kStartM);
    simulation::TeleportAction teleport;
    teleport.position = simulation::WorldPosition{
        {},
        start.x,
        start.y,
        start.z,
        simulation::Orientation{path.headingRadAt(kStartM), std::nullopt, std::nullopt}};
    scenario.storyboard.init.privates.push_back({{}, kCar, {teleport}});
    simulation::TourTerrain terrain;
    terrain.origin = origin;
    terrain.eastM = terrain.northM = 20'000.0;
    scenario.storyboard.init.globals.push_back(
        simulation::EnvironmentAction{{}, simulation::tourEnvironment(terrain, path.headingRadAt(kStartM))});
    return scenario;
}

foundation::Result<std::unique_ptr<simulation::VehicleController>>
driverOf(const DriveRequest& request, const simulation::RoadVehicle& vehicle, simulation::DriverPath path)
{
    if (request.inputs.empty())
    {
        simulation::DriverSettings settings;
        if (request.speedMps > 0.0) settings.speedMps = request.speedMps;
        return std::unique_ptr<simulation::VehicleController>(
            std::make_unique<simulation::Driver>(vehicle, std::move(path), settings));
    }
    auto track = simulation::readInputs(request.inputs);
    if (!track) return track.error();
    auto inputs = simulation::RecordedInputs::create(std::move(*track), vehicle, request.inputs.string());
    if (!inputs) return inputs.error();
    return std::unique_ptr<simulation::VehicleController>(
        std::make_unique<simulation::RecordedInputs>(std::move(*inputs)));
}

/// Tells of a drive at its end, and writes what was recorded.
foundation::Outcome leaveDrive(const DriveRequest& request, const simulation::VehicleMotion& motion)
{
    const simulation::ControlledVehicle& vehicle = motion.vehicle();
    if (const auto* driver = dynamic_cast<const simulation::Driver*>(vehicle.controller()))
        std::printf("driven %.2f s, %.1f of %.0f m of lanes, %.3f m from the middle at most\n",
                    vehicle.now().timeS, driver->beside().alongM, driver->path().lengthM(),
                    driver->worstOffsetM());
    else
        std::printf("driven %.2f s by recorded inputs\n", vehicle.now().timeS);
    if (!motion.note().empty()) std::printf("note: the vehicle %s\n", motion.note().c_str());
    if (request.recordInputs.empty()) return foundation::success();
    return vehicle.recorder()->write(request.recordInputs);
}

} // namespace

foundation::Outcome drive(const DriveRequest& request)
{
    for (const auto& file : {request.recordInputs, request.play.output.motionFile})
        if (const auto writable = foundation::checkWritable(file); !writable) return writable;
    const std::filesystem::path& world = request.play.terrain.file;
    const auto read = simulation::readRoadVehicle(request.vehicle);
    if (!read) return read.error();
    const auto data = std::make_shared<const simulation::RoadVehicleData>(*read);
    auto scene = openElevation(world, request.play.terrain);
    if (!scene) return scene.error();
    const auto path = driveWay(*scene, world.string(), request.lengthM);
    if (!path) return path.error();
    std::shared_ptr<const simulation::EarthFrame> earth;
    if (const auto origin = scene->origin()) earth = std::make_shared<const simulation::EarthFrame>(*origin);
    auto car = std::make_unique<simulation::RoadVehicle>(data, earth);
    auto controller = driverOf(request, *car, *path);
    if (!controller) return controller.error();
    auto driven = std::make_unique<simulation::ControlledVehicle>(std::move(car), std::move(*controller));
    if (!request.recordInputs.empty()) driven->record();
    const auto motion = std::make_shared<simulation::VehicleMotion>(
        std::move(driven), groundForWheels(*scene), std::make_shared<const simulation::WeatherAir>());
    simulation::Scenario scenario = driveScenario(*data, *path, scene->origin());
    if (const auto played =
            playRide(request, std::move(*scene), {std::move(scenario), kCar, motion, "drive"});
        !played)
        return played;
    return leaveDrive(request, *motion);
}

} // namespace trainer
