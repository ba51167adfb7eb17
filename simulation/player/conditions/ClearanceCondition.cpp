// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "simulation/player/conditions/EntityConditions.h"

namespace simulation
{
namespace
{

/// Lanes counted to the left without a gap at 0, seen towards greater s.
int lanePlace(int lane)
{
    return lane > 0 ? lane - 1 : lane;
}

/// Whether the lane of `other` counts: it lies in one of the ranges, and in the direction of the own traffic
/// unless opposite lanes count, too. Roads are taken to run the same way.
bool isInLanes(const RelativeClearanceCondition& condition, const RoadPlace& own, const RoadPlace& other)
{
    if (!condition.hasOppositeLanes && (own.lane > 0) != (other.lane > 0)) return false;
    const int left = (lanePlace(other.lane) - lanePlace(own.lane)) * (looksForward(own) ? 1 : -1);
    const auto holdsLane = [&](const RelativeClearanceCondition::Lanes& range)
    { return left >= range.from.value_or(left) && left <= range.to.value_or(left); };
    return condition.lanes.empty() || std::any_of(condition.lanes.begin(), condition.lanes.end(), holdsLane);
}

bool counts(const RelativeClearanceCondition& condition, const EntityState& other)
{
    return condition.entities.empty() || std::find(condition.entities.begin(), condition.entities.end(),
                                                   other.name) != condition.entities.end();
}

} // namespace

/// Without a road network the distance counts along the entity's own axis, and lanes do not count.
bool holdsFor(const RelativeClearanceCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const EntityState& own = (*facts.states)[entity];
    const DistanceMeasure measure{facts.roads ? DistanceFrame::road : DistanceFrame::entity,
                                  DistanceKind::longitudinal, condition.isFreespace};
    for (std::size_t i = 0; i < facts.states->size(); ++i)
    {
        const EntityState& other = (*facts.states)[i];
        if (i == entity || !other.isPresent || !counts(condition, other)) continue;
        if (own.place && other.place && !isInLanes(condition, *own.place, *other.place)) continue;
        const auto metres = distanceBetween(facts.body(entity), facts.body(i), measure, facts.roads);
        if (metres && *metres <= condition.forwardM && *metres >= -condition.backwardM) return false;
    }
    return true;
}

} // namespace simulation
