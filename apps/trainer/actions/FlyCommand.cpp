// SPDX-License-Identifier: Apache-2.0
#include "FlyCommand.h"

#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>
#include <foundation/Units.h>

#include "PlayPlaces.h"
#include "PlayRides.h"
#include "ride/FlightAircraft.h"
#include "ride/FlightMaker.h"
#include "scene/FlatScene.h"
#include "scene/RideAir.h"
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

/// What tells how high a place is: the terrain counts from its own datum, which is the sea's in most rasters.
struct HeightTable
{
    osg::ref_ptr<osgTerrainROAM::RoamTerrain> terrain; ///< null: the ground is level
    glm::dvec2 cornerM{0.0};

    double heightM(const glm::dvec3& place) const
    {
        if (!terrain) return place.z;
        return terrain->tile()->tile.frame().heightOf(place - glm::dvec3(cornerM, 0.0));
    }
};

void tellFlight(const simulation::VehicleMotion& motion, const HeightTable& heights,
                const simulation::Ground& ground)
{
    const simulation::VehicleState& state = motion.vehicle().now();
    std::printf("flown %.2f s; at the end %s, %.1f m/s, %.1f m east, %.1f m north, %.1f m %s\n", state.timeS,
                state.isOnGround ? "on the ground" : "in the air", glm::length(state.velocity),
                state.position.x, state.position.y, heights.heightM(state.position),
                heights.terrain ? "above the sea" : "high");
    glm::dvec3 place(state.position.x, state.position.y, state.position.z);
    simulation::GroundPoint below;
    ground.below({&place, 1}, {&below, 1});
    if (!below.isKnown)
        std::printf("note: the flight ends beyond the elevation data, where there is no ground\n");
    if (!motion.note().empty()) std::printf("note: the aircraft %s\n", motion.note().c_str());
    for (const simulation::Impact& impact : motion.vehicle().vehicle().impacts())
        std::printf("impact: %s%s\n", simulation::textOf(impact).c_str(),
                    impact.hasGiven ? ", which gave way" : "");
    const auto* jsbsim = dynamic_cast<const simulation::JsbsimVehicle*>(&motion.vehicle().vehicle());
    if (jsbsim && !jsbsim->note().empty()) std::printf("note: %s\n", jsbsim->note().c_str());
}

/// Errors: a direction or a speed that no wind has. The two are easily swapped.
foundation::Outcome checkWind(const std::vector<double>& wind)
{
    constexpr double kMostKnots = 150.0;
    if (wind.empty() || (wind[0] >= 0.0 && wind[0] <= 360.0 && wind[1] >= 0.0 && wind[1] <= kMostKnots))
        return foundation::success();
    char what[100], remedy[100];
    std::snprintf(what, sizeof what, "%g° and %g kt are no wind", wind[0], wind[1]);
    const bool isSwapped = wind[1] >= 0.0 && wind[1] <= 360.0 && wind[0] >= 0.0 && wind[0] <= kMostKnots;
    std::snprintf(remedy, sizeof remedy, "FROM,KNOTS: did you mean %g,%g?", wind[1], wind[0]);
    return foundation::Error{"--wind", what,
                             isSwapped ? remedy : "write FROM,KNOTS: 0 to 360 degrees, 0 to 150 kt"};
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

foundation::Outcome checkFlight(const FlyRequest& request)
{
    if (const auto usable = checkBeforeRide(request); !usable) return usable;
    if (const auto windy = checkWind(request.wind); !windy) return windy;
    if (!request.orders.empty())
        if (const auto orders = simulation::parseFlightOrders(request.orders, "--orders"); !orders)
            return orders.error();
    return checkAircraft(request);
}

foundation::Outcome fly(const FlyRequest& asked)
{
    FlyRequest request = asked;
    request.play.terrain.wantsObstacles = true;
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
    request.conditions = inAirOf(*terrain, request.conditions);
    const HeightTable heights{terrain->terrain, terrain->cornerM};
    openRoads(request, *terrain);
    FlightMaker maker(request, ground, terrain->origin(), terrain->obstacles);
    const auto motion = playRides(request, std::move(*terrain), maker);
    if (!motion) return motion.error();
    tellFlight(**motion, heights, *ground);
    return foundation::success();
}

} // namespace trainer
