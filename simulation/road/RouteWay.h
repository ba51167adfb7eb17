// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/road/RoadWalk.h"
#include "simulation/scenario/Position.h"

namespace simulation
{

/// Returns the place of a waypoint; nothing: it is on no road of the network.
std::optional<RoadPlace> placeOfWaypoint(const RoadScene& roads, const FixedPosition& waypoint);

/// Returns the roads of a route: from each waypoint a way to the next by its strategy, with `draw` for what
/// is left to chance. Nothing: no way leads there.
std::optional<RoadWay> wayOfRoute(const RoadScene& roads, const Route& route, RandomDraw* draw = nullptr);

/// Returns the place so far along a route from its first waypoint, measured on the reference lines, on the
/// lane that is asked for. Nothing: it is not on the network.
std::optional<RoadPlace> placeOnRoute(const RoadScene& roads, const RoutePosition& position);

} // namespace simulation
