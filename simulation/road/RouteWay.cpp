// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/RouteWay.h"

namespace simulation
{

std::optional<RoadPlace> placeOfWaypoint(const RoadScene& roads, const FixedPosition& waypoint)
{
    if (const auto* lane = std::get_if<LanePosition>(&waypoint))
        return roads.onLane(lane->roadId, lane->lane, lane->sM, lane->offsetM);
    if (const auto* road = std::get_if<RoadPosition>(&waypoint))
        return roads.onTrack(road->roadId, road->sM, road->tM);
    if (const auto* world = std::get_if<WorldPosition>(&waypoint))
        return roads.nearest({world->xM, world->yM, world->zM.value_or(0.0)},
                             world->orientation.headingRad.value_or(0.0));
    return std::nullopt;
}

std::optional<RoadWay> wayOfRoute(const RoadScene& roads, const Route& route, RandomDraw* draw)
{
    RoadWay way;
    std::optional<RoadPlace> from;
    for (std::size_t i = 0; i < route.waypoints.size(); ++i)
    {
        const std::optional<RoadPlace> to = placeOfWaypoint(roads, route.waypoints[i]);
        if (!to) return std::nullopt;
        if (from)
        {
            const std::optional<RoadWay> part =
                wayBetween(roads, *from, *to,
                           i < route.strategies.size() ? route.strategies[i] : RouteStrategy::shortest, draw);
            if (!part) return std::nullopt;
            way.insert(way.end(), part->begin() + (way.empty() ? 0 : 1), part->end());
        }
        from = to;
    }
    return way;
}

std::optional<RoadPlace> placeOnRoute(const RoadScene& roads, const RoutePosition& position)
{
    if (position.route.waypoints.empty()) return std::nullopt;
    std::optional<RoadPlace> place = placeOfWaypoint(roads, position.route.waypoints.front());
    if (!place) return std::nullopt;
    const int lane = position.lane.value_or(place->lane);
    const RoadWay way = wayOfRoute(roads, position.route).value_or(RoadWay{});
    // The centre lane lies on the reference line, along which a route is measured.
    const double towards = place->relativeHeadingRad;
    if (!roads.putOnLane(*place, 0, 0.0)) return std::nullopt;
    place->relativeHeadingRad = towards;
    walk(roads, *place, position.pathM, way);
    if (!roads.putOnLane(*place, lane, position.offsetM)) return std::nullopt;
    return place;
}

} // namespace simulation
