// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/conditions/EntityConditions.h"

#include <cmath>
#include <type_traits>

namespace simulation
{
namespace
{

constexpr double kSameValue = 1e-6;

bool holdsForEntity(const EntityConditionContent& content, const EntityFacts& facts, std::size_t entity)
{
    return std::visit(
        [&](const auto& condition)
        {
            if constexpr (std::is_same_v<std::decay_t<decltype(condition)>, Unsupported>)
                return false;
            else
                return holdsFor(condition, facts, entity);
        },
        content);
}

bool holdsForNamed(const EntityConditionContent& content, const EntityFacts& facts, const std::string& name)
{
    const int entity = facts.scenario->entityIndex(name);
    return entity >= 0 && (*facts.states)[static_cast<std::size_t>(entity)].isPresent &&
           holdsForEntity(content, facts, static_cast<std::size_t>(entity));
}

} // namespace

bool nearlyHolds(double left, Rule rule, double right)
{
    return holds(std::fabs(left - right) < kSameValue ? right : left, rule, right);
}

std::vector<std::string> triggeringEntities(const EntityCondition& condition, const EntityFacts& facts)
{
    std::vector<std::string> triggering;
    for (const std::string& name : condition.entities)
        if (facts.states && holdsForNamed(condition.content, facts, name)) triggering.push_back(name);
    return triggering;
}

bool holdsFor(const EntityCondition& condition, const EntityFacts& facts)
{
    if (!facts.states) return false;
    bool all = !condition.entities.empty();
    for (const std::string& name : condition.entities)
    {
        const bool holds = holdsForNamed(condition.content, facts, name);
        if (holds && !condition.isForAll) return true;
        all = all && holds;
    }
    return condition.isForAll && all;
}

} // namespace simulation
