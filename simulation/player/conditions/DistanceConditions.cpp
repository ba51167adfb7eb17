// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "simulation/player/conditions/EntityConditions.h"

namespace simulation
{
namespace
{

bool isOfType(const ScenarioObject& object, const std::string& type)
{
    if (type.empty()) return true;
    if (std::holds_alternative<Vehicle>(object.object)) return type == "vehicle";
    if (std::holds_alternative<Pedestrian>(object.object)) return type == "pedestrian";
    return type == "miscellaneous" || type == "external";
}

} // namespace

bool holdsFor(const DistanceCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    std::optional<double> metres;
    if (const auto* name = std::get_if<std::string>(&condition.target))
    {
        const int other = facts.scenario->entityIndex(*name);
        if (other < 0) return false;
        metres = distanceBetween(facts.body(entity), facts.body(static_cast<std::size_t>(other)),
                                 condition.measure, facts.roads);
    }
    else if (const auto placed = facts.positions->place(std::get<Position>(condition.target)))
    {
        EntityState point;
        point.position = placed->position;
        point.place = placed->place;
        metres = distanceBetween(facts.body(entity), {&point, {}}, condition.measure, facts.roads);
    }
    return metres && nearlyHolds(std::fabs(*metres), condition.rule, condition.metres);
}

bool holdsFor(const TraveledDistanceCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    return (*facts.states)[entity].odometerM >= condition.metres;
}

bool holdsFor(const ReachPositionCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const auto placed = facts.positions->place(condition.position);
    return placed &&
           glm::distance(placed->position, (*facts.states)[entity].position) <= condition.toleranceM;
}

bool holdsFor(const CollisionCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    const std::vector<int>& others = (*facts.states)[entity].collidesWith;
    if (!condition.entity.empty())
        return std::find(others.begin(), others.end(), facts.scenario->entityIndex(condition.entity)) !=
               others.end();
    return std::any_of(
        others.begin(), others.end(),
        [&](int other)
        { return isOfType(facts.scenario->entities[static_cast<std::size_t>(other)], condition.type); });
}

} // namespace simulation
