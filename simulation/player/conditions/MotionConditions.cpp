// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <glm/geometric.hpp>

#include "simulation/player/conditions/EntityConditions.h"

namespace simulation
{
namespace
{

constexpr double kStandStillMps = 1e-3;

/// A part of a vector in the frame of an entity: x forward, y left, z up; its length where no direction is
/// given.
double partOf(const glm::dvec3& vector, const EntityState& state, Direction direction)
{
    if (direction == Direction::total) return glm::length(vector);
    const glm::dvec3 local = glm::transpose(state.bodyToLocal()) * vector;
    if (direction == Direction::longitudinal) return local.x;
    return direction == Direction::lateral ? local.y : local.z;
}

double speedIn(const EntityState& state, Direction direction)
{
    return direction == Direction::total ? state.speedMps : partOf(state.velocity, state, direction);
}

void keep(std::optional<double>& since, bool isSo, double timeS)
{
    if (!isSo)
        since.reset();
    else if (!since)
        since = timeS;
}

} // namespace

void updateLasting(const EntityFacts& facts, std::vector<LastingFacts>& lasting)
{
    lasting.resize(facts.states->size());
    for (std::size_t i = 0; i < lasting.size(); ++i)
    {
        const EntityState& state = (*facts.states)[i];
        keep(lasting[i].standStillSinceS, std::fabs(state.speedMps) < kStandStillMps, facts.timeS);
        keep(lasting[i].endOfRoadSinceS, state.isAtEndOfRoad, facts.timeS);
        keep(lasting[i].offRoadSinceS,
             facts.roads && state.place && facts.roads->isOffRoad(*state.place, state.position), facts.timeS);
    }
}

bool holdsFor(const SpeedCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const EntityState& own = (*facts.states)[entity];
    double speed = speedIn(own, condition.direction);
    if (!condition.entity.empty())
    {
        const int other = facts.scenario->entityIndex(condition.entity);
        if (other < 0) return false;
        const EntityState& reference = (*facts.states)[static_cast<std::size_t>(other)];
        speed -= condition.direction == Direction::total
                     ? reference.speedMps
                     : partOf(reference.velocity, own, condition.direction);
    }
    return nearlyHolds(speed, condition.rule, condition.value);
}

bool holdsFor(const AccelerationCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const EntityState& own = (*facts.states)[entity];
    return nearlyHolds(partOf(own.acceleration, own, condition.direction), condition.rule, condition.value);
}

bool holdsFor(const LastingCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const LastingFacts& lasting = (*facts.lasting)[entity];
    const std::optional<double>& since =
        condition.kind == LastingCondition::Kind::standStill ? lasting.standStillSinceS
        : condition.kind == LastingCondition::Kind::offroad  ? lasting.offRoadSinceS
                                                             : lasting.endOfRoadSinceS;
    return since && facts.timeS - *since > condition.seconds + 1e-9;
}

} // namespace simulation
