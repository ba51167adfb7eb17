// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "simulation/control/driver/Driver.h"
#include "simulation/control/scenario/VehicleControllers.h"

namespace simulation
{
namespace
{

constexpr double kTownMps = 50.0 / 3.6; ///< where neither scenario nor road gives a speed
constexpr double kStraightM = 20'000.0; ///< ahead of a driver who has no way
constexpr double kLeastPieceM = 0.2;

constexpr std::string_view kDriverProperties[] = {
    "speed", "lateralAcceleration", "acceleration", "deceleration", "headway", "gap", "wait", "overtakes"};

DriverPath pathOf(const MotionStart& start)
{
    std::vector<DriverPoint> points;
    for (const AheadPoint& point : start.way.points)
        if (points.empty() ||
            glm::distance(glm::dvec2(points.back().place), glm::dvec2(point.place)) > kLeastPieceM)
            points.push_back({point.place, point.limitMps.value_or(1e9)});
    if (points.size() < 2)
    {
        const glm::dvec3 ahead = start.state.bodyToLocal()[0];
        points = {{start.state.position}, {start.state.position + kStraightM * ahead}};
    }
    std::vector<DriverStop> stops;
    for (const AheadStop& stop : start.way.stops)
        stops.push_back({stop.atM, stop.signal});
    return DriverPath(points, std::move(stops));
}

/// A speed that the scenario gave comes before the limits of the roads.
double wantedSpeed(const MotionStart& start)
{
    constexpr double kMovesMps = 0.1;
    if (start.state.speedMps > kMovesMps) return start.state.speedMps;
    const bool hasLimits = std::any_of(start.way.points.begin(), start.way.points.end(),
                                       [](const AheadPoint& point) { return point.limitMps.has_value(); });
    return hasLimits ? 1e9 : kTownMps;
}

foundation::Result<std::unique_ptr<VehicleController>> makeDriver(ControllerProperties& properties,
                                                                  const ControllerSite& site)
{
    DriverSettings settings;
    const double speed = properties.number("speed", 0.0, 0.1, 100.0);
    settings.lateralMps2 = properties.number("lateralAcceleration", settings.lateralMps2, 0.2, 10.0);
    settings.accelerateMps2 = properties.number("acceleration", settings.accelerateMps2, 0.1, 10.0);
    settings.brakeMps2 = properties.number("deceleration", settings.brakeMps2, 0.1, 10.0);
    settings.headwayS = properties.number("headway", settings.headwayS, 0.1, 10.0);
    settings.gapM = properties.number("gap", settings.gapM, 0.5, 50.0);
    settings.waitS = properties.number("wait", settings.waitS, 0.0, 600.0);
    settings.overtakes = properties.flag("overtakes", settings.overtakes);
    if (properties.error()) return *properties.error();
    const auto* const road = dynamic_cast<const RoadVehicle*>(&site.vehicle);
    if (!road)
        return foundation::Error{"property vehicle", "a Driver drives road vehicles alone",
                                 "give a data file of a road vehicle, or write Autopilot"};
    if (!site.start) return std::unique_ptr<VehicleController>();
    settings.speedMps = speed > 0.0 ? speed : wantedSpeed(*site.start);
    return std::unique_ptr<VehicleController>(std::make_unique<Driver>(*road, pathOf(*site.start), settings));
}

} // namespace

VehicleControllerMaker driverController()
{
    return {"Driver", kDriverProperties, makeDriver};
}

} // namespace simulation
