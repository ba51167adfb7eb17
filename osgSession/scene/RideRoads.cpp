// SPDX-License-Identifier: Apache-2.0
#include "RideRoads.h"

#include "scenery/roads/RoadsInScene.h"
#include "simulation/road/LightApproaches.h"
#include "simulation/road/SignalProgrammes.h"

namespace trainer
{

std::shared_ptr<const simulation::RoadScene> roadSceneOf(const SceneTerrain& scene)
{
    if (!scene.roads) return nullptr;
    return std::make_shared<const simulation::RoadScene>(scenery::roadsInScene(*scene.roads));
}

void addRoads(PlayRequest& ride, const SceneTerrain& scene)
{
    const bool hasTraffic = ride.trafficPerKm > 0.0;
    if (!scene.roads || (!hasTraffic && !simulation::hasTrafficLights(scene.roads->network()))) return;
    const auto roads = ride.roadsUnder ? ride.roadsUnder : roadSceneOf(scene);
    if (hasTraffic) ride.trafficRoads = roads;
    ride.lights = simulation::signalProgrammes(*roads);
}

} // namespace trainer
