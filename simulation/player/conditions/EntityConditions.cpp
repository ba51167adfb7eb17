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

} // namespace

bool nearlyHolds(double left, Rule rule, double right)
{
    return holds(std::fabs(left - right) < kSameValue ? right : left, rule, right);
}

bool holdsFor(const EntityCondition& condition, const EntityFacts& facts)
{
    if (!facts.states) return false;
    bool all = !condition.entities.empty();
    for (const std::string& name : condition.entities)
    {
        const int entity = facts.scenario->entityIndex(name);
        const bool holds = entity >= 0 && (*facts.states)[static_cast<std::size_t>(entity)].isPresent &&
                           holdsForEntity(condition.content, facts, static_cast<std::size_t>(entity));
        if (holds && !condition.isForAll) return true;
        all = all && holds;
    }
    return condition.isForAll && all;
}

} // namespace simulation
