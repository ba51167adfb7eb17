// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "simulation/road/RoadWalk.h"

namespace simulation
{

/// A place on the way of an entity, and the speed that is allowed there; nothing: none is told. Frame: the
/// scene's.
struct AheadPoint
{
    glm::dvec3 place{0.0};
    std::optional<double> limitMps{};
};

/// A line on the way where one may have to stop.
struct AheadStop
{
    double atM = 0.0;   ///< along the way
    std::string signal; ///< id of the traffic light; empty: a stop sign
};

/// Where an entity goes by itself: along its lane or its trajectory.
struct WayAhead
{
    std::vector<AheadPoint> points; ///< about a metre apart; fewer than two: there is no way
    std::vector<AheadStop> stops;   ///< ascending
};

/// Returns the way that walk() takes from a place, up to a length or the end of the road. Cost: about 2 µs a
/// metre.
WayAhead wayAlongLane(const RoadScene& roads, RoadPlace place, const RoadWay& way,
                      std::optional<RandomDraw> turns, double lengthM);

} // namespace simulation
