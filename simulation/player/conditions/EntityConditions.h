// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "simulation/player/EntityDistance.h"
#include "simulation/player/PositionSolver.h"
#include "simulation/scenario/EntityCondition.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Since when something is so; nothing: it is not.
struct LastingFacts
{
    std::optional<double> standStillSinceS, offRoadSinceS, endOfRoadSinceS;
};

/// What conditions on entities ask about: the entities of one step.
struct EntityFacts
{
    const Scenario* scenario = nullptr;
    const std::vector<EntityState>* states = nullptr; ///< in the order of the scenario
    const std::vector<LastingFacts>* lasting = nullptr;
    const RoadScene* roads = nullptr; ///< null without a road network
    const PositionSolver* positions = nullptr;
    double timeS = 0.0;

    MeasuredBody body(std::size_t index) const
    {
        return {&(*states)[index], scenario->entities[index].box()};
    }
};

/// Notes since when entities stand still, are off the road or at its end. Call it once a step.
void updateLasting(const EntityFacts& facts, std::vector<LastingFacts>& lasting);

/// Whether a condition holds for one of its triggering entities, or for all. Values are equal within 1e-6.
bool holdsFor(const EntityCondition& condition, const EntityFacts& facts);

/// Returns the triggering entities for which a condition holds, in the order of the condition.
std::vector<std::string> triggeringEntities(const EntityCondition& condition, const EntityFacts& facts);

/// Whether `left rule right`, equal within 1e-6.
bool nearlyHolds(double left, Rule rule, double right);

// Conditions on one triggering entity.
bool holdsFor(const TimeHeadwayCondition& condition, const EntityFacts& facts,
              std::size_t entity); // TimeConditions.cpp
bool holdsFor(const TimeToCollisionCondition& condition, const EntityFacts& facts,
              std::size_t entity); // TimeConditions.cpp
bool holdsFor(const DistanceCondition& condition, const EntityFacts& facts,
              std::size_t entity); // DistanceConditions.cpp
bool holdsFor(const TraveledDistanceCondition& condition, const EntityFacts& facts,
              std::size_t entity); // DistanceConditions.cpp
bool holdsFor(const ReachPositionCondition& condition, const EntityFacts& facts,
              std::size_t entity); // DistanceConditions.cpp
bool holdsFor(const CollisionCondition& condition, const EntityFacts& facts,
              std::size_t entity); // DistanceConditions.cpp
bool holdsFor(const SpeedCondition& condition, const EntityFacts& facts,
              std::size_t entity); // MotionConditions.cpp
bool holdsFor(const AccelerationCondition& condition, const EntityFacts& facts,
              std::size_t entity); // MotionConditions.cpp
bool holdsFor(const LastingCondition& condition, const EntityFacts& facts,
              std::size_t entity); // MotionConditions.cpp
bool holdsFor(const AngleCondition& condition, const EntityFacts& facts,
              std::size_t entity); // AngleConditions.cpp
bool holdsFor(const RelativeClearanceCondition& condition, const EntityFacts& facts,
              std::size_t entity); // ClearanceCondition.cpp

} // namespace simulation
