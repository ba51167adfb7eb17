// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Scenario.h"
#include "simulation/tour/RideConditions.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace osgSession::core
{

/// The name of the only entity of a ride.
inline constexpr const char* kRideEntity = "Ego";

/// Where a ride begins, in the scene's east-north-up. Units: metres, radians counter-clockwise from east,
/// m/s.
struct RideBegin
{
    glm::dvec3 place{0.0};
    double headingRad = 0.0;
    double speedMps = 0.0;
};

/// The scenario of one road vehicle that begins somewhere under some sky. `origin`: of the scene.
simulation::Scenario driveScenario(const simulation::RoadVehicleData& data, const RideBegin& begin,
                                   const std::optional<simulation::Geodetic>& origin,
                                   const simulation::RideConditions& conditions);

/// The same of an aircraft.
simulation::Scenario flightScenario(const RideBegin& begin, const std::optional<simulation::Geodetic>& origin,
                                    const simulation::RideConditions& conditions);

} // namespace osgSession::core
