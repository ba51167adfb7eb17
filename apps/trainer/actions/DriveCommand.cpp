// SPDX-License-Identifier: Apache-2.0
#include "DriveCommand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "PlayPlaces.h"
#include "PlayRides.h"
#include "PlaySeats.h"
#include "osgSession/src/core/RideScenario.h"
#include "scene/DriveWay.h"
#include "scene/RideAir.h"
#include "scene/RideRoads.h"
#include "scene/SceneTerrain.h"
#include "scenery/models/looks/VehicleLookFile.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/control/driver/Driver.h"
#include "simulation/control/driver/ManualDriver.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/scenario/SessionTraffic.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace trainer
{

namespace
{

foundation::Result<std::unique_ptr<simulation::VehicleController>>
driverOf(const DriveRequest& request, const simulation::RoadVehicle& vehicle, simulation::DriverPath path)
{
    if (!request.inputs.empty()) return simulation::openInputs(request.inputs, vehicle);
    simulation::DriverSettings settings;
    if (request.speedMps > 0.0) settings.speedMps = request.speedMps;
    return std::unique_ptr<simulation::VehicleController>(
        std::make_unique<simulation::Driver>(vehicle, std::move(path), settings));
}

std::string textOfMetres(double metres)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.0f m", metres);
    return text;
}

void tellDrive(const simulation::VehicleMotion& motion)
{
    const simulation::ControlledVehicle& vehicle = motion.vehicle();
    const simulation::VehicleController* controller = vehicle.controller();
    const auto* const seat = dynamic_cast<const simulation::ControlSwitch*>(controller);
    if (seat) controller = seat->automatic();
    const auto* const driver = dynamic_cast<const simulation::Driver*>(controller);
    const bool isWatched = seat && !seat->wishes().empty();
    if (driver && (!seat || isWatched))
        std::printf("driven %.2f s%s, %.1f of %.0f m of lanes, %.3f m from the middle at most\n",
                    vehicle.now().timeS, isWatched ? " by keys" : "", driver->beside().alongM,
                    driver->path().lengthM(), driver->worstOffsetM());
    else
        std::printf("driven %.2f s by %s\n", vehicle.now().timeS, seat ? "hand" : "recorded inputs");
    if (!motion.note().empty()) std::printf("note: the vehicle %s\n", motion.note().c_str());
    for (const simulation::Impact& impact : vehicle.vehicle().impacts())
        std::printf("impact: %s%s\n", simulation::textOf(impact).c_str(),
                    impact.hasGiven ? ", which gave way" : "");
}

/// Makes one drive after the other along one way.
class DriveMaker final : public RideMaker
{
public:
    DriveMaker(const DriveRequest& request, const simulation::RoadVehicleData& data,
               const SceneTerrain& scene, simulation::DriverPath path)
        : _request(request),
          _data(std::make_shared<const simulation::RoadVehicleData>(data)),
          _ground(groundForWheels(scene, request.surface)),
          _obstacles(scene.obstacles),
          _origin(scene.origin()),
          _path(std::move(path))
    {
        if (_origin) _earth = std::make_shared<const simulation::EarthFrame>(*_origin);
        _startsM.push_back(std::min(_request.startM, _path.lengthM() - 1.0));
        for (const double share : {0.25, 0.5, 0.75})
            _startsM.push_back(std::round(share * _path.lengthM()));
    }

    KeyScope kind() const override { return KeyScope::drive; }

    std::vector<RidePlace> places() const override
    {
        std::vector<RidePlace> places;
        for (const double startM : _startsM)
        {
            char name[60], option[60];
            std::snprintf(name, sizeof name, "at %.0f m of the way", startM);
            std::snprintf(option, sizeof option, "--start-at %.17g", startM);
            places.push_back({name, option});
        }
        return places;
    }

    foundation::Result<Ride> make(std::size_t place) override
    {
        auto car = std::make_unique<simulation::RoadVehicle>(_data, _earth);
        car->meet(_obstacles);
        auto controller = driverOf(_request, *car, _path);
        if (!controller) return controller.error();
        if (_request.hasWindow())
            *controller = std::make_unique<simulation::ControlSwitch>(
                std::move(*controller), simulation::manualDriver(*car), _request.inputs.empty());
        auto* const manual = dynamic_cast<simulation::ControlSwitch*>(controller->get());
        auto driven = std::make_unique<simulation::ControlledVehicle>(std::move(car), std::move(*controller));
        if (!_request.recordInputs.empty()) driven->record();
        auto motion = std::make_shared<simulation::VehicleMotion>(
            std::move(driven), _ground, std::make_shared<const simulation::WeatherAir>());
        motion->followWeather(_origin ? _origin->heightM : 0.0, 0.0);
        if (_request.play.trafficRoads) motion->meetOthers();
        const double startM = _startsM[place];
        simulation::Scenario scenario = osgSession::core::driveScenario(
            *_data, {_path.placeAt(startM), _path.headingRadAt(startM)}, _origin, _request.conditions);
        simulation::addTraffic(scenario, osgSession::core::kRideEntity, {_request.play.trafficPerKm});
        scenario.roadNetwork.signalControllers = _request.play.lights;
        return Ride{std::move(scenario), osgSession::core::kRideEntity, std::move(motion), "drive", manual};
    }

private:
    const DriveRequest& _request;
    std::shared_ptr<const simulation::RoadVehicleData> _data;
    std::shared_ptr<const simulation::Ground> _ground;
    std::shared_ptr<const simulation::ObstacleMap> _obstacles;
    std::optional<simulation::Geodetic> _origin;
    std::shared_ptr<const simulation::EarthFrame> _earth;
    simulation::DriverPath _path;
    std::vector<double> _startsM;
};

} // namespace

foundation::Outcome checkDrive(const DriveRequest& request)
{
    if (const auto usable = checkBeforeRide(request); !usable) return usable;
    const auto vehicle = simulation::readRoadVehicle(request.vehicle);
    if (!vehicle) return vehicle.error();
    if (vehicle->lookFile.empty()) return foundation::success();
    const auto look = scenery::models::readVehicleLook(vehicle->lookFile);
    return look ? foundation::success() : look.error();
}

foundation::Outcome drive(const DriveRequest& asked)
{
    DriveRequest request = asked;
    request.play.terrain.wantsObstacles = true;
    const std::filesystem::path& world = request.play.terrain.file;
    const auto data = simulation::readRoadVehicle(request.vehicle);
    if (!data) return data.error();
    auto scene = openElevation(world, request.play.terrain);
    if (!scene) return scene.error();
    const auto path = driveWay(*scene, world.string(), request.lengthM);
    if (!path) return path.error();
    if (request.startM > path->lengthM() - 1.0)
        return foundation::Error{"--start-at",
                                 textOfMetres(request.startM) + " is beyond the way, which is " +
                                     textOfMetres(path->lengthM()) + " long",
                                 "give less"};
    if (const auto told = tellInputs(request.inputs); !told) return told;
    request.conditions = inAirOf(*scene, request.conditions);
    if (!request.play.output.motionFile.empty()) request.play.roadsUnder = roadSceneOf(*scene);
    openRoads(request, *scene);
    DriveMaker maker(request, *data, *scene, *path);
    const auto motion = playRides(request, std::move(*scene), maker);
    if (!motion) return motion.error();
    tellDrive(**motion);
    return foundation::success();
}

} // namespace trainer
