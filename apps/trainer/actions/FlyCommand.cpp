// SPDX-License-Identifier: Apache-2.0
#include "FlyCommand.h"

#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>
#include <foundation/Units.h>

#include "PlayPlaces.h"
#include "ride/FlightAircraft.h"
#include "ride/FlightMaker.h"
#include "ride/Ride.h"
#include "scene/FlatScene.h"
#include "scene/SceneGround.h"
#include "scene/SceneStrip.h"
#include "scene/SceneTerrain.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/control/flight/FlightOrders.h"
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"

namespace trainer
{

namespace
{

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

/// The world of the request; level ground where pictures have none.
foundation::Result<SceneTerrain> openWorld(const FlyRequest& request)
{
    const std::filesystem::path& world = request.play.terrain.file;
    if (!world.empty()) return openElevation(world, request.play.terrain);
    if (request.isHeadless) return SceneTerrain{};
    std::vector<osgTerrainROAM::core::GroundFeature> painted;
    if (request.play.terrain.strip) painted.push_back(paintedStrip(*request.play.terrain.strip));
    return makeLevelScene({46.0, 8.0, 0.0}, std::move(painted));
}

} // namespace

glm::dvec2 FlyRequest::windMps() const
{
    if (wind.empty()) return glm::dvec2(0.0);
    const double from = foundation::radiansOf(wind[0]);
    return -foundation::kMpsPerKnot * wind[1] * glm::dvec2(std::sin(from), std::cos(from));
}

foundation::Outcome checkFlight(const FlyRequest& request)
{
    if (const auto usable = checkBeforeRide(request); !usable) return usable;
    if (!request.orders.empty())
        if (const auto orders = simulation::parseFlightOrders(request.orders, "--orders"); !orders)
            return orders.error();
    return checkAircraft(request);
}

foundation::Outcome fly(const FlyRequest& asked)
{
    FlyRequest request = asked;
    auto terrain = openWorld(request);
    if (!terrain) return terrain.error();
    std::shared_ptr<const simulation::Ground> ground = std::make_shared<simulation::LevelGround>();
    // Without a world the ground is level, in a window as without one: a flight repeats.
    const bool hasWorld = !request.play.terrain.file.empty();
    if (hasWorld) ground = std::make_shared<SceneGround>(terrain->ground(), terrain->seaLevelM);
    if (!request.play.terrain.strip && (request.start.empty() || !request.orders.empty()))
        request.play.terrain.strip = runwayInUse(
            terrain->runways, request.wind.empty() ? std::nullopt : std::optional(request.wind[0]));
    if (hasWorld && !request.play.terrain.strip && request.start.empty())
        std::printf(
            "note: there is no runway in this world; the flight begins in the air (--strip lays one)\n");
    if (terrain->airfield && !request.wind.empty()) terrain->airfield->setWind(request.windMps());
    FlightMaker maker(request, ground, terrain->origin());
    const auto motion = playRides(request, std::move(*terrain), maker);
    if (!motion) return motion.error();
    tellFlight(**motion);
    return foundation::success();
}

} // namespace trainer
