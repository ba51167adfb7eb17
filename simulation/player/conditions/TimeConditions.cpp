// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include "simulation/player/conditions/EntityConditions.h"

namespace simulation
{
namespace
{

constexpr double kLeastSpeedMps = 1e-6;

/// The speed at which the distance to the other shrinks.
double closingSpeed(const EntityState& own, const EntityState& other, const DistanceMeasure& measure)
{
    if (measure.kind == DistanceKind::euclidean)
    {
        const glm::dvec3 between = other.position - own.position;
        const double metres = glm::length(between);
        return metres > 0.0 ? glm::dot(own.velocity - other.velocity, between) / metres : 0.0;
    }
    const double heading = foundation::radiansOf(own.headingDeg);
    const glm::dvec3 forward(std::cos(heading), std::sin(heading), 0.0);
    const glm::dvec3 left(-forward.y, forward.x, 0.0);
    return glm::dot(own.velocity - other.velocity, measure.kind == DistanceKind::lateral ? left : forward);
}

} // namespace

/// Not for an entity that is behind, nor while the own one stands or drives backwards.
bool holdsFor(const TimeHeadwayCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const int other = facts.scenario->entityIndex(condition.entity);
    if (other < 0) return false;
    const MeasuredBody own = facts.body(entity);
    const auto metres =
        distanceBetween(own, facts.body(static_cast<std::size_t>(other)), condition.measure, facts.roads);
    if (!metres || *metres < 0.0 || own.state->speedMps < kLeastSpeedMps) return false;
    return nearlyHolds(*metres / own.state->speedMps, condition.rule, condition.seconds);
}

/// Not for what is behind, nor while the distance does not shrink.
bool holdsFor(const TimeToCollisionCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    MeasuredBody target;
    EntityState point;
    if (const auto* name = std::get_if<std::string>(&condition.target))
    {
        const int other = facts.scenario->entityIndex(*name);
        if (other < 0) return false;
        target = facts.body(static_cast<std::size_t>(other));
    }
    else
    {
        const auto placed = facts.positions->place(std::get<Position>(condition.target));
        if (!placed) return false;
        point.position = placed->position;
        point.place = placed->place;
        target.state = &point;
    }
    const MeasuredBody own = facts.body(entity);
    const auto metres = distanceBetween(own, target, condition.measure, facts.roads);
    const double closing = closingSpeed(*own.state, *target.state, condition.measure);
    if (!metres || *metres < 0.0 || closing < kLeastSpeedMps) return false;
    return nearlyHolds(*metres / closing, condition.rule, condition.seconds);
}

} // namespace simulation
