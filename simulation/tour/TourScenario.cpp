// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/TourScenario.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/environment/SunPosition.h"

namespace simulation
{
namespace
{

constexpr double kWantedElevationDeg = 33.0;
constexpr double kWantedSideDeg = 115.0; ///< between flight and sun
constexpr int kMinutesPerTry = 15;
constexpr double kClearDayM = 60'000.0; ///< of sight

/// Smaller is better.
double lightFault(const SunDirection& sun, double compassDeg)
{
    const double side = std::fabs(foundation::wrappedDeg(sun.azimuthDeg - compassDeg));
    const double elevation = (sun.elevationDeg - kWantedElevationDeg) / 15.0;
    const double aside = (side - kWantedSideDeg) / 60.0;
    return elevation * elevation + aside * aside;
}

Position geoOrWorld(const TourTerrain& terrain, const std::optional<LocalFrame>& frame,
                    const PathVertex& vertex)
{
    if (!terrain.origin)
        return WorldPosition{{}, vertex.position.x, vertex.position.y, vertex.position.z, vertex.orientation};
    const Geodetic geodetic = frame->geodeticFromLocal(vertex.position);
    return GeoPosition{{}, geodetic.latitudeDeg, geodetic.longitudeDeg, geodetic.heightM,
                       {}, vertex.orientation};
}

} // namespace

Environment tourEnvironment(const TourTerrain& terrain, double headingRad)
{
    const double compassDeg = 90.0 - foundation::degreesOf(headingRad);
    Environment environment;
    environment.name = "tour";
    environment.weather.emplace();
    environment.weather->cloudState = "zeroOktas";
    environment.weather->fogVisualRangeM = kClearDayM;
    const bool isSouth = terrain.origin && terrain.origin->latitudeDeg < 0.0;
    const DateTime midnight = *parseDateTime(isSouth ? "2024-12-21T00:00:00Z" : "2024-06-21T00:00:00Z");
    DateTime best = midnight.plusSeconds(36'000.0);
    if (!terrain.origin)
        environment.weather->sun = Sun{foundation::radiansOf(compassDeg + kWantedSideDeg),
                                       foundation::radiansOf(kWantedElevationDeg),
                                       {},
                                       {}};
    else
    {
        double smallest = 1e300;
        for (int minutes = 0; minutes < 24 * 60; minutes += kMinutesPerTry)
        {
            const DateTime candidate = midnight.plusSeconds(60.0 * minutes);
            const double fault =
                lightFault(sunDirection(candidate, terrain.origin->latitudeDeg, terrain.origin->longitudeDeg),
                           compassDeg);
            if (fault >= smallest) continue;
            smallest = fault;
            best = candidate;
        }
    }
    environment.timeOfDay = TimeOfDay{best, false};
    return environment;
}

Scenario tourScenario(const TourTerrain& terrain, ScenarioObject ownship,
                      const std::vector<PathVertex>& vertices, const std::string& description)
{
    std::optional<LocalFrame> frame;
    if (terrain.origin) frame.emplace(*terrain.origin);
    Scenario scenario;
    scenario.header = {1, 3, "2024-01-01T00:00:00", "osgTrainer", description};
    scenario.roadNetwork.sceneGraphFile = terrain.sceneFile;

    Polyline polyline;
    for (const PathVertex& vertex : vertices)
        polyline.vertices.push_back({{}, vertex.parameter, geoOrWorld(terrain, frame, vertex)});
    FollowTrajectoryAction follow;
    follow.trajectory.name = "tour";
    follow.trajectory.shape = std::move(polyline);
    follow.timing = Timing{};
    follow.mode = FollowingMode::follow;

    const glm::dvec3 way = vertices.back().position - vertices.front().position;
    scenario.storyboard.init.globals.push_back(
        EnvironmentAction{{}, tourEnvironment(terrain, std::atan2(way.y, way.x))});
    scenario.storyboard.init.privates.push_back({{}, ownship.name, {std::move(follow)}});
    scenario.entities.push_back(std::move(ownship));

    const Condition end{{},
                        "end",
                        0.0,
                        ConditionEdge::none,
                        SimulationTimeCondition{vertices.back().parameter, Rule::greaterOrEqual}};
    scenario.storyboard.stopTrigger = Trigger{{}, {ConditionGroup{{end}}}};
    return scenario;
}

} // namespace simulation
