// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/PositionSolver.h"

#include <cmath>
#include <numbers>

#include <foundation/Angle.h>

#include "simulation/player/LaneCount.h"
#include "simulation/player/ShapeSampling.h"
#include "simulation/road/RouteWay.h"

namespace simulation
{
std::optional<Placement> PositionSolver::place(const Position& position) const
{
    if (const auto* lane = std::get_if<LanePosition>(&position))
        return onRoad(_roads ? _roads->onLane(lane->roadId, lane->lane, lane->sM, lane->offsetM)
                             : std::nullopt,
                      lane->orientation);
    if (const auto* road = std::get_if<RoadPosition>(&position))
        return onRoad(_roads ? _roads->onTrack(road->roadId, road->sM, road->tM) : std::nullopt,
                      road->orientation);
    if (const auto* route = std::get_if<RoutePosition>(&position); route && !route->entity.empty())
        return placeAtEntity(*route);
    if (const auto* route = std::get_if<RoutePosition>(&position))
        return onRoad(_roads ? placeOnRoute(*_roads, *route) : std::nullopt, route->orientation);
    if (const auto* lane = std::get_if<RelativeLanePosition>(&position)) return placeRelative(*lane);
    if (const auto* road = std::get_if<RelativeRoadPosition>(&position)) return placeRelative(*road);
    if (const auto* object = std::get_if<RelativeObjectPosition>(&position)) return placeRelative(*object);
    if (const auto* world = std::get_if<RelativeWorldPosition>(&position)) return placeRelative(*world);
    if (const auto* trajectory = std::get_if<TrajectoryPosition>(&position))
        return placeOnTrajectory(*trajectory);
    if (!_frame->canPlace(position)) return std::nullopt;
    Placement placed = inWorld(_frame->place(position), orientationOf(position), 0.0);
    const auto* world = std::get_if<WorldPosition>(&position);
    if (placed.place && world && !world->zM)
    {
        placed.place->heightM = 0.0;
        placed.position = _roads->poseAt(*placed.place).position;
    }
    return placed;
}

std::optional<Placement> PositionSolver::placeAtEntity(const RoutePosition& position) const
{
    const EntityState* const base = _states(position.entity);
    if (!base) return std::nullopt;
    if (base->place) return onRoad(base->place, position.orientation);
    return inWorld(base->position, position.orientation, foundation::radiansOf(base->headingDeg));
}

std::optional<Placement> PositionSolver::placeOnTrajectory(const TrajectoryPosition& position) const
{
    std::optional<Placement> placed = simulation::placeOnTrajectory(position, *this);
    if (placed && _roads) placed->place = _roads->nearest(placed->position, placed->headingRad);
    return placed;
}

/// An orientation that is relative counts from the direction of the lane's traffic.
std::optional<Placement> PositionSolver::onRoad(const std::optional<RoadPlace>& place,
                                                const Orientation& orientation) const
{
    if (!place || !_roads) return std::nullopt;
    RoadPlace placed = *place;
    const double given = orientation.headingRad.value_or(0.0);
    if (orientation.isRelative)
        placed.relativeHeadingRad = foundation::wrappedRad(placed.relativeHeadingRad + given);
    else if (orientation.headingRad)
    {
        placed.relativeHeadingRad = 0.0;
        placed.relativeHeadingRad = foundation::wrappedRad(given - _roads->poseAt(placed).headingRad);
    }
    const RoadPose pose = _roads->poseAt(placed);
    return Placement{pose.position,
                     pose.headingRad,
                     orientation.pitchRad.value_or(0.0),
                     orientation.rollRad.value_or(0.0),
                     orientation.headingRad.has_value(),
                     placed};
}

Placement PositionSolver::inWorld(const glm::dvec3& point, const Orientation& orientation,
                                  double baseHeadingRad) const
{
    Placement placed;
    placed.position = point;
    placed.headingRad =
        orientation.headingRad.value_or(0.0) + (orientation.isRelative ? baseHeadingRad : 0.0);
    placed.pitchRad = orientation.pitchRad.value_or(0.0);
    placed.rollRad = orientation.rollRad.value_or(0.0);
    placed.hasHeading = orientation.headingRad.has_value();
    if (_roads) placed.place = _roads->nearest(point, placed.headingRad);
    return placed;
}

std::optional<Placement> PositionSolver::placeRelative(const RelativeLanePosition& position) const
{
    const EntityState* const base = _states(position.entity);
    if (!_roads || !base || !base->place) return std::nullopt;
    RoadPlace placed = *base->place;
    const int lane = lanesBeside(placed.lane, looksForward(placed) ? position.lanes : -position.lanes);
    const bool looksAhead = looksForward(placed);
    const bool isAgainstTraffic = _roads->runsForward(placed) != looksAhead;
    placed.relativeHeadingRad = looksAhead ? 0.0 : std::numbers::pi;
    placed.heightM = 0.0;
    if (!_roads->putOnLane(placed, 0, 0.0)) return std::nullopt;
    walk(*_roads, placed, position.dsM, {});
    if (isAgainstTraffic) placed.relativeHeadingRad += std::numbers::pi;
    if (!_roads->putOnLane(placed, lane, position.offsetM)) return std::nullopt;
    return onRoad(placed, position.orientation);
}

std::optional<Placement> PositionSolver::placeRelative(const RelativeRoadPosition& position) const
{
    const EntityState* const base = _states(position.entity);
    if (!_roads || !base || !base->place) return std::nullopt;
    const RoadPlace& from = *base->place;
    return onRoad(_roads->onTrack(_roads->roadAt(from).id, from.s + position.dsM, from.t + position.dtM),
                  position.orientation);
}

std::optional<Placement> PositionSolver::placeRelative(const RelativeObjectPosition& position) const
{
    const EntityState* const base = _states(position.entity);
    if (!base) return std::nullopt;
    const double heading = foundation::radiansOf(base->headingDeg);
    return inWorld(base->position +
                       base->bodyToLocal() * glm::dvec3(position.dxM, position.dyM, position.dzM),
                   position.orientation, heading);
}

std::optional<Placement> PositionSolver::placeRelative(const RelativeWorldPosition& position) const
{
    const EntityState* const base = _states(position.entity);
    if (!base) return std::nullopt;
    return inWorld(base->position + glm::dvec3(position.dxM, position.dyM, position.dzM),
                   position.orientation, foundation::radiansOf(base->headingDeg));
}

} // namespace simulation
