// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/LayDrive.h"

#include <algorithm>
#include <cmath>

#include "simulation/tour/DriveTiming.h"
#include "simulation/tour/GentleTrack.h"
#include "simulation/tour/TourScenario.h"

namespace simulation
{
namespace
{

constexpr double kStationSpacingM = 4.0;
constexpr double kSmallestDistanceM = 20.0;
/// The surface of a road that ends in the open wears off over its last 15 m; the front of the car is 4 m
/// before its reference point, the rear wheels at it.
constexpr double kWornM = 15.0, kFrontM = 5.0, kRearM = 1.0;
constexpr double kLargestShare = 0.1; ///< of a way, for each end

bool contains(const TourTerrain& terrain, const glm::dvec2& place)
{
    return place.x >= terrain.westM && place.x <= terrain.eastM && place.y >= terrain.southM &&
           place.y <= terrain.northM;
}

ScenarioObject car()
{
    Vehicle vehicle;
    vehicle.name = "car";
    vehicle.category = "car";
    vehicle.massKg = 1400.0;
    vehicle.box = {{1.35, 0.0, 0.75}, 4.4, 1.8, 1.5};
    vehicle.performance = {50.0, 5.0, 9.0};
    vehicle.frontAxle = Axle{0.6, 0.66, 1.54, 2.65, 0.33};
    vehicle.rearAxle = Axle{0.0, 0.66, 1.54, 0.0, 0.33};
    ScenarioObject object;
    object.name = "car";
    object.object = std::move(vehicle);
    return object;
}

/// A GeoPosition without height, a WorldPosition without z: on the ground.
void dropHeights(Scenario& scenario)
{
    auto& follow =
        std::get<FollowTrajectoryAction>(scenario.storyboard.init.privates.front().actions.front());
    for (Vertex& vertex : std::get<Polyline>(follow.trajectory.shape).vertices)
        if (auto* geo = std::get_if<GeoPosition>(&vertex.position))
            geo->heightM.reset();
        else
            std::get<WorldPosition>(vertex.position).zM.reset();
}

} // namespace

foundation::Result<Tour> layDrive(const TourTerrain& terrain, const DriveOptions& options)
{
    if (!contains(terrain, options.fromM) || !contains(terrain, options.toM))
        return foundation::Error{"drive", "a place beyond the terrain", "choose places on it"};
    if (!(glm::length(options.toM - options.fromM) >= kSmallestDistanceM) || !(options.durationS >= 1.0))
        return foundation::Error{"drive", "too short a way or time", "give 20 m and 1 s at least"};
    std::vector<WayPoint> way;
    for (const glm::dvec2& at : gentleTrack(terrain, options.fromM, options.toM, kStationSpacingM))
        way.push_back({{at, terrain.heightM(at.x, at.y)}, options.largestSpeedMps});
    std::vector<double> speed = limitsOn(way);
    speed.front() = std::min(speed.front(), options.startSpeedMps);
    const std::vector<PathVertex> vertices = timedVertices(way, reachable(way, speed), options.durationS);
    Tour tour;
    tour.speedMps = options.largestSpeedMps;
    tour.highlight = glm::dvec3(options.toM, terrain.heightM(options.toM.x, options.toM.y));
    tour.scenario = tourScenario(terrain, car(), vertices, "A drive over " + terrain.name());
    dropHeights(tour.scenario);
    return tour;
}

foundation::Result<Tour> layDriveAlong(const TourTerrain& terrain, std::vector<WayPoint> way,
                                       double durationS)
{
    double lengthM = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i)
        lengthM += glm::distance(way[i].place, way[i - 1].place);
    if (!(lengthM >= kSmallestDistanceM) || !(durationS >= 1.0))
        return foundation::Error{"drive", "too short a way or time", "give 20 m and 1 s at least"};
    const double wornM = std::min(kWornM, kLargestShare * lengthM);
    const glm::dvec3 begin = way.front().place, end = way.back().place;
    while (glm::distance(way.front().place, begin) < wornM + kRearM)
        way.erase(way.begin());
    while (glm::distance(way.back().place, end) < wornM + kFrontM)
        way.pop_back();
    std::vector<double> speed = limitsOn(way);
    speed.back() = 0.0;
    speed = reachable(way, speed);
    const std::vector<PathVertex> vertices = timedVertices(way, speed, durationS);
    Tour tour;
    tour.speedMps = *std::max_element(speed.begin(), speed.end());
    tour.highlight = way.back().place;
    tour.scenario = tourScenario(terrain, car(), vertices, "A drive over " + terrain.name());
    return tour;
}

} // namespace simulation
