// SPDX-License-Identifier: Apache-2.0
#include "FlightMaker.h"

#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

#include "FlightAircraft.h"
#include "osgSession/src/core/RideScenario.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/control/flight/ManualPilot.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/scenario/SessionTraffic.h"
#include "simulation/vehicle/ScenarioWeather.h"

namespace trainer
{

namespace
{

/// The air of a request. Of a weather report temperature and pressure count.
simulation::WeatherAir airOf(const FlyRequest& request, double originHeightM)
{
    simulation::EnvironmentState told;
    if (const auto& report = request.play.weather)
    {
        told.temperatureK = report->temperatureK;
        told.seaPressurePa = report->seaPressurePa;
    }
    simulation::WeatherSettings weather = simulation::weatherOf(told, originHeightM);
    weather.gustDeviationMps = request.gustsMps;
    weather.windMps = glm::dvec3(request.windMps(), 0.0);
    if (!request.wind.empty() && request.gustsMps > 0.0)
        weather.windAtSixMetresMps = glm::length(weather.windMps);
    return simulation::WeatherAir(weather);
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

} // namespace

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
    auto manual = simulation::manualPilot(aircraft);
    if (!manual) return manual.error();
    const bool isByHand = _request.orders.empty() && _request.inputs.empty();
    return std::unique_ptr<simulation::VehicleController>(
        std::make_unique<simulation::ControlSwitch>(std::move(automatic), std::move(*manual), isByHand));
}

foundation::Result<Ride> FlightMaker::make(std::size_t place)
{
    const FlightStart& from = _starts[place];
    glm::dvec3 start(from.place, 1e4);
    simulation::GroundPoint below;
    _ground->below({&start, 1}, {&below, 1});
    if (!below.isKnown)
    {
        char where[100];
        std::snprintf(where, sizeof where, "%s at %.0f m east, %.0f m north", from.name.c_str(), from.place.x,
                      from.place.y);
        return foundation::Error{_request.start.empty() ? where : "--start", "there is no ground",
                                 "give a place on the terrain: --start X,Y,H,HEADING,SPEED"};
    }
    start.z = below.heightM + from.heightM;
    auto aircraft = aircraftOf(_request, _origin);
    if (!aircraft) return aircraft.error();
    (*aircraft)->meet(_obstacles);
    auto controller = controllerOf(_request, **aircraft, _earth, runwayOf(_request, *_ground));
    if (!controller) return controller.error();
    if (_request.hasWindow()) controller = seated(std::move(*controller), **aircraft);
    if (!controller) return controller.error();
    auto* const manual = dynamic_cast<simulation::ControlSwitch*>(controller->get());
    auto vehicle =
        std::make_unique<simulation::ControlledVehicle>(std::move(*aircraft), std::move(*controller));
    if (!_request.recordInputs.empty()) vehicle->record();
    auto motion = std::make_shared<simulation::VehicleMotion>(
        std::move(vehicle), _ground,
        std::make_shared<const simulation::WeatherAir>(airOf(_request, _origin ? _origin->heightM : 0.0)));
    if (_request.play.trafficRoads) motion->meetOthers();
    const osgSession::core::RideBegin begin{start, foundation::radiansOf(90.0 - from.headingDeg),
                                            from.speedMps};
    simulation::Scenario scenario = osgSession::core::flightScenario(begin, _origin, _request.conditions);
    simulation::addTraffic(scenario, osgSession::core::kRideEntity,
                           {_request.play.trafficPerKm, simulation::SessionTraffic::kAroundAircraftM});
    scenario.roadNetwork.signalControllers = _request.play.lights;
    return Ride{std::move(scenario), osgSession::core::kRideEntity, std::move(motion), "flight", manual};
}

} // namespace trainer
