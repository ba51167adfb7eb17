// SPDX-License-Identifier: Apache-2.0
#include "RideScenario.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <foundation/Angle.h>

#include "simulation/tour/RideEnvironment.h"

namespace osgSession::core
{

namespace
{

simulation::Axle scenarioAxle(const simulation::RoadVehicleData& data, std::size_t index)
{
    const simulation::AxleData& axle = data.axles[index];
    return {index == 0 ? foundation::radiansOf(data.steering.lockDeg) : 0.0, 2.0 * axle.tyre.radiusM,
            axle.trackM, axle.xM, axle.tyre.radiusM};
}

simulation::Scenario rideScenario(const char* description, simulation::Vehicle vehicle,
                                  std::vector<simulation::PrivateAction> more, const RideBegin& begin,
                                  const std::optional<simulation::Geodetic>& origin,
                                  const simulation::RideConditions& conditions)
{
    simulation::Scenario scenario;
    scenario.header = {1, 3, "2024-01-01T00:00:00", "osgTrainer", description};
    scenario.entities.push_back({{}, kRideEntity, std::move(vehicle)});
    simulation::TeleportAction teleport;
    teleport.position =
        simulation::WorldPosition{{},
                                  begin.place.x,
                                  begin.place.y,
                                  begin.place.z,
                                  simulation::Orientation{begin.headingRad, std::nullopt, std::nullopt}};
    more.insert(more.begin(), teleport);
    scenario.storyboard.init.privates.push_back({{}, kRideEntity, std::move(more)});
    simulation::TourTerrain terrain;
    terrain.origin = origin;
    terrain.eastM = terrain.northM = 20'000.0;
    scenario.storyboard.init.globals.push_back(simulation::EnvironmentAction{
        {}, simulation::rideEnvironment(terrain, begin.headingRad, conditions)});
    return scenario;
}

} // namespace

simulation::Scenario driveScenario(const simulation::RoadVehicleData& data, const RideBegin& begin,
                                   const std::optional<simulation::Geodetic>& origin,
                                   const simulation::RideConditions& conditions)
{
    constexpr double kBusFromKg = 8000.0;
    simulation::Vehicle vehicle;
    vehicle.name = data.name;
    if (!data.lookFile.empty()) vehicle.model3d = std::filesystem::absolute(data.lookFile).string();
    vehicle.category = simulation::massProperties(data).massKg > kBusFromKg ? "bus" : "car";
    const simulation::HullBox& box = data.hull.boxes.front();
    double topM = 0.0;
    for (const simulation::HullBox& part : data.hull.boxes)
        topM = std::max(topM, part.place.z + 0.5 * part.sizeM.z);
    vehicle.box = {{box.place.x, 0.0, 0.5 * topM}, box.sizeM.x, box.sizeM.y, topM};
    vehicle.frontAxle = scenarioAxle(data, 0);
    vehicle.rearAxle = scenarioAxle(data, 1);
    return rideScenario("A drive", std::move(vehicle), {}, begin, origin, conditions);
}

simulation::Scenario flightScenario(const RideBegin& begin, const std::optional<simulation::Geodetic>& origin,
                                    const simulation::RideConditions& conditions)
{
    simulation::Vehicle vehicle;
    vehicle.name = vehicle.category = "aircraft";
    vehicle.box = {{-0.8, 0.0, 1.4}, 8.2, 11.0, 2.8};
    simulation::SpeedAction speed;
    speed.target = simulation::AbsoluteTargetSpeed{begin.speedMps};
    return rideScenario("A flight", std::move(vehicle), {speed}, begin, origin, conditions);
}

} // namespace osgSession::core
