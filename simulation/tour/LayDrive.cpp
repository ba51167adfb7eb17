// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/LayDrive.h"

#include <algorithm>
#include <cmath>

#include "simulation/tour/GentleTrack.h"
#include "simulation/tour/TourScenario.h"

namespace simulation
{
namespace
{

constexpr double kSpacingM = 4.0;
constexpr double kSidewaysMps2 = 2.0;
constexpr double kAlongMps2 = 1.5;
constexpr double kDriveVertexEveryS = 0.5;
constexpr double kSmallestDistanceM = 20.0;

bool contains(const TourTerrain& terrain, const glm::dvec2& place)
{
    return place.x >= terrain.westM && place.x <= terrain.eastM && place.y >= terrain.southM &&
           place.y <= terrain.northM;
}

/// Of the circle through three places; 0 on a line.
double curvature(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const glm::dvec2 ab = b - a;
    const glm::dvec2 bc = c - b;
    const double product = glm::length(ab) * glm::length(bc) * glm::length(c - a);
    return product > 0.0 ? 2.0 * std::fabs(ab.x * bc.y - ab.y * bc.x) / product : 0.0;
}

std::vector<double> speeds(const std::vector<glm::dvec2>& track, const DriveOptions& options)
{
    std::vector<double> speed(track.size(), options.largestSpeedMps);
    for (std::size_t i = 1; i + 1 < track.size(); ++i)
    {
        const double bend = curvature(track[i - 1], track[i], track[i + 1]);
        if (bend > 0.0) speed[i] = std::min(speed[i], std::sqrt(kSidewaysMps2 / bend));
    }
    speed.front() = std::min(speed.front(), options.startSpeedMps);
    const auto reachable = [&](std::size_t from, std::size_t to)
    {
        const double gained = 2.0 * kAlongMps2 * glm::length(track[to] - track[from]);
        return std::sqrt(speed[from] * speed[from] + gained);
    };
    for (std::size_t i = 1; i < speed.size(); ++i)
        speed[i] = std::min(speed[i], reachable(i - 1, i));
    for (std::size_t i = speed.size() - 1; i-- > 0;)
        speed[i] = std::min(speed[i], reachable(i + 1, i));
    return speed;
}

/// Places at equal times, until the track or the time is over.
std::vector<PathVertex> timedVertices(const TourTerrain& terrain, const std::vector<glm::dvec2>& track,
                                      const std::vector<double>& speed, double durationS)
{
    std::vector<PathVertex> vertices;
    double time = 0.0;
    for (std::size_t i = 0; i + 1 < track.size(); ++i)
    {
        const double mean = std::max(0.5, 0.5 * (speed[i] + speed[i + 1]));
        const double takes = glm::length(track[i + 1] - track[i]) / mean;
        for (double due = static_cast<double>(vertices.size()) * kDriveVertexEveryS;
             due < time + takes && due <= durationS;
             due = static_cast<double>(vertices.size()) * kDriveVertexEveryS)
        {
            const glm::dvec2 at = glm::mix(track[i], track[i + 1], (due - time) / takes);
            vertices.push_back({due, glm::dvec3(at, terrain.heightM(at.x, at.y)), {}});
        }
        time += takes;
    }
    return vertices;
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
    const std::vector<glm::dvec2> track = gentleTrack(terrain, options.fromM, options.toM, kSpacingM);
    const std::vector<PathVertex> vertices =
        timedVertices(terrain, track, speeds(track, options), options.durationS);
    Tour tour;
    tour.speedMps = options.largestSpeedMps;
    tour.highlight = glm::dvec3(options.toM, terrain.heightM(options.toM.x, options.toM.y));
    tour.scenario = tourScenario(terrain, car(), vertices, "A drive over " + terrain.name());
    dropHeights(tour.scenario);
    return tour;
}

} // namespace simulation
