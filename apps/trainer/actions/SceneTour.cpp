// SPDX-License-Identifier: Apache-2.0
#include "SceneTour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>
#include <vector>

#include <foundation/Angle.h>

#include <osgDB/FileNameUtils>

#include <osgRoads/core/query/ChooseDrive.h>

#include "scenery/ground/TileGround.h"
#include "scenery/roads/LanePath.h"
#include "simulation/tour/LayDrive.h"
#include "simulation/tour/LayTour.h"
#include "simulation/tour/RideEnvironment.h"
#include "simulation/tour/Sights.h"

namespace trainer
{

namespace
{

constexpr double kSpareWayM =
    40.0; ///< beyond what is driven, so that the drive does not stop before its time
constexpr double kRunwayWeight = 0.8; ///< of one of 1000 m or more; a town's is about 1

std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %%", 100.0 * share);
    return text;
}

/// Returns an absolute path, which a saved scenario can be played with from any folder.
std::string absoluteName(const std::filesystem::path& file)
{
    std::error_code failed; // of a working folder that is gone
    const std::filesystem::path absolute = std::filesystem::absolute(file, failed);
    return (failed ? file : absolute).string();
}

bool isDrive(const PlayRequest& request)
{
    switch (request.frames.eye)
    {
    case EyePoint::driver:
    case EyePoint::above:
        return true;
    case EyePoint::pilot:
        return false;
    default:
        return osgDB::getLowerCaseFileExtension(request.terrain.file.string()) == "xodr";
    }
}

/// What a world has to show: settlements, runways, shores. Nothing where nobody lives: relief is then all.
std::vector<simulation::Sight> sightsOf(const SceneTerrain& scene, const simulation::TourTerrain& terrain)
{
    std::vector<simulation::Sight> sights = simulation::settlementSights(scene.houses);
    for (const SceneRunway& runway : scene.runways)
    {
        const double lengthM = runway.strip.lengthM, course = foundation::radiansOf(runway.strip.courseDeg);
        sights.push_back(
            {runway.strip.threshold + 0.5 * lengthM * glm::dvec2(std::sin(course), std::cos(course)),
             0.5 * lengthM, kRunwayWeight * std::clamp(lengthM / 1000.0, 0.3, 1.0)});
    }
    if (sights.empty() || !scene.seaLevelM) return sights;
    const std::vector<simulation::Sight> shores = simulation::shoreSights(terrain, *scene.seaLevelM);
    sights.insert(sights.end(), shores.begin(), shores.end());
    return sights;
}

foundation::Result<SceneTour> layFlight(const SceneTerrain& scene, simulation::TourTerrain terrain,
                                        double durationS)
{
    terrain.sights = sightsOf(scene, terrain);
    auto laid = simulation::layTour(terrain, {.durationS = durationS});
    if (!laid) return laid.error();
    std::string summary = "tour: " + std::to_string(std::lround(laid->lowestM)) + " to " +
                          std::to_string(std::lround(laid->highestM)) + " m above the ground at " +
                          std::to_string(std::lround(laid->speedMps)) + " m/s\n";
    const auto& voids = scene.terrain->tile()->tile.field().voids;
    if (voids.count > 0)
        summary += "voids: " + percent(voids.share) + " of the samples are filled, and " +
                   percent(laid->filledShare) +
                   " of the ground ahead of the flight; --show-voids colours it\n";
    return SceneTour{std::move(*laid), std::move(summary)};
}

foundation::Result<SceneTour> layRoadDrive(const SceneTerrain& scene, const simulation::TourTerrain& terrain,
                                           const std::string& file, double durationS)
{
    if (!scene.roads)
        return foundation::Error{file, "no roads to drive along",
                                 "name a network with the key roads of a .roam file, or give --eye pilot"};
    const osgRoads::core::RoadNetwork& network = scene.roads->network();
    const osgRoads::core::LaneRoute route =
        osgRoads::core::chooseDrive(network, osgRoads::core::LaneGraph(network),
                                    durationS * scenery::defaultSpeedMps(network) + kSpareWayM);
    if (route.legs.empty())
        return foundation::Error{file, "no lane for cars", "give --eye pilot to fly over it"};
    std::vector<simulation::WayPoint> way;
    for (const scenery::LanePathPoint& point : scenery::lanePath(*scene.roads, route))
        way.push_back({point.place, point.limitMps});
    auto laid = simulation::layDriveAlong(terrain, std::move(way), durationS);
    if (!laid) return foundation::Error{file, laid.error().what, laid.error().remedy};
    std::string summary = "drive: " + std::to_string(std::lround(route.lengthM)) + " m of lanes from road " +
                          network.roads[static_cast<std::size_t>(route.legs.front().lane.road)].id +
                          " on, at up to " + std::to_string(std::lround(laid->speedMps)) + " m/s\n";
    return SceneTour{std::move(*laid), std::move(summary)};
}

} // namespace

foundation::Result<SceneTour> layTourFor(const SceneTerrain& terrain, const PlayRequest& request,
                                         double durationS)
{
    const simulation::TourTerrain tourTerrain =
        ground::tourTerrainOf(terrain.terrain->tile()->tile, absoluteName(request.terrain.file));
    auto tour = isDrive(request)
                    ? layRoadDrive(terrain, tourTerrain, request.terrain.file.string(), durationS)
                    : layFlight(terrain, tourTerrain, durationS);
    if (!tour) return tour;
    for (simulation::GlobalAction& action : tour->tour.scenario.storyboard.init.globals)
        if (auto* const sky = std::get_if<simulation::EnvironmentAction>(&action))
            simulation::leaveToWorld(sky->environment,
                                     {terrain.air.sun.has_value(), terrain.air.visibilityM.has_value(),
                                      terrain.clouds.has_value()});
    return tour;
}

} // namespace trainer
